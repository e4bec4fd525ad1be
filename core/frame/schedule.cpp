#include "lodlab/core/frame/schedule.hpp"

#include <algorithm>
#include <numeric>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

/// Approach of the centres of mass [m/s]; negative when they part.
template <int Dim>
double closing_speed(const Body<Dim>& a, const Body<Dim>& b) {
    const Vector<Dim> line = b.position - a.position;
    const double length = line.norm();
    return length > 0 ? line.dot(a.velocity - b.velocity) / length : 0;
}

}  // namespace

template <int Dim>
void prioritise(Priority priority, std::span<const Body<Dim>> bodies,
                std::span<const CandidatePair> pairs, std::vector<std::int32_t>& order,
                std::vector<double>& speed) {
    order.resize(pairs.size());
    std::iota(order.begin(), order.end(), 0);
    if (priority == Priority::in_order) return;
    speed.resize(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
        speed[i] = closing_speed(bodies[at(pairs[i].a)], bodies[at(pairs[i].b)]);
    std::sort(order.begin(), order.end(), [&](std::int32_t x, std::int32_t y) {
        return speed[at(x)] != speed[at(y)] ? speed[at(x)] > speed[at(y)] : x < y;
    });
}

template <int Dim>
int entry_level(const PosedTree<Dim>& a, const PosedTree<Dim>& b, bool by_hulls) {
    // Nothing of a half-space fits into a hollow.
    if (a.is_half_space() || b.is_half_space()) return 0;
    if (!by_hulls || !a.tree().has_hulls() || !b.tree().has_hulls()) return 0;
    return std::max(a.tree().hulls.entry_level, b.tree().hulls.entry_level);
}

namespace {

/// Refines the fronts of a frame.
template <int Dim>
struct Refiner : RefineTask<Dim> {
    using RefineTask<Dim>::pairs, RefineTask<Dim>::order, RefineTask<Dim>::levels,
        RefineTask<Dim>::world_S;
    Budget& budget;
    Fronts& fronts;
    std::uint64_t node_pairs = 0;  ///< of all fronts

    Refinement refine_one(std::size_t pair, Budget& by) {
        ListedFront& front = fronts.of_pair[pair];
        by.begin(static_cast<std::int32_t>(pair), front.level + 1);
        node_pairs -= static_cast<std::uint64_t>(front.pairs.count);
        const Refinement done =
            refine(world_S[at(pairs[pair].a)], world_S[at(pairs[pair].b)], by, front, fronts.list);
        node_pairs += static_cast<std::uint64_t>(front.pairs.count);
        return done;
    }

    /// Whatever the budget says.
    void enter(std::size_t pair, int deepest) {
        ListedFront& front = fronts.of_pair[pair];
        const PosedTree<Dim>& a = world_S[at(pairs[pair].a)];
        const PosedTree<Dim>& b = world_S[at(pairs[pair].b)];
        test_roots(a, b, front, fronts.list);
        node_pairs += static_cast<std::uint64_t>(front.pairs.count);
        const int entry = std::max(entry_level(a, b, levels.begin_at_entry), deepest);
        Budget enough = Budget::unlimited();
        while (front.level < entry && !front.finest)
            if (refine_one(pair, enough) == Refinement::interrupted) break;
        budget.spend(front.tests);
    }

    /// Returns whether there is more to do.
    bool finish_level(int level) {
        bool unfinished = false;
        for (const std::int32_t i : order) {
            const ListedFront& front = fronts.of_pair[at(i)];
            if (front.finest) continue;
            if (front.level < level) {
                budget.reserve(node_pairs);
                if (refine_one(at(i), budget) == Refinement::interrupted) return false;
            }
            unfinished |= !front.finest;
        }
        return unfinished;
    }
};

}  // namespace

template <int Dim>
void refine_all(const RefineTask<Dim>& task, Budget& budget, Fronts& fronts) {
    fronts.of_pair.resize(task.pairs.size());
    fronts.list.clear();
    Refiner<Dim> refiner{task, budget, fronts};
    // Without a limit each pair goes down to its end at once: the order changes nothing then.
    const bool at_once = budget.is_unlimited();
    const int deepest = task.levels.deepest;
    for (std::size_t i = 0; i < task.pairs.size(); ++i) refiner.enter(i, at_once ? deepest : 0);
    if (at_once) return;
    for (int level = 1; level <= deepest; ++level)
        if (!refiner.finish_level(level)) break;
}

#define LOD_INSTANTIATE(Dim)                                                                       \
    template void prioritise(Priority, std::span<const Body<Dim>>, std::span<const CandidatePair>, \
                             std::vector<std::int32_t>&, std::vector<double>&);                    \
    template int entry_level(const PosedTree<Dim>&, const PosedTree<Dim>&, bool);                  \
    template void refine_all(const RefineTask<Dim>&, Budget&, Fronts&);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
