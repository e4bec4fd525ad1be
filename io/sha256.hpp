#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "lodlab/core/base/bit_cast.hpp"

namespace io {

/// SHA-256 (FIPS 180-4) of bytes that come bit by bit: names of what must never be mistaken.
class Sha256 {
  public:
    void add(const void* bytes, std::size_t count);
    /// A text with its length, so that two texts are not one.
    void add(std::string_view text);
    void add(double number) { add_word(lod::bit_cast<std::uint64_t>(number)); }
    void add(std::int64_t number) { add_word(static_cast<std::uint64_t>(number)); }
    void add(int number) { add(static_cast<std::int64_t>(number)); }

    /// 64 hexadecimal digits. Ends the text: nothing may be added after it.
    [[nodiscard]] std::string hexadecimal();

  private:
    void add_word(std::uint64_t word);
    void digest(const unsigned char* block);

    std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<unsigned char, 64> block_{};
    std::size_t in_block_ = 0;
    std::uint64_t bytes_ = 0;
};

/// Of a whole text.
[[nodiscard]] std::string sha256(std::string_view text);

}  // namespace io
