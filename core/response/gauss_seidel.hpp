#pragma once

#include <cstdint>
#include <span>

#include "lodlab/core/response/impact.hpp"

namespace lod {

/// Frictionless Newton impacts, a linear complementarity problem: finds for each of `contacts` an
/// impulse lambda >= 0 such that afterwards its closing velocity is u >= target, and lambda is 0
/// where u > target. Changes the bodies' velocities and spins and writes lambda (all arrays but
/// `contacts` are indexed like `impacts`).
///
/// Projected Gauss-Seidel on the velocities, which are unique where the impulses are not; stops
/// when a sweep changes no closing velocity by more than `tolerance` [m/s], or after
/// most_gauss_seidel_sweeps. A reference: its cost grows faster than the number of contacts.
/// Returns the sweeps.
template <int Dim>
int solve_by_gauss_seidel(std::span<const std::int32_t> contacts,
                          std::span<const Impact<Dim>> impacts,
                          std::span<const Inertia<Dim>> world_inverse_inertia,
                          std::span<const double> target, double tolerance,
                          std::span<Body<Dim>> bodies, std::span<double> lambda);

inline constexpr int most_gauss_seidel_sweeps = 20000;

}  // namespace lod
