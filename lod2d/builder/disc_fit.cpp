#include "lodlab/lod2d/builder/disc_fit.hpp"

#include <algorithm>

#include "lodlab/core/builder/least_excess.hpp"

namespace lod2d {
lod::Sphere<2> DiscFit::fit(const PolygonPiece& piece, const lod::Sphere<2>& start) const {
    const std::vector<Point> corners = convex_hull(piece.vertices());
    const lod::Sphere<2> least_disc = lod::enclosing_ball<2>(corners);
    lod::ExcessWalk walk;
    walk.most_radius = most_growth_ * least_disc.radius;
    const bool start_small = lod::farthest_distance<2>(start.centre, corners) <= walk.most_radius;
    const double from_start = lod::excess<2>(shape_, corners, start.centre);
    const double from_least = lod::excess<2>(shape_, corners, least_disc.centre);
    const Point from = start_small && from_start < from_least ? start.centre : least_disc.centre;
    const double reach = std::max(lod::farthest_distance<2>(from, corners), least_disc.radius);
    walk.step = reach / 4;
    walk.least_step = reach * 1e-5;
    const Point centre = lod::least_excess_near<2>(shape_, corners, from, walk);
    // Rounding in the hull may drop a corner that stands out of it by a hair.
    return {centre, lod::farthest_distance<2>(centre, piece.vertices()) + spare_};
}

double DiscFit::protrusion(const lod::Sphere<2>& disc) const {
    return lod::protrusion_from_above<2>(shape_, disc, spare_, 20000);
}

}  // namespace lod2d
