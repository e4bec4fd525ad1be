#pragma once

#include <span>
#include <vector>

#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lod3d {

/// Cuts a polygon in space, convex or not, into triangles turned as it is: appends to `triangles`
/// the places of their corners in `corners`, two less than there are corners. A polygon with a hole
/// may be one that runs to the hole and back along a seam.
///
/// A polygon that is not flat is cut as its shadow on the nearest plane of two axes is. One that
/// crosses itself is cut somehow; every side stays a side of one triangle in any case, so that a
/// closed surface stays closed. Takes time in the corners times those that point inwards; throws
/// lod::Error (limit exceeded) where that would be more than some seconds.
/// Requires: at least 3 corners, all finite, fewer than 2^31.
void cut_polygon(std::span<const Point> corners, std::vector<Triangle>& triangles);

}  // namespace lod3d
