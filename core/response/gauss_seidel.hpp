#pragma once

#include <cstdint>
#include <span>

#include "lodlab/core/response/impact.hpp"

namespace lod {

/// Contacts to be solved together. All arrays but `contacts` are indexed like `impacts`.
template <int Dim>
struct NewtonImpacts {
    std::span<const std::int32_t> contacts;
    std::span<const Impact<Dim>> impacts;
    std::span<const Inertia<Dim>> world_inverse_inertia;  ///< of each body
    std::span<const double> target;                       ///< closing velocities [m/s]
    double tolerance = 0;                                 ///< of them [m/s]
};

/// Frictionless Newton impacts, a linear complementarity problem: finds for each of `contacts` an
/// impulse lambda >= 0 such that afterwards its closing velocity is u >= target, and lambda is 0
/// where u > target. Changes the bodies' velocities and spins and writes lambda, indexed like
/// `impacts`.
///
/// Projected Gauss-Seidel on the velocities, which are unique where the impulses are not; stops
/// when a sweep changes no closing velocity by more than `tolerance` [m/s], or after
/// most_gauss_seidel_sweeps. A reference: its cost grows faster than the number of contacts.
/// Returns the sweeps.
template <int Dim>
int solve_by_gauss_seidel(const NewtonImpacts<Dim>& task, std::span<Body<Dim>> bodies,
                          std::span<double> lambda);

inline constexpr int most_gauss_seidel_sweeps = 20000;

}  // namespace lod
