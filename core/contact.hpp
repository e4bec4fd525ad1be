#pragma once

#include <optional>

#include "core/body.hpp"

namespace lod {

/// One place where two bodies are taken to touch. World frame, metres.
template <int Dim>
struct Contact {
    Vector<Dim> point = Vector<Dim>::Zero();   ///< on the line through the two centres
    Vector<Dim> normal = Vector<Dim>::Zero();  ///< unit, from body A towards body B
    double depth = 0;                          ///< overlap of the two balls, >= 0
};

/// Where on the centre line two overlapping balls are taken to touch.
enum class PointModel {
    radius_ratio,           ///< divides the line in the ratio of the radii (paper, eq. 5)
    plane_of_intersection,  ///< where the plane through the balls' intersection cuts the line
};

/// Models the contact of two balls (paper, eqs. 4 and 5). Balls of different levels may meet.
/// Returns nothing when they are apart.
///
/// Coincident centres have no normal; then `fallback` is used (the line of the centres of mass, A
/// to B), and the first axis where that is zero too. With the plane of intersection, a ball inside
/// the other has no such plane; then the point stays where the balls last touched from inside, on
/// the smaller ball's surface: within both balls, and without a jump. Equal balls with one centre
/// meet in that centre.
template <int Dim>
[[nodiscard]] std::optional<Contact<Dim>> model_contact(
    const Sphere<Dim>& a, const Sphere<Dim>& b, PointModel model = PointModel::radius_ratio,
    const Vector<Dim>& fallback = Vector<Dim>::Zero());

}  // namespace lod
