#include "lod2d/disc_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/builder/enclosing_ball.hpp"
#include "lod2d/protrusion.hpp"

namespace lod2d {
namespace {

/// R(x) - depth(x), to be made least.
class Excess {
  public:
    Excess(const BoundaryIndex& shape, std::span<const Point> corners, double most_radius)
        : shape_(shape), corners_(corners), most_radius_(most_radius) {}

    [[nodiscard]] double most_radius() const { return most_radius_; }

    [[nodiscard]] double radius(const Point& x) const {
        return lod::farthest_distance<2>(x, corners_);
    }
    [[nodiscard]] double operator()(const Point& x) const {
        return radius(x) + shape_.signed_distance(x);
    }
    [[nodiscard]] const BoundaryIndex& shape() const { return shape_; }

  private:
    const BoundaryIndex& shape_;
    std::span<const Point> corners_;
    double most_radius_;
};

/// Compass search: eight ways from the best point so far; a step that finds nothing is halved.
Point walk_downhill(const Excess& excess, Point best, double step, double least_step) {
    static const std::array<Point, 8> ways = [] {
        const double s = std::sqrt(0.5);
        return std::array<Point, 8>{Point(1, 0), Point(0, 1),  Point(-1, 0),  Point(0, -1),
                                    Point(s, s), Point(-s, s), Point(-s, -s), Point(s, -s)};
    }();
    double least = excess(best);
    double depth = excess.radius(best) - least;
    // A step changes the excess by at most twice its length.
    while (step > std::max(least_step, 0.005 * least)) {
        Point next = best;
        for (const Point& way : ways) {
            const Point x = best + step * way;
            // Depth changes by no more than one moves.
            const double radius = excess.radius(x);
            if (radius > excess.most_radius() || radius - depth - step >= least) continue;
            const double value = excess(x);
            if (value >= least) continue;
            least = value;
            next = x;
        }
        if (next == best) {
            step /= 2;
        } else {
            best = next;
            depth = excess.radius(best) - least;
        }
    }
    return best;
}

double cross(const Point& o, const Point& a, const Point& b) {
    return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

}  // namespace

std::vector<Point> convex_hull(std::span<const Point> points) {
    std::vector<Point> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(), [](const Point& a, const Point& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return sorted;
    std::vector<Point> hull;
    const auto chain = [&](auto begin, auto end) {
        const std::size_t base = hull.size();
        for (auto p = begin; p != end; ++p) {
            while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), *p) <= 0)
                hull.pop_back();
            hull.push_back(*p);
        }
        hull.pop_back();
    };
    chain(sorted.begin(), sorted.end());
    chain(sorted.rbegin(), sorted.rend());
    return hull;
}

lod::Sphere<2> DiscFit::fit(const PolygonPiece& piece, const lod::Sphere<2>& start) const {
    const std::vector<Point> corners = convex_hull(piece.vertices());
    const lod::Sphere<2> least_disc = lod::enclosing_ball<2>(corners);
    const Excess excess(shape_, corners, most_growth_ * least_disc.radius);
    const bool start_small = excess.radius(start.centre) <= excess.most_radius();
    const double from_start = excess(start.centre);
    const double from_least = excess(least_disc.centre);
    const Point from = start_small && from_start < from_least ? start.centre : least_disc.centre;
    const double reach = std::max(excess.radius(from), least_disc.radius);
    const Point centre = walk_downhill(excess, from, reach / 4, reach * 1e-5);
    // Rounding in the hull may drop a corner that stands out of it by a hair.
    return {centre, lod::farthest_distance<2>(centre, piece.vertices()) + spare_};
}

double DiscFit::protrusion(const lod::Sphere<2>& disc) const {
    const double bound = protrusion_bound(shape_, disc);
    if (bound <= 4 * spare_) return bound;
    return find_protrusion(shape_, std::span(&disc, 1), bound / 20, 20000).most;
}

}  // namespace lod2d
