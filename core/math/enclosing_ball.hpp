#pragma once

#include <span>

#include "lodlab/core/math/sphere.hpp"

namespace lod {

/// The least ball that holds every point, to within rounding: its radius is the largest computed
/// distance to a point, and at most 1e-12 of it more than the least possible. Deterministic.
/// No points give a ball of radius 0 at the origin. Requires finite coordinates.
/// Method: a basis of at most Dim + 1 points grows by the farthest point outside (Gaertner 1999),
/// and the new basis is the best of the few subsets, so that degenerate points do no harm.
template <int Dim>
[[nodiscard]] Sphere<Dim> enclosing_ball(std::span<const Vector<Dim>> points);

/// Distance of the point farthest from the centre; 0 without points.
template <int Dim>
[[nodiscard]] double farthest_distance(const Vector<Dim>& centre,
                                       std::span<const Vector<Dim>> points);

/// What computed distances, cuts and radii of a tree may be wrong by, and more: 1e-13 of the root
/// ball's radius and its distance from the origin. Builders add it to every radius; the certificate
/// asks for half of it.
template <int Dim>
[[nodiscard]] double rounding_bound(const Sphere<Dim>& root) {
    return 1e-13 * (root.radius + root.centre.norm());
}

}  // namespace lod
