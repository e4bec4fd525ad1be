#pragma once

/// \file
/// In which order pairs are refined, and the level-by-level refinement of all pairs under one
/// budget.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/base/names.hpp"
#include "lodlab/core/frame/broad_phase.hpp"
#include "lodlab/core/tree/traversal.hpp"

namespace lod {

/// In which order pairs are refined.
enum class Priority {
    in_order,       ///< by body numbers
    closing_speed,  ///< faster approach of the two centres of mass first: their errors move
                    ///< furthest
};
/// Their words in scenes, options and messages.
[[nodiscard]] constexpr std::array<std::string_view, 2> names_of(Priority) {
    return {"in_order", "closing_speed"};
}
static_assert(names_of(Priority{}).size() == static_cast<std::size_t>(Priority::closing_speed) + 1);

/// The order in which the pairs are refined: indices into `pairs`, most important first. `speed` is
/// storage that the caller keeps.
template <int Dim>
void prioritise(Priority priority, std::span<const Body<Dim>> bodies,
                std::span<const CandidatePair> pairs, std::vector<std::int32_t>& order,
                std::vector<double>& speed);

/// To which levels a frame refines.
struct Levels {
    int deepest = 1000;           ///< refinement stops after this level
    bool begin_at_entry = false;  ///< hulls tell of contacts: see refine_all
};

/// What a frame refines.
template <int Dim>
struct RefineTask {
    std::span<const CandidatePair> pairs;
    std::span<const std::int32_t> order;  ///< of priority: indices into `pairs`
    Levels levels;
    std::span<PosedTree<Dim>> world_S;  ///< of all bodies
};

/// The first level that says something of a pair: 0, or where contacts come from hulls the deeper
/// of the two bodies' entry levels (NodeHulls::entry_level).
template <int Dim>
[[nodiscard]] int entry_level(const PosedTree<Dim>& a, const PosedTree<Dim>& b, bool by_hulls);

/// Of every candidate pair, in their order: how far it was refined.
struct Fronts {
    std::vector<ListedFront> of_pair;
    FrontList list;

    /// The overlapping nodes of a candidate pair.
    [[nodiscard]] std::span<const NodePair> pairs(std::size_t pair) const {
        return list.pairs_of(of_pair[pair]);
    }
};

/// The scheduler (section 5.1). The entry level of every pair is always done, which is level 0 but
/// for bodies with hollows; its tests are spent whatever the budget says. Then level after level,
/// each pair in the order of priority, until the budget ends, every front is finest, or the deepest
/// level is finished. What follows stays reserved: beyond the entry level, tests and node pairs
/// together never cost more than the quota. Where the budget cuts something short, Budget::cut says
/// where.
template <int Dim>
void refine_all(const RefineTask<Dim>& task, Budget& budget, Fronts& fronts);

}  // namespace lod
