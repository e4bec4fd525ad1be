#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace lod {

/// A part of a list.
struct Range {
    std::int32_t first = 0;
    std::int32_t count = 0;
    friend bool operator==(const Range&, const Range&) = default;

    template <class T>
    [[nodiscard]] std::span<const T> of(std::span<const T> list) const {
        return list.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
    }
};

}  // namespace lod
