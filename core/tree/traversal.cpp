#include "lodlab/core/tree/traversal.hpp"

#include <algorithm>
#include <array>

namespace lod {

NodePair* FrontList::room_for(std::size_t more) {
    if (room_.size() < used_ + more) room_.resize(std::max(used_ + more, 2 * room_.size()));
    return room_.data() + used_;
}

void FrontList::replace(ListedFront& front, std::size_t begin) {
    const auto first = static_cast<std::size_t>(front.pairs.first);
    const std::size_t count = used_ - begin;
    if (first + static_cast<std::size_t>(front.pairs.count) == begin) {
        std::copy_n(room_.begin() + static_cast<std::ptrdiff_t>(begin), count,
                    room_.begin() + static_cast<std::ptrdiff_t>(first));
        begin = first;
        used_ = first + count;
    }
    front.pairs = {static_cast<std::int32_t>(begin), static_cast<std::int32_t>(count)};
}

namespace {

/// Between two questions to the budget at most so many tests are done.
constexpr int most_at_once = 64;

void conclude(ListedFront& front, bool any_leaf_pair, bool any_children) {
    ++front.level;
    front.finest = !any_children;
    if (front.pairs.count == 0)
        front.verdict = Verdict::apart;
    else
        front.verdict = any_leaf_pair ? Verdict::true_collision : Verdict::possible;
}

/// The distance test of a half-space and a ball.
template <int Dim>
bool meets_border(const HalfSpace<Dim>& half_space, const Sphere<Dim>& ball, double slack) {
    return half_space.side(ball.centre) <= ball.radius + 2 * slack;
}

/// One level in the making.
template <int Dim>
struct Level {
    PosedTree<Dim>& a;
    PosedTree<Dim>& b;
    Budget& budget;
    FrontList& list;                 ///< what is found is appended to it
    const std::size_t reserved = 0;  ///< node pairs of this front that the budget reserves already
    const double slack = a.rounding() + b.rounding();
    const std::size_t begin = list.size();
    std::uint64_t tests = 0;

    [[nodiscard]] std::uint64_t more_pairs() const {
        const std::size_t found = list.size() - begin;
        return found > reserved ? found - reserved : 0;
    }

    /// The distance test of one ball, `node` of one tree, against the nodes [first, first + count)
    /// of the other; `swapped` when these are A's. A plain loop over blocks of fixed length, one
    /// array a coordinate, which compilers turn into SIMD; every lane does the same operations in
    /// the same order. No branch depends on the outcome, for no processor can guess it.
    template <bool swapped>
    void test_block(const Sphere<Dim>& ball, int node, const PosedTree<Dim>& many, int first,
                    int count) {
        constexpr int lanes = PosedTree<Dim>::lanes;
        NodePair* const out = list.room_for(static_cast<std::size_t>(count));
        std::size_t n = 0;
        for (int block = first; block < first + count; block += lanes) {
            std::array<double, lanes> squared{};
            std::array<double, lanes> reach{};
            for (int axis = 0; axis < Dim; ++axis) {
                const double* centre = many.centres(axis) + block;
                const double x = ball.centre[axis];
                for (std::size_t k = 0; k < lanes; ++k)
                    squared[k] += (centre[k] - x) * (centre[k] - x);
            }
            const double* radius = many.radii() + block;
            for (std::size_t k = 0; k < lanes; ++k)
                reach[k] = (radius[k] + ball.radius) * (radius[k] + ball.radius);
            const int end = std::min(lanes, first + count - block);
            for (int k = 0; k < end; ++k) {
                out[n] = swapped ? NodePair{block + k, node} : NodePair{node, block + k};
                n += squared[static_cast<std::size_t>(k)] <= reach[static_cast<std::size_t>(k)];
            }
        }
        list.take(n);
    }

