#pragma once

/// \file
/// A polygon cut into convex parts.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// Convex polygons, anticlockwise, in one array of corners.
struct ConvexParts {
    std::vector<Point> corners;
    std::vector<std::int32_t> begin{0};  ///< part i is [begin[i], begin[i + 1]) of the corners

    /// How many polygons.
    [[nodiscard]] std::size_t count() const { return begin.size() - 1; }
    /// The corners of one of them.
    [[nodiscard]] std::span<const Point> part(std::size_t i) const {
        const auto first = static_cast<std::size_t>(begin[i]);
        return std::span(corners).subspan(first, static_cast<std::size_t>(begin[i + 1]) - first);
    }
    /// All corners since the last one are a polygon.
    void end_part() { begin.push_back(static_cast<std::int32_t>(corners.size())); }
};

/// A polygon cut into convex parts that meet in their borders only and whose union is the polygon,
/// up to rounding of cut points along its edges (a few units in the last place).
/// Method: a vertical line sweeps over the polygon; between two neighbouring abscissae of vertices
/// the edges are ordered and taken in pairs, and the trapezoids so found are joined while they stay
/// convex. Rings that touch, and edges that rounding has made to cross by a hair, do no harm: no
/// step depends on the rings being joined well. About O(n a) for n edges, a of them over one
/// abscissa.
[[nodiscard]] ConvexParts convex_parts(const Polygon& polygon);

/// The same parts, those with more than `most` corners cut in halves, from corner to corner, until
/// none has more. Requires most >= 3.
[[nodiscard]] ConvexParts with_at_most(const ConvexParts& parts, std::size_t most);

}  // namespace lod2d
