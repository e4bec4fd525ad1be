#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lodlab/core/base/bit_cast.hpp"
#include "lodlab/core/math/linear.hpp"

namespace lod {

/// FNV-1a over the bits of numbers, low bytes first, the same on every machine.
class BitHash {
  public:
    void add(double number) { add_bits(bit_cast<std::uint64_t>(number)); }
    void add(std::int32_t number) { add_bits(bit_cast<std::uint32_t>(number)); }
    void add(std::uint64_t number) { add_bits(number); }
    template <int Rows, int Cols>
    void add(const FixedMatrix<Rows, Cols>& numbers) {
        for (const double number : numbers) add(number);
    }
    void add(const Quaternion& q) { add(q.coeffs()); }
    void add(std::string_view text) {
        for (const char byte : text) add_bits(static_cast<std::uint8_t>(byte));
    }
    template <class List>
    void add_all(const List& list) {
        for (const auto& entry : list) add(entry);
    }

    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    template <class Bits>
    void add_bits(Bits bits) {
        for (std::size_t shift = 0; shift < 8 * sizeof bits; shift += 8) {
            value_ ^= (bits >> shift) & 0xff;
            value_ *= 1099511628211ULL;
        }
    }

    std::uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace lod
