#pragma once

#include <cmath>
#include <cstddef>

#include "lodlab/core/base/bits.hpp"

namespace lod {

/// N single-precision numbers that are computed side by side, four to a register of every machine
/// that has such: each number sees the same operations, rounded in the same way, whatever the
/// instruction set. Sums over the numbers have one fixed order.
template <int N>
struct Lanes {
    static_assert(N % 4 == 0);
    using Four = float __attribute__((vector_size(16)));
    static constexpr int fours = N / 4;

    Four part[fours];

    LOD_INLINE static Lanes all(float value) {
        Lanes result;
        for (Four& four : result.part) four = Four{value, value, value, value};
        return result;
    }

    [[nodiscard]] LOD_INLINE float operator[](std::size_t i) const { return part[i / 4][i % 4]; }
    LOD_INLINE void set(std::size_t i, float value) { part[i / 4][i % 4] = value; }

    LOD_INLINE Lanes& operator+=(const Lanes& b) {
        for (int i = 0; i < fours; ++i) part[i] += b.part[i];
        return *this;
    }
    LOD_INLINE Lanes& operator-=(const Lanes& b) {
        for (int i = 0; i < fours; ++i) part[i] -= b.part[i];
        return *this;
    }
    LOD_INLINE Lanes& operator*=(const Lanes& b) {
        for (int i = 0; i < fours; ++i) part[i] *= b.part[i];
        return *this;
    }
    LOD_INLINE Lanes& operator/=(const Lanes& b) {
        for (int i = 0; i < fours; ++i) part[i] /= b.part[i];
        return *this;
    }
    LOD_INLINE friend Lanes operator+(Lanes a, const Lanes& b) { return a += b; }
    LOD_INLINE friend Lanes operator-(Lanes a, const Lanes& b) { return a -= b; }
    LOD_INLINE friend Lanes operator*(Lanes a, const Lanes& b) { return a *= b; }
    LOD_INLINE friend Lanes operator/(Lanes a, const Lanes& b) { return a /= b; }

    /// The smaller and the larger, number by number.
    LOD_INLINE friend Lanes lower(Lanes a, const Lanes& b) {
        for (int i = 0; i < fours; ++i) a.part[i] = b.part[i] < a.part[i] ? b.part[i] : a.part[i];
        return a;
    }
    LOD_INLINE friend Lanes upper(Lanes a, const Lanes& b) {
        for (int i = 0; i < fours; ++i) a.part[i] = a.part[i] < b.part[i] ? b.part[i] : a.part[i];
        return a;
    }
    /// Rounded exactly, as IEEE 754 has it: never by an approximate instruction.
    LOD_INLINE friend Lanes square_root(Lanes a) {
        for (Four& four : a.part)
            for (int i = 0; i < 4; ++i) four[i] = std::sqrt(four[i]);
        return a;
    }

    [[nodiscard]] LOD_INLINE float sum() const {
        Four total = part[0];
        for (int i = 1; i < fours; ++i) total += part[i];
        return (total[0] + total[2]) + (total[1] + total[3]);
    }
    [[nodiscard]] LOD_INLINE float most() const {
        float result = (*this)[0];
        for (std::size_t i = 1; i < N; ++i) result = result < (*this)[i] ? (*this)[i] : result;
        return result;
    }
};

}  // namespace lod
