#include <algorithm>
#include <array>
#include <cstring>

#include "lodlab/core/tree/bit_numbers.hpp"
#include "lodlab/core/tree/portable_block.hpp"

// This file is compiled once for what the program is compiled for, and, where Highway's headers
// are, once more for each newer set of instructions. Of Highway the headers alone are taken, and
// the compiler tells which sets a processor has, so that no program need link that library.
#ifdef LODLAB_HIGHWAY
#define HWY_IS_DEBUG_BUILD 0
#define HWY_WANT_AVX3_DL
#define HWY_DISABLE_F16C
#define HWY_DISABLE_PCLMUL_AES
#define HWY_DISABLED_TARGETS (~(HWY_AVX3_DL | HWY_AVX2 | HWY_EMU128 | HWY_SCALAR))
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/tree/family_kernels.cpp"
#include <hwy/foreach_target.h>
// After it:
#include <hwy/highway.h>
#define LOD_AVX512 (HWY_TARGET == HWY_AVX3_DL)
#define LOD_AVX2 (HWY_TARGET == HWY_AVX2)
#else
#define HWY_NAMESPACE N_COMPILED_FOR
#define HWY_BEFORE_NAMESPACE() static_assert(true)
#define HWY_AFTER_NAMESPACE() static_assert(true)
#define HWY_ONCE 1
#define HWY_TARGETS 0
#define LOD_AVX512 0
#define LOD_AVX2 0
#endif

HWY_BEFORE_NAMESPACE();
namespace lod::detail::HWY_NAMESPACE {

#if LOD_AVX512 || LOD_AVX2

namespace hn = hwy::HWY_NAMESPACE;

constexpr int lanes = LOD_AVX512 ? 16 : 8;
using Tag = hn::FixedTag<float, lanes>;
constexpr Tag tag;
constexpr hn::RebindToSigned<Tag> integers;
using V = hn::Vec<Tag>;
using Indices = decltype(hn::IndicesFromVec(tag, hn::Iota(integers, 0)));

/// One bit a number: whether it is below zero.
LOD_INLINE std::uint64_t bits_below_zero(V v) {
#if LOD_AVX512
    return _mm512_movepi32_mask(_mm512_castps_si512(v.raw));
#else
    return static_cast<std::uint32_t>(_mm256_movemask_ps(v.raw));
#endif
}

/// Where the numbers of two families of at most `width` nodes go in a register: A's node number
/// group x rows + lane / width meets B's node number lane % width.
template <int width>
struct Spread {
    static constexpr int rows = lanes / width;
    static constexpr int groups = width / rows;
    static constexpr int shift = width == 8 ? 3 : 2;

    LOD_INLINE Spread() {
        const auto lane = hn::Iota(integers, 0);
        b = hn::IndicesFromVec(tag, hn::And(lane, hn::Set(integers, width - 1)));
        for (int g = 0; g < groups; ++g)
            a[g] = hn::IndicesFromVec(
                tag, hn::Add(hn::ShiftRight<shift>(lane), hn::Set(integers, g * rows)));
    }
    LOD_INLINE V of_a(const float* from, int group) const {
        if constexpr (rows == 1)
            return hn::Set(tag, from[group]);
        else
            return hn::TableLookupLanes(hn::LoadU(tag, from), a[group]);
    }
    LOD_INLINE V of_b(const float* from) const {
        if constexpr (rows == 1)
            return hn::LoadU(tag, from);
        else
            return hn::TableLookupLanes(hn::LoadU(tag, from), b);
    }

    Indices b;
    Indices a[groups];
};

template <int Dim>
class Block {
  public:
    LOD_INLINE explicit Block(const FamilyTests<Dim>& tests)
        : single_a_(tests.single_a()), single_b_(tests.single_b()) {
        for (int i = 0; i < Dim * Dim; ++i) turn_[i] = hn::Set(tag, tests.turn()[i]);
        for (int i = 0; i < Dim; ++i) shift_[i] = hn::Set(tag, tests.shift()[i]);
        reach_ = hn::Set(tag, tests.reach());
        doubt_ = hn::Set(tag, tests.doubt());
    }

