#pragma once

#include <span>
#include <vector>

#include "lodlab/core/math/sphere.hpp"

namespace lod {

/// Starts for dividing a piece into `count` parts: balls of equal radius, so that their power
/// diagram is the Voronoi diagram of their centres. Fewer where the points are fewer.
/// Deterministic.

/// Centres far from each other: each next is the point farthest from those before (Gonzalez 1985);
/// the first is the one farthest from the points' mean.
template <int Dim>
[[nodiscard]] std::vector<Sphere<Dim>> far_apart(std::span<const Vector<Dim>> points, int count);

/// Centres side by side along the points' longest axis, spaced evenly: slices.
template <int Dim>
[[nodiscard]] std::vector<Sphere<Dim>> along_longest_axis(std::span<const Vector<Dim>> points,
                                                          int count);

}  // namespace lod
