#pragma once

/// \file
/// When two freely moving bodies touch, exactly, and where.

#include <vector>

#include "lodlab/core/exact/exact_shape.hpp"

namespace lod {

/// How far ahead, and how exactly, an impact is looked for.
struct ImpactSettings {
    double horizon = 1;  ///< how far ahead is looked [s], >= 0
    /// Bodies no further apart than this touch [m], > 0. No less than some 1e-12 of their size and
    /// distance, or rounding hides the gap.
    double tolerance = 1e-9;
    /// In space a body that tumbles is taken to turn evenly for so long, as one step of integrate()
    /// does [s], > 0. In the plane, and where spin does not change, free motion is exact without.
    double longest_turn = 1.0 / 240;
    int most_rounds = 10'000;  ///< advances before the search gives up, >= 0
};

/// What the search for an impact found.
enum class ImpactOutcome {
    touching,     ///< converged: contacts within the tolerance, at least one of them approaching
    never,        ///< nothing touches within the horizon
    cap_reached,  ///< most_rounds were not enough; the time is one before the impact
    overlapping,  ///< the shapes share a point at the beginning
};

/// Two bodies at the moment in which they touch.
template <int Dim>
struct TimeOfImpact {
    ImpactOutcome outcome = ImpactOutcome::never;
    double time = 0;      ///< from the beginning [s]; the horizon where nothing touches
    double distance = 0;  ///< between the shapes then [m]
    int rounds = 0;       ///< advances that it took
    Body<Dim> a;          ///< moved freely to that time
    Body<Dim> b;
    std::vector<Contact<Dim>> contacts;  ///< see touching_contacts; empty unless touching
};

/// Backtracks, or looks ahead, to the time of impact of two freely moving bodies by conservative
/// advancement: moves both on by a time in which they surely can't touch, until they are within the
/// tolerance. They never pass through each other, however fast; bodies that part although they
/// touch go on. In the plane motion is exact. In space a tumbling body turns evenly for
/// longest_turn at a time and keeps its angular momentum.
/// Throws Error (input refused) unless both bodies have an exact shape and the settings are within
/// their ranges.
template <int Dim>
[[nodiscard]] TimeOfImpact<Dim> time_of_impact(const Body<Dim>& a, const Body<Dim>& b,
                                               const ImpactSettings& settings = {});

/// A body moved freely for some seconds, as time_of_impact moves it.
template <int Dim>
[[nodiscard]] Body<Dim> moved_freely(const Body<Dim>& body, double seconds, double longest_turn);

}  // namespace lod
