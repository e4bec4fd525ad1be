#pragma once

#include <cstdint>

#include "lodlab/core/base/lanes.hpp"
#include "lodlab/core/tree/family_tests.hpp"

namespace lod::detail {

using Integers = std::int32_t __attribute__((vector_size(16)));

/// Bit 8 i + k of what it returns is bit 8 k + i of x.
inline std::uint64_t transposed(std::uint64_t x) {
    const auto swapped = [](std::uint64_t bits, int by, std::uint64_t mask) {
        const std::uint64_t change = (bits ^ (bits >> by)) & mask;
        return bits ^ change ^ (change << by);
    };
    x = swapped(x, 7, 0x00aa00aa00aa00aa);
    x = swapped(x, 14, 0x0000cccc0000cccc);
    return swapped(x, 28, 0x00000000f0f0f0f0);
}

/// Tests of two small families, four at a time: every machine of a kind has instructions for that.
template <int Dim>
class PortableBlock {
  public:
    LOD_INLINE explicit PortableBlock(const FamilyTests<Dim>& tests)
        : tests_(tests), single_a_(tests.single_a()), single_b_(tests.single_b()) {}

    /// Which tests may be met, and whether rounding might decide one of them (or of what lies
    /// behind the families). Each lane gathers the bits of all tests of one of B's nodes.
    template <int width>
    LOD_INLINE Hits test(const FamilyPair& pair) const {
        Integers maybe[2] = {};
        Integers sure[2] = {};
        test_all<width>(pair, maybe, sure);
        const Integers doubtful = (maybe[0] ^ sure[0]) | (maybe[1] ^ sure[1]);
        return {gathered<width>(maybe) & all_of(pair),
                ((doubtful[0] | doubtful[1]) | (doubtful[2] | doubtful[3])) != 0};
    }

    /// Which tests are met whatever rounding did.
    template <int width>
    [[gnu::noinline]] std::uint64_t surely(const FamilyPair pair) const {
        Integers maybe[2] = {};
        Integers sure[2] = {};
        test_all<width>(pair, maybe, sure);
        return gathered<width>(sure);
    }

  private:
    using Four = Lanes<4>::Four;

    template <int width>
    LOD_INLINE void test_all(const FamilyPair& pair, Integers (&maybe)[2],
                             Integers (&sure)[2]) const {
        Four centre[Dim][2];
        Four radius[2];
        carry<width>(pair, centre, radius);
        const float doubt = tests_.doubt();
        for (std::int32_t i = 0; i < pair.count_a; ++i) {
            const std::int32_t bit = 1 << i;
            for (int half = 0; half < width / 4; ++half) {
                const Four reach = radius[half] + single_a_[pair.at_a + Dim * pair.stride_a + i];
                Four over = reach * reach;
                for (int d = 0; d < Dim; ++d) {
                    const Four between =
                        centre[d][half] - single_a_[pair.at_a + d * pair.stride_a + i];
                    over -= between * between;
                }
                maybe[half] |= (over >= 0.0f) & bit;
                sure[half] |= (over >= reach * doubt) & bit;
            }
        }
    }

    /// B's nodes to A's frame.
    template <int width>
    LOD_INLINE void carry(const FamilyPair& pair, Four (&centre)[Dim][2], Four (&radius)[2]) const {
        for (int half = 0; half < width / 4; ++half) {
            const float* const from = single_b_ + pair.at_b + 4 * half;
            const auto four = [&](int d) {
                const float* const at = from + d * pair.stride_b;
                return Four{at[0], at[1], at[2], at[3]};
            };
            for (int row = 0; row < Dim; ++row) {
                const float shift = tests_.shift()[row];
                centre[row][half] = Four{shift, shift, shift, shift};
                for (int k = 0; k < Dim; ++k)
                    centre[row][half] += four(k) * tests_.turn()[row * Dim + k];
            }
            radius[half] = four(Dim) + tests_.reach();
        }
    }

    template <int width>
    LOD_INLINE static std::uint64_t gathered(const Integers (&bits)[2]) {
        std::uint64_t columns = 0;
        for (int b = 0; b < width; ++b)
            columns |= static_cast<std::uint64_t>(static_cast<std::uint32_t>(bits[b / 4][b % 4]))
                       << (8 * b);
        return transposed(columns);
    }

    const FamilyTests<Dim>& tests_;
    const float* single_a_;
    const float* single_b_;
};

/// Lists the node pairs, four at a time.
inline NodePair* list_portably(const FoundHits& found, NodePair* out) {
    for (std::size_t n = 0; n < found.count; ++n) {
        NodePair* const end = out + __builtin_popcountll(found.hits[n]);
        for (std::uint64_t left = found.hits[n]; left != 0; out += 4)
            for (int k = 0; k < 4; ++k) {
                const int bit = __builtin_ctzll(left | std::uint64_t{1} << 63);
                out[k] = {found.first_a[n] + bit / 8, found.first_b[n] + bit % 8};
                left &= left - 1;
            }
        out = end;
    }
    return out;
}

}  // namespace lod::detail
