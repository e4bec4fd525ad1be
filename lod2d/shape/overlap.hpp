#pragma once

/// \file
/// Whether two regions of the plane share a point, and how far apart they are.

#include "lodlab/lod2d/shape/distance.hpp"

namespace lod2d {

/// The shortest way from one region to another.
struct ClosestPoints {
    Point on_a = {0, 0};
    Point on_b = {0, 0};
    double distance = 0;  ///< 0 when the regions share a point; then the two points are not set [m]
};

/// Whether two closed regions, both in the world frame (BoundaryIndex::carry), share a point: an
/// edge of one meets an edge of the other, or one region holds a part of the other. Exact for the
/// coordinates given; carrying rounds them by a few units in the last place of the position.
/// Regions that only touch overlap. The oracle of every interruption test.
[[nodiscard]] bool overlap(const BoundaryIndex& a, const BoundaryIndex& b);
/// The same of two shapes where they stand.
[[nodiscard]] bool overlap(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);

/// The shortest way between two regions, both in the world frame.
[[nodiscard]] ClosestPoints closest_points(const BoundaryIndex& a, const BoundaryIndex& b);
/// Between the two regions, 0 when they share a point [m].
[[nodiscard]] double distance(const BoundaryIndex& a, const BoundaryIndex& b);

}  // namespace lod2d
