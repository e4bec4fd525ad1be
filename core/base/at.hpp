#pragma once

#include <cstddef>
#include <cstdint>

namespace lod {

/// A number of something, as an index into a container. Requires i >= 0.
[[nodiscard]] constexpr std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

}  // namespace lod
