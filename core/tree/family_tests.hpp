#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <tuple>
#include <vector>

#include "lodlab/core/base/bits.hpp"
#include "lodlab/core/tree/traversal.hpp"

namespace lod::detail {

/// Two families, or a part of each, whose nodes are tested all against all: `count_a` nodes of tree
/// A from `first_a` on, and as many of B. No nodes at all stand for two leaves that go on untested.
struct FamilyPair {
    std::ptrdiff_t at_a;  ///< where the first node's x stands in SphereTree::single
    std::ptrdiff_t at_b;
    std::int32_t first_a;
    std::int32_t first_b;
    std::int32_t count_a;
    std::int32_t count_b;
    std::int32_t stride_a;  ///< numbers from one coordinate to the next, the radius last
    std::int32_t stride_b;
    bool leaf_a;  ///< A's node is a leaf, which stands for its children
    bool leaf_b;  ///< the same of B's

    /// The least node that may have children.
    [[nodiscard]] LOD_INLINE std::int32_t eldest_a() const { return leaf_a ? none : first_a; }
    [[nodiscard]] LOD_INLINE std::int32_t eldest_b() const { return leaf_b ? none : first_b; }
    static constexpr std::int32_t none = (std::numeric_limits<std::int32_t>::max)();
};

/// Two posed trees, for tests of their nodes in A's frame and in single precision. It decides all
/// but the few tests that its rounding might turn; those are done in double precision, by
/// meet_exactly. So every way of computing finds the very same pairs.
template <int Dim>
class FamilyTests {
  public:
    FamilyTests(const PosedTree<Dim>& a, const PosedTree<Dim>& b);

    /// Whether single precision serves: both trees have their copy, and their sizes are ordinary.
    [[nodiscard]] bool serves() const { return serves_; }

    /// All children of one node and of another. Where one of the two is a leaf it stands for its
    /// children; two leaves have none.
    [[nodiscard]] LOD_INLINE FamilyPair families_of(const NodePair& nodes) const {
        const std::int32_t count_a = of_a_.child_count[nodes.a];
        const std::int32_t count_b = of_b_.child_count[nodes.b];
        if (count_a == 0 || count_b == 0) return with_leaf(nodes);
        const std::int32_t first_a = of_a_.first_child[nodes.a];
        const std::int32_t first_b = of_b_.first_child[nodes.b];
        return {static_cast<std::ptrdiff_t>(first_a) * (Dim + 1),
                static_cast<std::ptrdiff_t>(first_b) * (Dim + 1),
                first_a,
                first_b,
                count_a,
                count_b,
                count_a,
                count_b,
                false,
                false};
    }

    /// The distance test of two nodes, world frame, in double precision, with the reach grown by
    /// all that rounding may have moved them: what every test means.
    /// `leaf_b`: of A's children and a leaf of B the leaf's reach is grown, else A's.
    [[nodiscard]] bool meet_exactly(std::int32_t a, std::int32_t b, bool leaf_b) const;

    /// The trees' copies in single precision.
    [[nodiscard]] const float* single_a() const { return a_.tree().single.data(); }
    [[nodiscard]] const float* single_b() const { return b_.tree().single.data(); }
    /// B's frame to A's.
    [[nodiscard]] const float* turn() const { return turn_; }  ///< row by row
    [[nodiscard]] const float* shift() const { return shift_; }
    /// Added to two radii: beyond it, no pair meets.
    [[nodiscard]] float reach() const { return reach_; }
    /// With R = two radii + reach() and d the distance: where R^2 - d^2 is above R times this, a
    /// pair meets; between that and 0, rounding might decide.
    [[nodiscard]] float doubt() const { return doubt_; }

  private:
    [[nodiscard]] FamilyPair with_leaf(const NodePair& nodes) const;

    /// A tree's arrays.
    struct Arrays {
        explicit Arrays(const SphereTree<Dim>& tree)
            : child_count(tree.child_count.data()), first_child(tree.first_child.data()) {}
        const std::int32_t* child_count;
        const std::int32_t* first_child;
    };

