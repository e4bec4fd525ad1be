#pragma once

#include <span>

#include "core/sphere.hpp"
#include "lod2d/distance.hpp"

namespace lod2d {

/// How far a union of discs stands out of a shape: the largest distance of a point of it to the
/// shape. The true value lies in [least, most].
struct Protrusion {
    double least = 0;
    double most = 0;
    Point at = {0, 0};  ///< a point of the union whose distance is `least`
};

/// What a disc at most stands out by [m], 0 or more: its radius less the depth of its centre. Exact
/// unless the disc reaches over a pocket or a hole of the shape.
[[nodiscard]] double protrusion_bound(const BoundaryIndex& shape, const lod::Sphere<2>& disc);

/// Branch and bound over squares: distance to the shape changes by no more than one moves. Ends
/// when most - least is within the tolerance [m], > 0, or after so many queries.
[[nodiscard]] Protrusion find_protrusion(const BoundaryIndex& shape,
                                         std::span<const lod::Sphere<2>> discs, double tolerance,
                                         int most_queries = 2'000'000);

}  // namespace lod2d
