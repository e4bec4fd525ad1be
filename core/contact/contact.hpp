#pragma once

/// \file
/// A contact of two bodies, and how it comes from two nodes that overlap: the contact models, by
/// name.

#include <cstddef>
#include <optional>

#include "lodlab/core/base/names.hpp"
#include "lodlab/core/math/half_space.hpp"
#include "lodlab/core/tree/body.hpp"

namespace lod {

/// One place where two bodies are taken to touch. World frame, metres.
template <int Dim>
struct Contact {
    Vector<Dim> point = Vector<Dim>::Zero();   ///< where they touch: see ContactModel
    Vector<Dim> normal = Vector<Dim>::Zero();  ///< unit, from body A towards body B
    double depth = 0;                          ///< overlap of what touches: balls, hulls
};

/// Points of one place where two bodies touch, at most: with one normal the closing velocity is
/// affine in the point, so that the extremes decide.
template <int Dim>
inline constexpr std::size_t most_patch_points = 2 * (Dim - 1);

/// Where on the centre line two overlapping balls are taken to touch.
enum class PointModel {
    radius_ratio,           ///< divides the line in the ratio of the radii (paper, eq. 5)
    plane_of_intersection,  ///< where the plane through the balls' intersection cuts the line
};
/// Their words in scenes, options and messages.
[[nodiscard]] constexpr std::array<std::string_view, 2> names_of(PointModel) {
    return {"radius_ratio", "plane_of_intersection"};
}
static_assert(names_of(PointModel{}).size() ==
              static_cast<std::size_t>(PointModel::plane_of_intersection) + 1);

/// Where the normal of a contact comes from.
enum class ContactModel {
    centre_line,  ///< from A's centre to B's (paper, eq. 4)
    node_normal,  ///< the surfaces that the two nodes stand for, as far as each is flat
    hull,         ///< the convex hulls of what the two nodes stand for
};
/// Their words in scenes, options and messages.
[[nodiscard]] constexpr std::array<std::string_view, 3> names_of(ContactModel) {
    return {"centre_line", "node_normal", "hull"};
}
static_assert(names_of(ContactModel{}).size() == static_cast<std::size_t>(ContactModel::hull) + 1);

/// How contacts are modelled.
struct ContactChoice {
    ContactModel contact_model = ContactModel::hull;
    PointModel point_model = PointModel::radius_ratio;
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

/// The same of a ball, A, and a half-space, B, or the other way round with `swapped`: what eq. 5
/// tends to as one ball grows. The point is the deepest of the ball (radius_ratio) or the one of
/// the border above it (plane_of_intersection). Requires: a unit normal.
template <int Dim>
[[nodiscard]] std::optional<Contact<Dim>> model_border_contact(const Sphere<Dim>& ball,
                                                               const HalfSpace<Dim>& half_space,
                                                               bool swapped, PointModel model);

/// A node that meets another: its ball, and the mean outward unit normal of the surface that it
/// stands for, world frame. The normal's length, the coherence, is 1 on a flat face and near 0 on a
/// corner; zero where nothing is known (SphereTree::normal).
template <int Dim>
struct SurfaceNode {
    Sphere<Dim> ball;
    Vector<Dim> mean_normal = Vector<Dim>::Zero();
};

/// Models the contact of two nodes by their surfaces (ContactModel::node_normal): point and depth
/// are those of the two balls, the normal is along
///     w_a n_a - w_b n_b + (1 - max(w_a, w_b))^2 l,   w = coherence^coherence_power,
/// where n_a and n_b are the unit mean normals and l is the normal of the centre line. Nearly flat
/// surfaces decide; where neither is flat the line does, and where nothing is known it is all.
///
/// Where the three cancel (two flat surfaces that face the same way, one body within the other) the
/// centre line is used: when what is left of them is shorter than least_blend.
template <int Dim>
[[nodiscard]] std::optional<Contact<Dim>> model_surface_contact(
    const SurfaceNode<Dim>& a, const SurfaceNode<Dim>& b,
    PointModel model = PointModel::radius_ratio, const Vector<Dim>& fallback = Vector<Dim>::Zero());

inline constexpr int coherence_power = 16;
inline constexpr double least_blend = 1e-6;

}  // namespace lod
