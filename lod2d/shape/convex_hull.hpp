#pragma once

#include <span>
#include <vector>

#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// Corners of the convex hull, anticlockwise; all points where they are fewer than three.
[[nodiscard]] std::vector<Point> convex_hull(std::span<const Point> points);

}  // namespace lod2d
