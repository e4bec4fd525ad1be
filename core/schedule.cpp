#include "lodlab/core/schedule.hpp"

#include <algorithm>
#include <numeric>

namespace lod {
namespace {

std::size_t at(std::int32_t index) {
    return static_cast<std::size_t>(index);
}

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
                ScheduleScratch& scratch) {
    order.resize(pairs.size());
    std::iota(order.begin(), order.end(), 0);
    if (priority == Priority::in_order) return;
    std::vector<double>& speed = scratch.speed;
    speed.resize(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
        speed[i] = closing_speed(bodies[at(pairs[i].a)], bodies[at(pairs[i].b)]);
    std::sort(order.begin(), order.end(), [&](std::int32_t x, std::int32_t y) {
        return speed[at(x)] != speed[at(y)] ? speed[at(x)] > speed[at(y)] : x < y;
    });
}

template <int Dim>
int entry_level(const PosedTree<Dim>& a, const PosedTree<Dim>& b, bool by_hulls) {
    if (!by_hulls || !a.tree().has_hulls() || !b.tree().has_hulls()) return 0;
    return std::max(a.tree().hulls.entry_level, b.tree().hulls.entry_level);
}

template <int Dim>
bool refine_all(std::span<const CandidatePair> pairs, std::span<const std::int32_t> order,
                const Levels& levels, std::span<PosedTree<Dim>> world_S, Budget& budget,
                std::vector<Front>& fronts, ScheduleScratch& scratch) {
    if (fronts.size() < pairs.size()) fronts.resize(pairs.size());
    std::uint64_t contacts = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        test_roots(world_S[at(pairs[i].a)], world_S[at(pairs[i].b)], fronts[i]);
        const int entry =
            entry_level(world_S[at(pairs[i].a)], world_S[at(pairs[i].b)], levels.begin_at_entry);
        Budget enough = Budget::unlimited();
        while (fronts[i].level < entry && !fronts[i].finest)
            if (refine(world_S[at(pairs[i].a)], world_S[at(pairs[i].b)], enough, fronts[i],
                       scratch.level) == Refinement::interrupted)
                break;
        budget.spend(fronts[i].tests);
        contacts += fronts[i].pairs.size();
    }
    for (int level = 1; level <= levels.deepest; ++level) {
        bool unfinished = false;
        for (std::int32_t i : order) {
            Front& front = fronts[at(i)];
            if (front.finest) continue;
            unfinished |= front.level >= level;
            if (front.level >= level) continue;
            budget.reserve_contacts(contacts);
            contacts -= front.pairs.size();
            const Refinement refined =
                refine(world_S[at(pairs[at(i)].a)], world_S[at(pairs[at(i)].b)], budget, front,
                       scratch.level);
            if (refined == Refinement::interrupted) return true;
            contacts += front.pairs.size();
            unfinished |= !front.finest;
        }
        if (!unfinished) break;
    }
    return false;
}

#define LOD_INSTANTIATE(Dim)                                                                       \
    template void prioritise(Priority, std::span<const Body<Dim>>, std::span<const CandidatePair>, \
                             std::vector<std::int32_t>&, ScheduleScratch&);                        \
    template int entry_level(const PosedTree<Dim>&, const PosedTree<Dim>&, bool);                  \
    template bool refine_all(std::span<const CandidatePair>, std::span<const std::int32_t>,        \
                             const Levels&, std::span<PosedTree<Dim>>, Budget&,                    \
                             std::vector<Front>&, ScheduleScratch&);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
