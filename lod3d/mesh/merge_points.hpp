#pragma once

#include <span>

#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lod3d {

/// Points that are taken for one.
struct MergedPoints {
    std::vector<std::int32_t> into;  ///< of each point the one that stands for it, maybe itself
    std::uint64_t steps = 0;         ///< cells and points looked at, in all
};

/// In the order of x, then y, z and number: a point stands for itself, unless one before it that
/// does is no further away than the tolerance [m] on any axis; then the first of those stands for
/// it. Requires: tolerance >= 0, usable points.
[[nodiscard]] MergedPoints merge_points(std::span<const Point> points, double tolerance);

}  // namespace lod3d
