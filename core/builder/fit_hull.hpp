#pragma once

#include <span>

#include "lodlab/core/tree/hull.hpp"

namespace lod {

/// A convex polygon or polytope of at most most_hull_faces faces that holds all points, with
/// `margin` to spare [m], and stands out of their convex hull as little as its faces allow: from
/// the box along the axes, face after face, each where the rest stands out furthest. `corners` are
/// those of the points that matter for where faces go (all, or those that lie outermost in many
/// directions); `normals` are directions to try first, unit: those of the faces of the points'
/// convex hull, where they are known, give it exactly if they are few enough. Requires: points,
/// corners not empty, margin > 0.
template <int Dim>
[[nodiscard]] Hull<Dim> fit_hull(std::span<const Vector<Dim>> points,
                                 std::span<const Vector<Dim>> corners,
                                 std::span<const Vector<Dim>> normals, double margin);

/// The largest of normal . p over the points. Requires: some.
template <int Dim>
[[nodiscard]] double support(std::span<const Vector<Dim>> points, const Vector<Dim>& normal);

}  // namespace lod
