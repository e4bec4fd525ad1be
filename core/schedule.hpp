#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/broad_phase.hpp"
#include "lodlab/core/traversal.hpp"

namespace lod {

/// In which order pairs are refined.
enum class Priority {
    in_order,       ///< by body numbers
    closing_speed,  ///< faster approach of the two centres of mass first: their errors move
                    ///< furthest
};

/// Storage of the scheduler, kept by the caller.
struct ScheduleScratch {
    std::vector<NodePair> level;  ///< the level in the making
    std::vector<double> speed;    ///< closing speed of each pair
};

/// The order in which the pairs are refined: indices into `pairs`, most important first.
template <int Dim>
void prioritise(Priority priority, std::span<const Body<Dim>> bodies,
                std::span<const CandidatePair> pairs, std::vector<std::int32_t>& order,
                ScheduleScratch& scratch);

/// The scheduler (section 5.1). Level 0 of every pair is always done. Then level after level, each
/// pair in the order of priority, until the budget ends, every front is finest, or `deepest_level`
/// is finished. The time of the response stays reserved: beyond level 0, tests and contacts
/// together never cost more than the quota. Returns whether the budget cut something short.
template <int Dim>
bool refine_all(std::span<const CandidatePair> pairs, std::span<const std::int32_t> order,
                int deepest_level, std::span<PosedTree<Dim>> world_S, Budget& budget,
                std::vector<Front>& fronts, ScheduleScratch& scratch);

}  // namespace lod