    /// Which tests may be met, and whether rounding might decide one of them (or of what lies
    /// behind the families).
    template <int width>
    LOD_INLINE Hits test(const FamilyPair& pair) const {
        const Carried b = carried<width>(pair);
        V doubtful = hn::Zero(tag);
        std::uint64_t apart = 0;
        for (int g = 0; g < Spread<width>::groups; ++g) {
            if (2 * g == Spread<width>::groups && 2 * pair.count_a <= width) break;
            const Gap gap = test_group<width>(pair, b, g);
            apart |= bits_below_zero(gap.over) << (g * lanes);
            doubtful = hn::Or(doubtful, hn::AndNot(gap.over, gap.over_doubt));
        }
        return {rows_of<width>(~apart) & all_of(pair), bits_below_zero(doubtful) != 0};
    }

    /// Which tests are met whatever rounding did.
    template <int width>
    [[gnu::noinline]] std::uint64_t surely(const FamilyPair pair) const {
        const Carried b = carried<width>(pair);
        std::uint64_t not_sure = 0;
        for (int g = 0; g < Spread<width>::groups; ++g)
            not_sure |= bits_below_zero(test_group<width>(pair, b, g).over_doubt) << (g * lanes);
        return rows_of<width>(~not_sure);
    }

  private:
    /// Nodes of B in A's frame.
    struct Carried {
        V centre[Dim];
        V radius;
    };
    /// By how much the square of the reach is above that of the distance, and above what rounding
    /// might decide.
    struct Gap {
        V over;
        V over_doubt;
    };

    template <int width>
    LOD_INLINE Carried carried(const FamilyPair& pair) const {
        const Spread<width>& spread = of_width(std::integral_constant<int, width>());
        V part[Dim];
        for (int d = 0; d < Dim; ++d)
            part[d] = spread.of_b(single_b_ + pair.at_b + d * pair.stride_b);
        Carried b;
        for (int d = 0; d < Dim; ++d) {
            b.centre[d] = hn::MulAdd(turn_[d * Dim], part[0], shift_[d]);
            for (int k = 1; k < Dim; ++k)
                b.centre[d] = hn::MulAdd(turn_[d * Dim + k], part[k], b.centre[d]);
        }
        b.radius = hn::Add(spread.of_b(single_b_ + pair.at_b + Dim * pair.stride_b), reach_);
        return b;
    }

    template <int width>
    LOD_INLINE Gap test_group(const FamilyPair& pair, const Carried& b, int group) const {
        const Spread<width>& spread = of_width(std::integral_constant<int, width>());
        const V reach =
            hn::Add(spread.of_a(single_a_ + pair.at_a + Dim * pair.stride_a, group), b.radius);
        V over = hn::Mul(reach, reach);
        for (int d = 0; d < Dim; ++d) {
            const V between =
                hn::Sub(spread.of_a(single_a_ + pair.at_a + d * pair.stride_a, group), b.centre[d]);
            over = hn::NegMulAdd(between, between, over);
        }
        return {over, hn::NegMulAdd(doubt_, reach, over)};
    }

    template <int width>
    LOD_INLINE static std::uint64_t rows_of(std::uint64_t bits) {
        return width == 8 ? bits : spread_rows(bits & 0xffff);
    }

    LOD_INLINE const Spread<4>& of_width(std::integral_constant<int, 4>) const { return four_; }
    LOD_INLINE const Spread<8>& of_width(std::integral_constant<int, 8>) const { return eight_; }

