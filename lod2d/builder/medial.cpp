#include "lodlab/lod2d/builder/medial.hpp"

#include <cmath>

#include "lodlab/core/builder/seeds.hpp"
#include "lodlab/lod2d/builder/disc_fit.hpp"
#include "lodlab/lod2d/builder/medial_axis.hpp"
#include "lodlab/lod2d/builder/medial_cover.hpp"

namespace lod2d {
namespace {

using Disc = lod::Sphere<2>;

/// Every n-th of them, at most `most`.
std::vector<Point> thinned(const std::vector<Point>& points, std::size_t most) {
    if (points.size() <= most) return points;
    std::vector<Point> few;
    for (std::size_t i = 0; i < most; ++i) few.push_back(points[i * points.size() / most]);
    return few;
}

class MedialStarts : public DiscFit {
  public:
    MedialStarts(const Polygon& polygon, const BoundaryIndex& shape, double spare,
                 const MedialConfig& config)
        : DiscFit(shape, spare, config.grow.normal_weight > 0 ? config.most_growth : no_limit),
          axis_(polygon),
          samples_(config.samples),
          normal_weight_(config.grow.normal_weight) {
        for (const Ring& ring : polygon.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                edges_.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
    }

    [[nodiscard]] std::vector<std::vector<Disc>> starts(const PolygonPiece& piece, const Disc&,
                                                        int count) const {
        const std::vector<Point> corners = convex_hull(piece.vertices());
        std::vector<FacingPoint> points;
        for (const Point& p : thinned(corners, static_cast<std::size_t>(samples_)))
            points.push_back({p, Point(0, 0)});
        std::vector<FacingDisc> discs;
        gather(piece, points, discs);
        std::vector<std::vector<Disc>> result{
            least_growth_cover(points, discs, count, normal_weight_)};
        if (result[0].empty()) result.clear();
        result.push_back(lod::far_apart<2>(piece.vertices(), count));
        result.push_back(lod::along_longest_axis<2>(corners, count));
        return result;
    }

  private:
    /// Points spread along the piece's border, closer together at the ends of its segments, where a
    /// corner may be, and the largest discs that touch the border there.
    void gather(const PolygonPiece& piece, std::vector<FacingPoint>& points,
                std::vector<FacingDisc>& discs) const {
        const double length = piece.surface_measure();
        double passed = 0;
        double next = 0;
        const double step = length / samples_;
        for (const BorderSegment& segment : piece.border()) {
            const double own = (segment.to - segment.from).norm();
            for (; next < passed + own; next += step)
                gather(segment, (next - passed) / own, points, discs);
            passed += own;
            if (own < 2 * step) continue;
            for (double share = 0.5 * step / own; share > 0.01 * step / own; share /= 2) {
                gather(segment, share, points, discs);
                gather(segment, 1 - share, points, discs);
            }
        }
    }

    void gather(const BorderSegment& segment, double share, std::vector<FacingPoint>& points,
                std::vector<FacingDisc>& discs) const {
        const Point p = segment.from + share * (segment.to - segment.from);
        points.push_back({p, segment.normal});
        const auto& [from, to] = edges_[static_cast<std::size_t>(segment.edge)];
        const double t = (p - from).dot(to - from) / (to - from).squaredNorm();
        if (const auto disc = axis_.touching(segment.edge, std::clamp(t, 0.0, 1.0))) {
            discs.push_back({*disc, segment.normal});
            // The largest disc serves the other side as well; a smaller one here serves this alone.
            if (normal_weight_ > 0)
                discs.push_back({{p + own_share * (disc->centre - p), own_share * disc->radius},
                                 segment.normal});
        }
        if (share < 1e-3 && segment.from == from)
            for (const Disc& disc : axis_.at_corner(segment.edge))
                discs.push_back({disc, Point(0, 0)});
    }

    static constexpr double no_limit = 1e9;
    static constexpr double own_share = 0.7;
    MedialAxis axis_;
    int samples_;
    double normal_weight_;
    std::vector<std::pair<Point, Point>> edges_;
};

}  // namespace

lod::SphereTree<2> build_medial(const Polygon& polygon, const PolygonPiece& whole,
                                const BoundaryIndex& shape, const MedialConfig& config) {
    if (config.samples < 8 || config.samples > 512)
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         "cannot build the tree: " + std::to_string(config.samples) +
                             " samples are out of range; choose 8 to 512");
    if (!(config.most_growth >= 1))
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         "cannot build the tree: the growth is out of range; choose 1 or more");
    lod::check_grow_settings(config.grow);
    const Disc root = lod::root_ball<2>(whole);
    const MedialStarts strategy(polygon, shape, lod::rounding_bound(root), config);
    return lod::grow_tree<2>(whole, root, strategy, config.grow);
}

}  // namespace lod2d
