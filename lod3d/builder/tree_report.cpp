#include "lodlab/lod3d/builder/tree_report.hpp"

#include <algorithm>
#include <numbers>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/math/box_tree.hpp"
#include "lodlab/lod3d/builder/directions.hpp"
#include "lodlab/lod3d/builder/piece.hpp"

namespace lod3d {
namespace {

/// Samples the part of every sphere that no other ball covers. Its volume is a third of the
/// integral of x . n over it (Gauss).
lod::UnionMeasures sample_union(std::span<const lod::Sphere<3>> balls, const MeshDistance& distance,
                                double solid_volume, int samples) {
    const int each = std::max(100, samples / static_cast<int>(balls.size()));
    const std::vector<Point> directions = spread_directions(each);
    double area = 0;
    double distances = 0;
    double volume = 0;
    lod::UnionMeasures result;
    const std::vector<lod::Box<3>> boxes = lod::boxes_of<3>(balls);
    lod::BoxTree<3> tree(boxes);
    std::vector<const lod::Sphere<3>*> near;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        lod::check_interrupted();
        const lod::Sphere<3>& own = balls[i];
        near.clear();
        tree.each_meeting(boxes[i], [&](std::size_t j) {
            if (j != i && lod::overlap(own, balls[j])) near.push_back(&balls[j]);
        });
        const double patch = 4 * std::numbers::pi * own.radius * own.radius / each;
        for (const Point& u : directions) {
            const Point p = own.centre + own.radius * u;
            const bool hidden = std::any_of(near.begin(), near.end(), [&](const auto* ball) {
                return (p - ball->centre).squaredNorm() < ball->radius * ball->radius;
            });
            if (hidden) continue;
            area += patch;
            distances += patch * distance.distance(p);
            volume += patch * p.dot(u) / 3;
        }
    }
    result.measure_ratio = volume / solid_volume;
    if (area > 0) result.mean_protrusion = distances / area;
    return result;
}

}  // namespace

TreeReport report_tree(const Solid& solid, const lod::SphereTree<3>& tree,
                       const ReportSettings& settings) {
    const MeshDistance distance(solid.mesh, solid.inside_rule);
    const MeshPiece whole(solid, distance);
    return lod::report_levels<3>(
        tree, whole, distance, settings.tolerance, [&](std::span<const lod::Sphere<3>> balls) {
            return sample_union(balls, distance, solid.volume, settings.samples);
        });
}

}  // namespace lod3d