    const float* single_a_;
    const float* single_b_;
    Spread<4> four_;
    Spread<8> eight_;
    V turn_[Dim * Dim];
    V shift_[Dim];
    V reach_;
    V doubt_;
};

#else

template <int Dim>
using Block = PortableBlock<Dim>;

#endif

/// Settles the hits that rounding might decide.
template <int Dim>
std::uint64_t settled(const Block<Dim>& block, const FamilyTests<Dim>& tests,
                      const FamilyPair& pair, std::uint64_t hits) {
    const bool of_four = pair.count_a <= 4 && pair.count_b <= 4;
    const std::uint64_t surely =
        of_four ? block.template surely<4>(pair) : block.template surely<8>(pair);
    for (std::uint64_t doubtful = hits & ~surely; doubtful != 0; doubtful &= doubtful - 1) {
        const int bit = __builtin_ctzll(doubtful);
        if (!tests.meet_exactly(pair.first_a + bit / 8, pair.first_b + bit % 8, pair.leaf_b))
            hits ^= std::uint64_t{1} << bit;
    }
    return hits;
}

#if LOD_AVX512

/// The numbers of a family's hits, eight by eight: `parts` names them all, 8 n + k for the eight of
/// number k of family n.
LOD_INLINE NodePair* list_hits(const FoundHits& found, NodePair* out) {
    alignas(64) std::uint8_t numbers[64 * FoundHits::most];
    std::uint8_t parts[8 * FoundHits::most + 8];
    NodePair* begin[FoundHits::most];
    std::size_t part_count = 0;
    const __m512i all = _mm512_load_si512(all_bit_numbers.data());
    for (std::size_t n = 0; n < found.count; ++n) {
        _mm512_store_si512(numbers + 64 * n, _mm512_maskz_compress_epi8(found.hits[n], all));
        const std::uint64_t named = 0x0706050403020100 + 0x0808080808080808 * n;
        std::memcpy(parts + part_count, &named, 8);
        const auto hits = static_cast<std::size_t>(__builtin_popcountll(found.hits[n]));
        begin[n] = out;
        part_count += (hits + 7) / 8;
        out += hits;
    }
    const __m512i column = _mm512_set1_epi64(7);
    for (std::size_t i = 0; i < part_count; ++i) {
        const std::size_t part = parts[i];
        const __m512i eight = _mm512_cvtepu8_epi64(
            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers + 8 * part)));
        const __m512i of_a = _mm512_srli_epi64(eight, 3);
        const __m512i of_b = _mm512_slli_epi64(_mm512_and_si512(eight, column), 32);
        const std::int64_t base = found.first(part / 8);
        _mm512_storeu_si512(begin[part / 8] + part % 8 * 8,
                            _mm512_add_epi32(_mm512_set1_epi64(base), _mm512_or_si512(of_a, of_b)));
    }
    return out;
}

#elif LOD_AVX2

/// Row by row, those without a hit left out: `rows` names the others, 8 n + a for number a of A's
/// in family n.
LOD_INLINE NodePair* list_hits(const FoundHits& found, NodePair* out) {
    std::uint8_t rows[8 * FoundHits::most + 8];
    std::size_t row_count = 0;
    std::uint64_t all = 0;
    for (std::size_t n = 0; n < found.count; ++n) {
        all |= found.hits[n];
        const __m128i empty = _mm_cmpeq_epi8(
            _mm_cvtsi64_si128(static_cast<std::int64_t>(found.hits[n])), _mm_setzero_si128());
        const auto filled = static_cast<std::size_t>(~_mm_movemask_epi8(empty) & 0xff);
        const std::uint64_t named = bit_numbers[filled] + 0x0808080808080808 * n;
        std::memcpy(rows + row_count, &named, 8);
        row_count += static_cast<std::size_t>(__builtin_popcountll(filled));
    }
    const int halves = (all & 0xf0f0f0f0f0f0f0f0) == 0 ? 1 : 2;  // of a row's columns
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(found.hits);
    for (std::size_t i = 0; i < row_count; ++i) {
        const std::size_t row = rows[i];
        const auto* const columns = reinterpret_cast<const char*>(&bit_numbers[bytes[row]]);
        const std::int64_t base = found.first(row / 8);
        const __m256i of_row = _mm256_set1_epi64x(base + static_cast<std::int64_t>(row % 8));
        for (int half = 0; half < halves; ++half) {
            std::int32_t four = 0;
            std::memcpy(&four, columns + 4 * half, 4);
            const __m256i of_b =
                _mm256_slli_epi64(_mm256_cvtepu8_epi64(_mm_cvtsi32_si128(four)), 32);
            _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + 4 * half),
                                _mm256_add_epi32(of_row, of_b));
        }
        out += __builtin_popcountll(bytes[row]);
    }
    return out;
}

#else

LOD_INLINE NodePair* list_hits(const FoundHits& found, NodePair* out) {
    return list_portably(found, out);
}

#endif

