#pragma once

#include <cmath>
#include <cstdint>

#include "lodlab/core/response/touched_bodies.hpp"

namespace lod {

/// An impulse and its moment about the centre of mass.
template <int Dim>
struct ImpactPush {
    Vector<Dim> linear = Vector<Dim>::Zero();
    Spin<Dim> angular = Spin<Dim>::Zero();

    /// Its square by an inverse mass and inertia.
    [[nodiscard]] double inverse_norm(double inverse_mass, const Inertia<Dim>& inverse) const {
        return inverse_mass * linear.squaredNorm() + angular.dot(inverse * angular);
    }
};

/// What of a contact stays as it is while velocities change.
template <int Dim>
struct ImpactRow {
    Vector<Dim> normal;
    Spin<Dim> moment_a;  ///< r_a x n
    Spin<Dim> moment_b;
    double mass = 0;       ///< 1/K of equation (1); 0 where neither can move
    double direction = 0;  ///< d of this round; 0 where the contact parts
    std::int32_t contact = 0;

    /// Equation (3), and the size of the terms that it is the sum of.
    [[nodiscard]] double closing(const TouchedBody<Dim>& a, const TouchedBody<Dim>& b,
                                 double& size) const {
        const double linear_a = normal.dot(a.velocity);
        const double linear_b = normal.dot(b.velocity);
        const double angular_a = moment_a.dot(a.spin);
        const double angular_b = moment_b.dot(b.spin);
        size = std::abs(linear_a) + std::abs(linear_b) + std::abs(angular_a) + std::abs(angular_b);
        return (linear_b - linear_a) + (angular_b - angular_a);
    }
};

}  // namespace lod
