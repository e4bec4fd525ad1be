#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lod::detail {

/// The numbers of all bits of a mask of 64.
alignas(64) inline constexpr std::array<std::uint8_t, 64> all_bit_numbers = [] {
    std::array<std::uint8_t, 64> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::uint8_t>(i);
    return numbers;
}();

/// The numbers of the bits that a byte has, from its lowest byte on one after the other.
inline constexpr std::array<std::uint64_t, 256> bit_numbers = [] {
    std::array<std::uint64_t, 256> numbers{};
    for (std::size_t byte = 0; byte < numbers.size(); ++byte)
        for (std::uint64_t bit = 0, at = 0; bit < 8; ++bit)
            if (byte >> bit & 1) numbers[byte] |= bit << (8 * at++);
    return numbers;
}();

}  // namespace lod::detail
