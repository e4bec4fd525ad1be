#include "core/traversal.hpp"

#include <algorithm>
#include <array>

namespace lod {
namespace {

/// How many nodes one call of the distance test handles: its results stay in registers and cache.
constexpr int batch = 8;

/// The distance test of one ball against nodes [first, first + count) of a posed tree: entry k is
/// at most 0 where they overlap. A plain loop over one array a coordinate, which compilers turn
/// into SIMD; every lane does the same operations in the same order.
template <int Dim>
void separation(const PosedTree<Dim>& world, int first, int count, const Sphere<Dim>& ball,
                std::array<double, batch>& result) {
    std::array<double, batch> squared{};
    for (int axis = 0; axis < Dim; ++axis) {
        const double* centre = world.centres(axis) + first;
        const double x = ball.centre[axis];
        for (int k = 0; k < count; ++k) {
            const double gap = centre[k] - x;
            squared[static_cast<std::size_t>(k)] += gap * gap;
        }
    }
    const double* radius = world.tree().radius.data() + first;
    for (int k = 0; k < count; ++k) {
        const double reach = radius[k] + ball.radius;
        result[static_cast<std::size_t>(k)] = squared[static_cast<std::size_t>(k)] - reach * reach;
    }
}

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
    std::vector<NodePair>& found;
    std::uint64_t tests = 0;

    /// Tests one node of A against nodes [first, first + count) of B; with `swapped`, one node of B
    /// against nodes of A. Returns false when the budget ended.
    template <bool swapped>
    bool test(int node, int first, int count) {
        PosedTree<Dim>& one = swapped ? b : a;
        PosedTree<Dim>& many = swapped ? a : b;
        Sphere<Dim> ball = one.sphere(node);
        ball.radius += a.rounding() + b.rounding();
        std::array<double, batch> result;
        for (int begin = first; begin < first + count; begin += batch) {
            const int wanted = std::min(batch, first + count - begin);
            const int granted =
                static_cast<int>(budget.grant(static_cast<std::uint64_t>(wanted)));
            tests += static_cast<std::uint64_t>(granted);
            if (granted < wanted) return false;
            separation(many, begin, wanted, ball, result);
            for (int k = 0; k < wanted; ++k)
                if (result[static_cast<std::size_t>(k)] <= 0)
                    found.push_back(swapped ? NodePair{begin + k, node}
                                            : NodePair{node, begin + k});
        }
        return true;
    }

    bool expand(const NodePair& pair) {
        const auto child_count_a = a.tree().child_count[static_cast<std::size_t>(pair.a)];
        const auto child_count_b = b.tree().child_count[static_cast<std::size_t>(pair.b)];
        if (child_count_a == 0 && child_count_b == 0) {
            found.push_back(pair);
            return true;
        }
        const auto first_a = a.tree().first_child[static_cast<std::size_t>(pair.a)];
        const auto first_b = b.tree().first_child[static_cast<std::size_t>(pair.b)];
        if (child_count_a > 0) a.carry_children(pair.a);
        if (child_count_b > 0) b.carry_children(pair.b);
        if (child_count_b == 0) return test<true>(pair.b, first_a, child_count_a);
        if (child_count_a == 0) return test<false>(pair.a, first_b, child_count_b);
        for (int child = first_a; child < first_a + child_count_a; ++child)
            if (!test<false>(child, first_b, child_count_b)) return false;
        return true;
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
    scratch.clear();
    Level<Dim> level{a, b, budget, scratch};
    for (const NodePair& pair : front.pairs) {
        if (!level.expand(pair)) {
            front.tests += level.tests;
            return Refinement::interrupted;
        }
    }
    front.tests += level.tests;
    front.pairs.swap(scratch);
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

#define LOD_INSTANTIATE(Dim)                                                                    \
    template void test_roots(const PosedTree<Dim>&, const PosedTree<Dim>&, Front&);             \
    template Refinement refine(PosedTree<Dim>&, PosedTree<Dim>&, Budget&, Front&,               \
                               std::vector<NodePair>&);                                         \
    template std::vector<Front> traverse_levels(const Body<Dim>&, const Body<Dim>&, int);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
