#pragma once

#include <cstdint>

namespace lod {

/// Random numbers that are the same everywhere for the same seed (splitmix64; Steele, Lea and
/// Flood 2014).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next_bits() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [0, 1).
    double next() { return static_cast<double>(next_bits() >> 11) * 0x1p-53; }
    /// In [low, high).
    double next(double low, double high) { return low + (high - low) * next(); }

  private:
    std::uint64_t state_;
};

}  // namespace lod