/// All tests come first, then the lists: a branch on an outcome would throw away the tests begun
/// behind it.
template <int Dim>
FamiliesTested test_pairs(const FamilyTests<Dim>& tests, const NodePair* pairs, std::size_t count,
                          NodePair* out) {
    const Block<Dim> block(tests);
    FoundHits found;
    std::uint64_t test_count = 0;
    std::int32_t eldest_a = FamilyPair::none;
    std::int32_t eldest_b = FamilyPair::none;
    NodePair* end = out;
    std::size_t i = 0;
    for (bool small = true; small && i < count;) {
        const std::size_t begin = i;
        std::uint32_t doubtful = 0;
        for (std::size_t n = 0; n < FoundHits::most && i < count; ++n, ++i) {
            const FamilyPair pair = tests.families_of(pairs[i]);
            small = pair.count_a <= small_family && pair.count_b <= small_family;
            if (!small) break;
            Hits met{1, false};
            if (pair.count_a > 4 || pair.count_b > 4)
                met = block.template test<8>(pair);
            else if (pair.count_a > 0)
                met = block.template test<4>(pair);
            found.set(n, met.maybe, pair);
            doubtful |= static_cast<std::uint32_t>(met.doubtful) << n;
            test_count += static_cast<std::uint32_t>(pair.count_a * pair.count_b);
            eldest_a = std::min(eldest_a, pair.eldest_a());
            eldest_b = std::min(eldest_b, pair.eldest_b());
        }
        for (; doubtful != 0; doubtful &= doubtful - 1) {
            const int n = __builtin_ctz(doubtful);
            found.hits[n] =
                settled(block, tests, tests.families_of(pairs[begin + static_cast<std::size_t>(n)]),
                        found.hits[n]);
        }
        found.count = i - begin;
        end = list_hits(found, end);
    }
    return {i, static_cast<std::size_t>(end - out), test_count, eldest_a, eldest_b};
}

/// One node of A after the other against eight of B, so that the order stays A's.
template <int Dim>
std::size_t test_families(const FamilyTests<Dim>& tests, const FamilyPair& pair, NodePair* out) {
    const Block<Dim> block(tests);
    FoundHits found;
    found.count = 1;
    NodePair* end = out;
    for (std::int32_t i = 0; i < pair.count_a; ++i)
        for (std::int32_t k = 0; k < pair.count_b; k += small_family) {
            FamilyPair part = pair;
            part.at_a += i;
            part.at_b += k;
            part.first_a += i;
            part.first_b += k;
            part.count_a = 1;
            part.count_b = pair.count_b - k < small_family ? pair.count_b - k : small_family;
            const Hits met = block.template test<8>(part);
            found.set(0, met.doubtful ? settled(block, tests, part, met.maybe) : met.maybe, part);
            end = list_hits(found, end);
        }
    return static_cast<std::size_t>(end - out);
}

constexpr TestPath path{LOD_AVX512 ? "avx512"
                        : LOD_AVX2 ? "avx2"
                                   : "portable",
                        {FamilyKernel<2>{test_pairs<2>, test_families<2>},
                         FamilyKernel<3>{test_pairs<3>, test_families<3>}}};

}  // namespace lod::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#undef LOD_AVX512
#undef LOD_AVX2

#if HWY_ONCE
namespace lod::detail {

std::vector<TestPath> compiled_paths() {
    std::vector<TestPath> paths;
#ifdef LODLAB_HIGHWAY
#if HWY_TARGETS & HWY_AVX3_DL & ~HWY_STATIC_TARGET
    if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512vbmi") &&
        __builtin_cpu_supports("avx512vbmi2") && __builtin_cpu_supports("avx512vnni") &&
        __builtin_cpu_supports("avx512bitalg") && __builtin_cpu_supports("avx512vpopcntdq") &&
        __builtin_cpu_supports("vpclmulqdq") && __builtin_cpu_supports("gfni"))
        paths.push_back(N_AVX3_DL::path);
#endif
#if HWY_TARGETS & HWY_AVX2 & ~HWY_STATIC_TARGET
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
        __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2"))
        paths.push_back(N_AVX2::path);
#endif
#endif
    paths.push_back(HWY_NAMESPACE::path);
    return paths;
}

}  // namespace lod::detail
#endif
