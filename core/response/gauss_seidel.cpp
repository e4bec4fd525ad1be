#include "lodlab/core/response/gauss_seidel.hpp"

#include <algorithm>
#include <cmath>

namespace lod {

template <int Dim>
int solve_by_gauss_seidel(const NewtonImpacts<Dim>& task, std::span<Body<Dim>> bodies,
                          std::span<double> lambda) {
    const auto& [contacts, impacts, inverse_inertia, target, tolerance] = task;
    for (std::int32_t contact : contacts) lambda[static_cast<std::size_t>(contact)] = 0;
    for (int sweep = 1; sweep <= most_gauss_seidel_sweeps; ++sweep) {
        double most_change = 0;
        for (std::int32_t contact : contacts) {
            const auto i = static_cast<std::size_t>(contact);
            const auto a = static_cast<std::size_t>(impacts[i].a);
            const auto b = static_cast<std::size_t>(impacts[i].b);
            const Contact<Dim>& touch = impacts[i].contact;
            const double K = inverse_effective_mass(bodies[a], inverse_inertia[a], bodies[b],
                                                    inverse_inertia[b], touch);
            if (K == 0) continue;
            const double u = closing_velocity(bodies[a], bodies[b], touch);
            const double wanted = std::max(0.0, lambda[i] + (target[i] - u) / K);
            const double change = wanted - lambda[i];
            lambda[i] = wanted;
            apply_impulse<Dim>({bodies[a], inverse_inertia[a]}, {bodies[b], inverse_inertia[b]},
                               touch, change);
            most_change = std::max(most_change, std::abs(change) * K);
        }
        if (most_change <= tolerance) return sweep;
    }
    return most_gauss_seidel_sweeps;
}

#define LOD_INSTANTIATE(Dim)                                                            \
    template int solve_by_gauss_seidel(const NewtonImpacts<Dim>&, std::span<Body<Dim>>, \
                                       std::span<double>);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
