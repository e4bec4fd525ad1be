#pragma once

#include <cstdint>

namespace lodtest {

/// SplitMix64: the same numbers from every compiler and library, so that a failure can be repeated
/// from the seed in its message.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    /// Uniform in [low, high).
    double in(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }
    /// Uniform in 0..count - 1. Requires count > 0.
    int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }

  private:
    std::uint64_t state_;
};

}  // namespace lodtest
