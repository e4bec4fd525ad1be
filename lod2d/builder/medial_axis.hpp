#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "lodlab/core/math/sphere.hpp"
#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// The inner medial axis of a polygon: the centres of the largest discs within it, found by where
/// they touch the border. Exact up to rounding: Boost.Polygon's Voronoi diagram of the edges says
/// which other edge or corner the disc touches, and its centre follows in closed form.
/// The diagram works on whole numbers; edges that cross once they are rounded to 2^-28 of the
/// shape's extent are left out, and discs there may be too large.
class MedialAxis {
  public:
    explicit MedialAxis(const Polygon& polygon);

    /// The largest disc within the polygon that touches an edge at from + t (to - from), 0 <= t
    /// <= 1. Edges are counted over the rings in order. Nothing where the diagram has a gap (a
    /// convex corner, an edge that was left out).
    [[nodiscard]] std::optional<lod::Sphere<2>> touching(std::int32_t edge, double t) const;

    /// Largest discs that touch two corners or more, or end a fan of discs that touch one corner;
    /// by the corner at which an edge starts. Empty for convex corners.
    [[nodiscard]] const std::vector<lod::Sphere<2>>& at_corner(std::int32_t edge) const {
        return at_corner_[static_cast<std::size_t>(edge)];
    }

  private:
    struct Edge {
        Point from;
        Point to;
        Point inward;  ///< unit normal
    };
    /// While t is in [begin, end] the disc touches this edge, or this point, too.
    struct Span {
        double begin;
        double end;
        std::int32_t other_edge;  ///< -1: a point
        Point point;
    };
    class Reading;

    std::vector<Edge> edges_;
    std::vector<std::vector<Span>> spans_;  ///< of each edge, by `begin`
    std::vector<std::vector<lod::Sphere<2>>> at_corner_;
};

/// The release of Boost.Polygon, whose Voronoi diagram this is: "1_74".
[[nodiscard]] std::string_view medial_axis_release();

}  // namespace lod2d
