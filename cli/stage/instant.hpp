#pragma once

#include <vector>

#include "cli/arguments/options.hpp"
#include "lodlab/core/tree/traversal.hpp"
#include "lodlab/scenes/setup.hpp"

namespace cli {

/// One instant of a scene, and all that detection finds there.
template <int Dim>
struct Instant {
    double time = 0;  ///< [s]
    std::vector<lod::Body<Dim>> bodies;
    lod::FrameRecord<Dim> record;
};

/// The instant that the options name by --at. Without it, the first frame in which leaves meet;
/// where they never do, the one with the most node tests: there the bodies come nearest.
/// The bodies move under the finest detection; the scene's level limits what is looked at.
template <int Dim>
[[nodiscard]] Instant<Dim> instant_of(const scenes::Setup<Dim>& setup, const Options& options);

/// The fronts of a pair, level by level down to the one that the record finished.
template <int Dim>
[[nodiscard]] std::vector<lod::Front> levels_of(const Instant<Dim>& instant,
                                                const lod::PairRecord& pair);

}  // namespace cli
