#include "lodlab/core/traversal.hpp"

#include <algorithm>
#include <array>

namespace lod {
namespace {

/// Between two questions to the budget at most so many tests are done.
constexpr int most_at_once = 64;

void conclude(Front& front, bool any_leaf_pair, bool any_children) {
    ++front.level;
    front.finest = !any_children;
    if (front.pairs.empty())
        front.verdict = Verdict::apart;
    else
        front.verdict = any_leaf_pair ? Verdict::true_collision : Verdict::possible;
}

/// One level in the making.
template <int Dim>
struct Level {
    PosedTree<Dim>& a;
    PosedTree<Dim>& b;
    Budget& budget;
    std::vector<NodePair>& found;    ///< storage; only the first `found_count` are meant
    const std::size_t reserved = 0;  ///< contacts of this pair that the budget reserves already
    const double slack = a.rounding() + b.rounding();
    std::size_t found_count = 0;
    std::uint64_t tests = 0;

    [[nodiscard]] std::uint64_t more_contacts() const {
        return found_count > reserved ? found_count - reserved : 0;
    }

    /// Makes room for `more` pairs beyond those found.
    void make_room(std::size_t more) {
        if (found.size() < found_count + more)
            found.resize(std::max(found_count + more, 2 * found.size()));
    }

    /// The distance test of one ball, `node` of one tree, against the nodes [first, first + count)
    /// of the other; `swapped` when these are A's. A plain loop over blocks of fixed length, one
    /// array a coordinate, which compilers turn into SIMD; every lane does the same operations in
    /// the same order. No branch depends on the outcome, for no processor can guess it.
    template <bool swapped>
    void test_block(const Sphere<Dim>& ball, int node, const PosedTree<Dim>& many, int first,
                    int count) {
        constexpr int lanes = PosedTree<Dim>::lanes;
        make_room(static_cast<std::size_t>(count));
        NodePair* const out = found.data();
        std::size_t n = found_count;
        for (int begin = first; begin < first + count; begin += lanes) {
            std::array<double, lanes> squared{};
            std::array<double, lanes> reach{};
            for (int axis = 0; axis < Dim; ++axis) {
                const double* centre = many.centres(axis) + begin;
                const double x = ball.centre[axis];
                for (std::size_t k = 0; k < lanes; ++k)
                    squared[k] += (centre[k] - x) * (centre[k] - x);
            }
            const double* radius = many.radii() + begin;
            for (std::size_t k = 0; k < lanes; ++k)
                reach[k] = (radius[k] + ball.radius) * (radius[k] + ball.radius);
            const int end = std::min(lanes, first + count - begin);
            for (int k = 0; k < end; ++k) {
                out[n] = swapped ? NodePair{begin + k, node} : NodePair{node, begin + k};
                n += squared[static_cast<std::size_t>(k)] <= reach[static_cast<std::size_t>(k)];
            }
        }
        found_count = n;
    }

    /// Asks the budget for so many tests. Returns false when it ended.
    bool pay(int wanted) {
        const auto granted = budget.grant(static_cast<std::uint64_t>(wanted), more_contacts());
        tests += granted;
        return granted == static_cast<std::uint64_t>(wanted);
    }

    /// A node's ball, grown by all that rounding may have moved it and its partner.
    Sphere<Dim> grown(const PosedTree<Dim>& world, int node) const {
        Sphere<Dim> ball;
        for (int axis = 0; axis < Dim; ++axis) ball.centre[axis] = world.centres(axis)[node];
        ball.radius = world.radii()[node] + slack;
        return ball;
    }

    /// Tests one node of A against nodes [first, first + count) of B; with `swapped`, one node of B
    /// against nodes of A. Returns false when the budget ended.
    template <bool swapped>
    bool test(int node, int first, int count) {
        const PosedTree<Dim>& many = swapped ? a : b;
        const Sphere<Dim> ball = grown(swapped ? b : a, node);
        for (int done = 0; done < count; done += most_at_once) {
            const int wanted = std::min(most_at_once, count - done);
            if (!pay(wanted)) return false;
            test_block<swapped>(ball, node, many, first + done, wanted);
        }
        return true;
    }

