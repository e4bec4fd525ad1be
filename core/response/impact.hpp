#pragma once

/// \file
/// The mechanics of one contact: closing velocity, compliance, impulse.

#include <cstdint>

#include "lodlab/core/contact/contact.hpp"

namespace lod {

/// One contact of the response stage: what touches, where, and which collision it belongs to.
template <int Dim>
struct Impact {
    std::int32_t a = 0;     ///< index of body A
    std::int32_t b = 0;     ///< index of body B
    std::int32_t pair = 0;  ///< contacts of one body pair carry the same number
    Contact<Dim> contact;
};

/// Closing velocity v_c at a contact (paper, eq. 3): the normal part of B's velocity relative to
/// A's [m/s]. Negative when the bodies approach.
template <int Dim>
[[nodiscard]] double closing_velocity(const Body<Dim>& a, const Body<Dim>& b,
                                      const Contact<Dim>& contact);

/// K of equation (1) [1/kg]: how much v_c changes for a unit impulse along the normal.
template <int Dim>
[[nodiscard]] double inverse_effective_mass(const Body<Dim>& a, const Body<Dim>& b,
                                            const Contact<Dim>& contact);

/// The same with I^-1 of both bodies carried to the world frame already.
template <int Dim>
[[nodiscard]] double inverse_effective_mass(const Body<Dim>& a, const Inertia<Dim>& inverse_a,
                                            const Body<Dim>& b, const Inertia<Dim>& inverse_b,
                                            const Contact<Dim>& contact);

/// Restitution of a pair: the smaller of the two. Of bodies, or of what is kept of them.
template <class AnyBody>
[[nodiscard]] double pair_restitution(const AnyBody& a, const AnyBody& b) {
    return b.restitution < a.restitution ? b.restitution : a.restitution;
}

/// The impulse of a single contact (paper, eq. 1) [N s], >= 0; 0 when the bodies are parting
/// already or neither can move. Restitution is the smaller of the two.
template <int Dim>
[[nodiscard]] double single_impulse(const Body<Dim>& a, const Body<Dim>& b,
                                    const Contact<Dim>& contact);

/// Pushes B along +n and A along -n with the impulse j [N s] at the contact point.
template <int Dim>
void apply_impulse(Body<Dim>& a, Body<Dim>& b, const Contact<Dim>& contact, double j);

/// A body and its I^-1, carried to the world frame already.
template <int Dim>
struct PushedBody {
    Body<Dim>& body;
    const Inertia<Dim>& inverse_inertia;
};

/// The same of such bodies.
template <int Dim>
void apply_impulse(const PushedBody<Dim>& a, const PushedBody<Dim>& b, const Contact<Dim>& contact,
                   double j);

}  // namespace lod
