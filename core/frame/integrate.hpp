#pragma once

/// \file
/// Free motion of bodies for a time step, in space without loss of energy or angular momentum.

#include <span>

#include "lodlab/core/tree/body.hpp"

namespace lod {

/// Moves every body freely for h seconds. Positions and planar angles are exact for free motion.
///
/// In space the torque-free Euler equations are solved with the implicit midpoint rule for the
/// body-frame angular momentum M: M' = Q^T M with Q the rotation by h w, w = I^-1 (M + M')/2, and
/// the orientation turned by that same Q. M' - M is perpendicular to w, so kinetic energy is kept,
/// and R M is not touched, so angular momentum is kept, both to rounding and for any step. A step
/// in which the body turns far is split (Space::free_turn_steps), so that the iteration settles.
template <int Dim>
void integrate(std::span<Body<Dim>> bodies, double h);

}  // namespace lod
