#pragma once

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"

namespace lessons::inertia {

using lod::Body;
using Vec = lod::Vector<3>;

/// A box of 1 m x 0.6 m x 0.2 m and 12 kg, whose moments of inertia come out round.
struct Crate {
    double width = 1;     ///< along x [m]
    double height = 0.6;  ///< along y
    double depth = 0.2;   ///< along z
    double mass = 12;     ///< [kg]
    viz::Actor<3> actor;
};

[[nodiscard]] Crate make_crate();

/// A panel that shows the crate however it turns, and arrows that reach so far [m].
[[nodiscard]] viz::Panel panel_round(const Crate& crate, double reach);

/// Angular momentum I w about the centre of mass, world frame.
[[nodiscard]] lod::Spin<3> momentum_of(const Body<3>& body);

/// The angle between two vectors [degrees].
[[nodiscard]] double degrees_between(const Vec& a, const Vec& b);

/// "22.9°".
[[nodiscard]] Number degrees(double angle, int decimals = 1);

// Free rotation: the spin wanders, energy and angular momentum stay (tumbling.cpp).
void give_tumbling(Lesson& lesson, const Crate& crate);

}  // namespace lessons::inertia
