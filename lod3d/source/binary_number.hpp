#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>

#include "lodlab/core/base/bit_cast.hpp"

namespace lod3d {

/// The number whose bytes stand at a place of a file, in the file's order of bytes, on a machine of
/// any. Requires: so many bytes there.
template <class Number>
[[nodiscard]] Number binary_number(std::string_view bytes, std::size_t place,
                                   std::endian order = std::endian::little) {
    std::array<char, sizeof(Number)> own;
    std::memcpy(own.data(), bytes.data() + place, own.size());
    if (order != std::endian::native) std::reverse(own.begin(), own.end());
    return lod::bit_cast<Number>(own);
}

}  // namespace lod3d
