#pragma once

/// \file
/// What an observer may see wrong in a collision, as one number. Its constants are ours; no
/// observer has tested them.

#include "lodlab/measure/collisions.hpp"

namespace measure {

/// What an observer may see wrong in one collision. Dimensionless where a share is named.
///
/// The sizes are shares of `size`, the diameter of the smaller body; speeds are shares of `pace`,
/// the largest speed of a centre or a rim of the two bodies before the reference's collision; so a
/// scene drawn larger or played in other units is judged alike. The signed ones are of the body
/// that shows it most.
struct Perceived {
    double gap = 0;    ///< gap at the first push beyond the reference's own, share of size, >= 0
    double delay = 0;  ///< [s], negative: too early
    /// Between the directions in which a body leaves in the two runs [rad]. Positive: deflected
    /// further than in the reference (an expanded angle), negative: less far.
    double angle = 0;
    double speed = 0;        ///< a body's speed less the reference's, share of pace
    double spin = 0;         ///< the difference of two spins at a body's rim, share of pace, >= 0
    double penetration = 0;  ///< beyond the reference's own, share of size, >= 0
    /// Of the two bodies' kinetic energy: relative change in the collision, less the reference's.
    double energy = 0;
};

/// How much of a component counts as 1. Every number is ours: chosen so that 1 is about where we
/// begin to see it, and so that the order of METHOD.md ("Perception") holds. None is a published
/// threshold, and none was tested on observers. Each > 0.
struct PerceivedSettings {
    double gap = 0.05;            ///< a gap is what observers notice most: a twentieth of the body
    double penetration = 0.1;     ///< half as strict: an overlap hides behind the outlines
    double late = 0.05;           ///< [s] three pictures at 60 Hz: bodies that stick
    double early = 0.1;           ///< [s] half as strict: what is early shows as a gap already
    double angle_expanded = 0.4;  ///< [rad] expanded angles are accepted more readily ...
    double angle_contracted = 0.2;  ///< [rad] ... than contracted ones: twice as strict
    double speed_raised = 0.4;      ///< raised speeds are accepted more readily ...
    double speed_lowered = 0.2;     ///< ... than lowered ones: twice as strict
    double spin = 0.5;              ///< the hardest to judge of all: widest
    double energy_gained = 0.4;     ///< as speeds, of which it is made
    double energy_lost = 0.2;
    double missing = 6;  ///< what a collision that does not happen counts: bodies pass through
    double extra = 4;    ///< what a collision out of nothing counts
    /// Collisions further apart in time are not the same event [s]: longer than any delay that one
    /// would still call a delay.
    double window = 0.25;
    /// A body that leaves slower than this share of pace has no direction to judge.
    double still = 0.02;
};

/// Counts of the components, each >= 0, in units of the settings.
struct PerceivedCost {
    double gap = 0;
    double delay = 0;
    double angle = 0;
    double speed = 0;
    double spin = 0;
    double penetration = 0;
    double energy = 0;

    /// All components together.
    [[nodiscard]] double sum() const {
        return gap + delay + angle + speed + spin + penetration + energy;
    }
};

/// One collision of both runs.
struct CollisionError {
    int reference = 0;  ///< index into the reference's collisions
    int seen = 0;       ///< index into the other's
    /// Neither body collided before, in either run: later collisions also hold what the earlier
    /// ones did to the paths.
    bool first = false;
    Perceived error;
    PerceivedCost cost;
};

/// How wrong a finished animation looks against a reference run.
struct PerceivedError {
    std::vector<CollisionError> collisions;  ///< those of both runs, in order of time
    std::vector<int> missing;                ///< collisions of the reference that did not happen
    std::vector<int> extra;                  ///< collisions that the reference does not have
    PerceivedCost cost;                      ///< mean over all events, missing and extra included
    double missing_cost = 0;                 ///< the same mean of what missing collisions count
    double extra_cost = 0;
    /// The sum of the parts of `cost`, missing_cost and extra_cost: 0 for the reference itself.
    double total = 0;
};

/// The components of one collision. Requires: the same two bodies.
template <int Dim>
[[nodiscard]] Perceived perceived(const Collision<Dim>& reference, const Collision<Dim>& seen,
                                  const BodyShapes<Dim>& shapes,
                                  const PerceivedSettings& settings = {});

/// Every component in units of the settings.
[[nodiscard]] PerceivedCost cost_of(const Perceived& error, const PerceivedSettings& settings);

/// Whether each collision is the first of both its bodies; walls meet everybody for the first time.
/// In order of time.
template <int Dim>
[[nodiscard]] std::vector<bool> first_collisions(std::span<const Collision<Dim>> collisions);

/// Matches the collisions of two runs (see match) and judges each. Both lists in order of time.
template <int Dim>
[[nodiscard]] PerceivedError perceived_error(std::span<const Collision<Dim>> reference,
                                             std::span<const Collision<Dim>> seen,
                                             const BodyShapes<Dim>& shapes,
                                             const PerceivedSettings& settings = {});

}  // namespace measure