    /// The same of a half-space, `node` of one tree, which is the only one.
    template <bool swapped>
    void test_border(const HalfSpace<Dim>& half_space, const PosedTree<Dim>& many, int first,
                     int count) {
        NodePair* const out = list.room_for(static_cast<std::size_t>(count));
        std::size_t n = 0;
        for (int node = first; node < first + count; ++node) {
            out[n] = swapped ? NodePair{node, 0} : NodePair{0, node};
            n += meets_border(half_space, many.sphere(node), slack);
        }
        list.take(n);
    }

    /// Asks the budget for so many tests. Returns false when it ended.
    bool pay(int wanted) {
        const auto granted = budget.grant(static_cast<std::uint64_t>(wanted), more_pairs());
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
        const PosedTree<Dim>& one = swapped ? b : a;
        const PosedTree<Dim>& many = swapped ? a : b;
        if (one.is_half_space()) {
            if (!pay(count)) return false;
            test_border<swapped>(one.half_space(), many, first, count);
            return true;
        }
        const Sphere<Dim> ball = grown(one, node);
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
            *list.room_for(1) = pair;
            list.take(1);
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

    /// All of the level, or false where the budget ended before it was done. By number: the list
    /// may move while it grows.
    bool expand_all(const ListedFront& front) {
        for (std::int32_t i = 0; i < front.pairs.count; ++i)
            if (!expand(NodePair(list.pairs_of(front)[static_cast<std::size_t>(i)]))) return false;
        return budget.keeps_level(more_pairs());
    }
};

template <int Dim>
bool roots_meet(const PosedTree<Dim>& a, const PosedTree<Dim>& b) {
    const double slack = a.rounding() + b.rounding();
    if (a.is_half_space()) return meets_border(a.half_space(), b.sphere(0), slack);
    if (b.is_half_space()) return meets_border(b.half_space(), a.sphere(0), slack);
    Sphere<Dim> root_a = a.sphere(0);
    root_a.radius += slack;
    return overlap(root_a, b.sphere(0));
}

}  // namespace

template <int Dim>
void test_roots(const PosedTree<Dim>& a, const PosedTree<Dim>& b, ListedFront& front,
                FrontList& list) {
    front = {};
    front.tests = 1;
    front.pairs.first = static_cast<std::int32_t>(list.size());
    if (roots_meet(a, b)) {
        *list.room_for(1) = {0, 0};
        list.take(1);
        front.pairs.count = 1;
    }
    const bool leaves = a.tree().is_leaf(0) && b.tree().is_leaf(0);
    conclude(front, leaves, front.pairs.count > 0 && !leaves);
}

template <int Dim>
Refinement refine(PosedTree<Dim>& a, PosedTree<Dim>& b, Budget& budget, ListedFront& front,
                  FrontList& list) {
    Level<Dim> level{a, b, budget, list, static_cast<std::size_t>(front.pairs.count)};
    const bool done = level.expand_all(front);
    front.tests += level.tests;
    if (!done) {
        list.shorten(level.begin);
        return Refinement::interrupted;
    }
    list.replace(front, level.begin);
    bool any_leaf_pair = false;
    bool any_children = false;
    for (const NodePair& pair : list.pairs_of(front)) {
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
    FrontList list;
    ListedFront front;
    test_roots(world_a, world_b, front, list);
    std::vector<Front> levels{list.front(front)};
    while (!front.finest && front.level < deepest) {
        if (refine(world_a, world_b, budget, front, list) == Refinement::interrupted) break;
        levels.push_back(list.front(front));
    }
    return levels;
}

#define LOD_INSTANTIATE(Dim)                                                             \
    template void test_roots(const PosedTree<Dim>&, const PosedTree<Dim>&, ListedFront&, \
                             FrontList&);                                                \
    template Refinement refine(PosedTree<Dim>&, PosedTree<Dim>&, Budget&, ListedFront&,  \
                               FrontList&);                                              \
    template std::vector<Front> traverse_levels(const Body<Dim>&, const Body<Dim>&, int);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