    const PosedTree<Dim>& a_;
    const PosedTree<Dim>& b_;
    Arrays of_a_{a_.tree()};
    Arrays of_b_{b_.tree()};
    double slack_;
    bool serves_ = false;
    float turn_[static_cast<std::size_t>(Dim) * Dim] = {};
    float shift_[Dim] = {};
    float reach_ = 0;
    float doubt_ = 0;
};

/// Families of at most so many nodes are small: a test a bit, all fit into 64.
constexpr std::int32_t small_family = 8;
/// Of pairs of small families, so much room is wanted for each.
constexpr std::size_t room_of_small = 64;
/// Beyond the pairs found, so many more may be written, which mean nothing.
constexpr std::size_t room_beyond = 16;

/// The outcomes of all tests of two small families.
struct Hits {
    std::uint64_t maybe;  ///< bit 8 a + b for number a of A's and b of B's
    bool doubtful;        ///< whether rounding might decide one
};

/// The bits of families of that many nodes.
[[nodiscard]] LOD_INLINE std::uint64_t all_of(const FamilyPair& pair) {
    constexpr std::uint64_t every = ~std::uint64_t{0};
    constexpr std::uint64_t one_a_row = every / 0xff;
    return (one_a_row * ((std::uint64_t{1} << pair.count_b) - 1)) &
           (every >> (64 - 8 * pair.count_a));
}
/// Four rows of four bits, as four of eight.
[[nodiscard]] LOD_INLINE std::uint64_t spread_rows(std::uint64_t bits) {
    bits = (bits | bits << 8) & 0x00ff00ff;
    return (bits | bits << 4) & 0x0f0f0f0f;
}

/// The hits of some families, from which the node pairs are listed. How many one has no processor
/// can guess, so no branch should depend on it.
struct FoundHits {
    static constexpr std::size_t most = 32;  ///< families
    std::uint64_t hits[most];
    std::int32_t first_a[most];  ///< of each family; not pairs, which would all be set to zero
    std::int32_t first_b[most];
    std::size_t count;

    LOD_INLINE void set(std::size_t n, std::uint64_t hits_of_family, const FamilyPair& family) {
        hits[n] = hits_of_family;
        first_a[n] = family.first_a;
        first_b[n] = family.first_b;
    }
    /// The first nodes of a family as NodePair lies in memory on x86-64.
    [[nodiscard]] LOD_INLINE std::int64_t first(std::size_t n) const {
        return static_cast<std::int64_t>(first_b[n]) << 32 | static_cast<std::uint32_t>(first_a[n]);
    }
};

/// What the tests of some node pairs' families came to.
struct FamiliesTested {
    std::size_t node_pairs = 0;  ///< whose families were tested
    std::size_t found = 0;       ///< pairs written
    std::uint64_t tests = 0;
    std::int32_t eldest_a = FamilyPair::none;  ///< the least of all
    std::int32_t eldest_b = FamilyPair::none;
};

/// One way of computing the tests, by the instructions that it takes. All write pairs of nodes that
/// meet by the order of the families, then by A's number, then by B's.
template <int Dim>
struct FamilyKernel {
    /// Tests the families of node pairs until all are done or one is not small.
    FamiliesTested (*of_pairs)(const FamilyTests<Dim>& tests, const NodePair* pairs,
                               std::size_t count, NodePair* out);
    /// Tests two families of any size; returns how many pairs it found.
    std::size_t (*of_families)(const FamilyTests<Dim>& tests, const FamilyPair& pair,
                               NodePair* out);
};

/// The same for the plane and for space.
struct TestPath {
    std::string_view name;
    std::tuple<FamilyKernel<2>, FamilyKernel<3>> kernels;

    /// One of them.
    template <int Dim>
    [[nodiscard]] const FamilyKernel<Dim>& kernel() const {
        return std::get<FamilyKernel<Dim>>(kernels);
    }
};

/// The ways that this machine has, the fastest first; the last takes no instructions but those that
/// the program was compiled for.
[[nodiscard]] const std::vector<TestPath>& test_paths();
/// The one that traversals take: the fastest, unless another was put in its place.
[[nodiscard]] const TestPath& test_path();
/// For tests and benchmarks: makes all traversals take this one, of test_paths(), from now on.
void take_path(const TestPath& path);

/// In double precision throughout, for sizes that are not ordinary.
template <int Dim>
[[nodiscard]] const FamilyKernel<Dim>& double_kernel();

/// All that was compiled and that this machine can run, the fastest first.
[[nodiscard]] std::vector<TestPath> compiled_paths();

}  // namespace lod::detail
