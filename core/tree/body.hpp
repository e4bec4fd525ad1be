#pragma once

/// \file
/// A rigid body: where it is, how it moves, its mass, its tree. You make these; a frame moves them.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lodlab/core/tree/tree.hpp"

namespace lod {

template <int Dim>
class ExactShape;

/// A rigid body (the paper's figure 7). World frame unless said otherwise; SI units.
/// A static body has inverse_mass = 0 and inverse_inertia = 0: no impulse moves it.
template <int Dim>
struct Body {
    double inverse_mass = 0;                              ///< [1/kg], >= 0
    Inertia<Dim> inertia = Inertia<Dim>::Zero();          ///< body frame [kg m^2]
    Inertia<Dim> inverse_inertia = Inertia<Dim>::Zero();  ///< body frame
    double restitution = 1;                               ///< 0 to 1; a pair takes the smaller

    Vector<Dim> position = Vector<Dim>::Zero();  ///< of the centre of mass [m]
    Orientation<Dim> orientation = Space<Dim>::unturned();
    Vector<Dim> velocity = Vector<Dim>::Zero();  ///< of the centre of mass [m/s]
    Spin<Dim> spin = Spin<Dim>::Zero();          ///< [rad/s]

    std::shared_ptr<const SphereTree<Dim>> tree;  ///< the paper's body_S
    /// The true shape, for the finest level of detail; without it the body stops at its leaves.
    std::shared_ptr<const ExactShape<Dim>> exact;

    /// Whether no impulse moves it.
    [[nodiscard]] bool is_static() const { return inverse_mass == 0; }
};

/// Gives the body a mass and an inertia about its centre of mass, body frame.
/// Requires mass > 0 and a positive definite inertia; otherwise throws Error (input refused).
template <int Dim>
void set_mass(Body<Dim>& body, double mass, const Inertia<Dim>& inertia);

/// Makes the body one that no impulse moves.
template <int Dim>
void make_static(Body<Dim>& body);

/// Throws Error (input refused), naming the body, unless every number is finite, the restitution is
/// within 0..1, and the tree is there.
template <int Dim>
void check_body(const Body<Dim>& body, const std::string& name);

/// Velocity of the body's material point at arm r (world frame, from the centre of mass).
template <int Dim>
[[nodiscard]] Vector<Dim> velocity_at(const Body<Dim>& body, const Vector<Dim>& r) {
    return body.velocity + Space<Dim>::cross(body.spin, r);
}

/// I^-1 carried to the world frame.
template <int Dim>
[[nodiscard]] Inertia<Dim> world_inverse_inertia(const Body<Dim>& body) {
    return Space<Dim>::carried(body.orientation, body.inverse_inertia);
}

/// Sums over the bodies that can move.
template <int Dim>
[[nodiscard]] double kinetic_energy(std::span<const Body<Dim>> bodies);  ///< [J]
template <int Dim>
[[nodiscard]] Vector<Dim> momentum(std::span<const Body<Dim>> bodies);  ///< [kg m/s]
template <int Dim>
[[nodiscard]] Spin<Dim> angular_momentum(std::span<const Body<Dim>> bodies);  ///< about the origin

}  // namespace lod