    /// Tests all children of one node against all children of another. A small family is paid at
    /// once. Returns false when the budget ended.
    bool test_families(int first_a, int count_a, int first_b, int count_b) {
        const bool at_once = count_b <= most_at_once && count_a <= most_at_once / count_b;
        if (at_once && !pay(count_a * count_b)) return false;
        for (int child = first_a; child < first_a + count_a; ++child) {
            if (at_once)
                test_block<false>(grown(a, child), child, b, first_b, count_b);
            else if (!test<false>(child, first_b, count_b))
                return false;
        }
        return true;
    }

    bool expand(const NodePair& pair) {
        const auto child_count_a = a.tree().child_count[static_cast<std::size_t>(pair.a)];
        const auto child_count_b = b.tree().child_count[static_cast<std::size_t>(pair.b)];
        if (child_count_a == 0 && child_count_b == 0) {
            make_room(1);
            found[found_count++] = pair;
            return true;
        }
        const auto first_a = a.tree().first_child[static_cast<std::size_t>(pair.a)];
        const auto first_b = b.tree().first_child[static_cast<std::size_t>(pair.b)];
        if (child_count_a > 0) a.carry_children(pair.a);
        if (child_count_b > 0) b.carry_children(pair.b);
        if (child_count_b == 0) return test<true>(pair.b, first_a, child_count_a);
        if (child_count_a == 0) return test<false>(pair.a, first_b, child_count_b);
        return test_families(first_a, child_count_a, first_b, child_count_b);
    }

    /// All of the level, or false where the budget ended before it was done.
    bool expand_all(std::span<const NodePair> pairs) {
        for (const NodePair& pair : pairs)
            if (!expand(pair)) return false;
        if (budget.keeps_level(more_contacts())) return true;
        if (tests > 0) --tests;
        return false;
    }
};

}  // namespace

void Front::clear() {
    level = -1;
    verdict = Verdict::possible;
    finest = false;
    pairs.clear();
    tests = 0;
}

template <int Dim>
void test_roots(const PosedTree<Dim>& a, const PosedTree<Dim>& b, Front& front) {
    front.clear();
    front.tests = 1;
    Sphere<Dim> root_a = a.sphere(0);
    root_a.radius += a.rounding() + b.rounding();
    if (overlap(root_a, b.sphere(0))) front.pairs.push_back({0, 0});
    const bool leaves = a.tree().is_leaf(0) && b.tree().is_leaf(0);
    conclude(front, leaves, !front.pairs.empty() && !leaves);
}

template <int Dim>
Refinement refine(PosedTree<Dim>& a, PosedTree<Dim>& b, Budget& budget, Front& front,
                  std::vector<NodePair>& scratch) {
    Level<Dim> level{a, b, budget, scratch, front.pairs.size()};
    const bool done = level.expand_all(front.pairs);
    front.tests += level.tests;
    if (!done) return Refinement::interrupted;
    // Copied, not swapped: so each front keeps its own storage, and a frame seen before allocates
    // nothing.
    front.pairs.assign(scratch.begin(),
                       scratch.begin() + static_cast<std::ptrdiff_t>(level.found_count));
    bool any_leaf_pair = false;
    bool any_children = false;
    for (const NodePair& pair : front.pairs) {
        const bool leaves = a.tree().is_leaf(pair.a) && b.tree().is_leaf(pair.b);
        any_leaf_pair |= leaves;
        any_children |= !leaves;
    }
    conclude(front, any_leaf_pair, any_children);
    return Refinement::finished;
}

template <int Dim>
std::vector<Front> traverse_levels(const Body<Dim>& a, const Body<Dim>& b, int deepest) {
    PosedTree<Dim> world_a;
    PosedTree<Dim> world_b;
    world_a.pose(a);
    world_b.pose(b);
    Budget budget = Budget::unlimited();
    std::vector<NodePair> scratch;
    std::vector<Front> levels(1);
    test_roots(world_a, world_b, levels.back());
    while (!levels.back().finest && levels.back().level < deepest) {
        Front next = levels.back();
        if (refine(world_a, world_b, budget, next, scratch) == Refinement::interrupted) break;
        levels.push_back(std::move(next));
    }
    return levels;
}

#define LOD_INSTANTIATE(Dim)                                                        \
    template void test_roots(const PosedTree<Dim>&, const PosedTree<Dim>&, Front&); \
    template Refinement refine(PosedTree<Dim>&, PosedTree<Dim>&, Budget&, Front&,   \
                               std::vector<NodePair>&);                             \
    template std::vector<Front> traverse_levels(const Body<Dim>&, const Body<Dim>&, int);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
