#pragma once

/// \file
/// The exact first collision of two bodies, and how far another answer lies from it.

#include <optional>

#include "lodlab/measure/collisions.hpp"

namespace measure {

/// How far one answer to a collision lies from another.
struct ImpactError {
    /// |J - J_ref| / |J_ref| of the impulses that the pair exchanged: the same as the error of
    /// either body's velocity over its change.
    double impulse = 0;
    double angle = 0;  ///< between the ways in which a body leaves, the larger of the two [rad]
    double spin = 0;   ///< difference of a body's spins, the larger of the two [rad/s]
};

/// Requires: the same two bodies, not both static, and an impulse in the reference.
template <int Dim>
[[nodiscard]] ImpactError impact_error(const Collision<Dim>& reference, const Collision<Dim>& seen);

/// The impulse on B of a collision [N s]: the change of momentum of B, or of A where B is static.
template <int Dim>
[[nodiscard]] lod::Vector<Dim> impulse_of(const Collision<Dim>& collision);

/// Between two directions [rad], 0 to pi; 0 where one of them has no length.
template <int Dim>
[[nodiscard]] double angle_between(const lod::Vector<Dim>& u, const lod::Vector<Dim>& v);

/// The first collision of two bodies alone, exactly: moved freely to the moment in which their true
/// shapes touch, contacts from the shapes, velocities by `response`. Bodies 0 and 1. Nothing where
/// they do not meet within the horizon [s] or share a point at the start.
/// Requires: body.exact of both. Throws lod::Error as lod::time_of_impact does.
template <int Dim>
[[nodiscard]] std::optional<Collision<Dim>> exact_collision(const lod::Body<Dim>& a,
                                                            const lod::Body<Dim>& b,
                                                            lod::Response response, double horizon);

/// How long frames are watched for a collision.
struct Watch {
    double horizon = 0;  ///< from the start [s]
    double pause =
        one_collision;  ///< pushes that follow each other within it are one collision [s]
};

/// The same by frames under some settings, with all that detection costs. `shapes` of the two
/// bodies, as 0 and 1.
template <int Dim>
[[nodiscard]] std::optional<Collision<Dim>> framed_collision(const lod::Body<Dim>& a,
                                                             const lod::Body<Dim>& b,
                                                             const lod::FrameSettings& settings,
                                                             const BodyShapes<Dim>& shapes,
                                                             const Watch& watch);

}  // namespace measure
