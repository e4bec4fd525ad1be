#include "lodlab/lod2d/builder/tree_report.hpp"

#include <cmath>

#include "lodlab/lod2d/builder/piece.hpp"
#include "lodlab/lod2d/shape/disc_union.hpp"
#include "lodlab/lod2d/shape/distance.hpp"

namespace lod2d {
namespace {

using Disc = lod::Sphere<2>;

/// Mean distance of the arcs' points to the shape, by the midpoint rule.
double mean_distance(const BoundaryIndex& shape, std::span<const Disc> discs,
                     std::span<const Arc> arcs, int samples) {
    double length = 0;
    for (const Arc& arc : arcs) length += discs[arc.disc].radius * (arc.to - arc.from);
    if (length == 0) return 0;
    double sum = 0;
    for (const Arc& arc : arcs) {
        const Disc& disc = discs[arc.disc];
        const double arc_length = disc.radius * (arc.to - arc.from);
        const int count = 1 + static_cast<int>(samples * arc_length / length);
        double arc_sum = 0;
        for (int i = 0; i < count; ++i) {
            const double angle = arc.from + (arc.to - arc.from) * (i + 0.5) / count;
            arc_sum += shape.distance(arc.at(disc, angle));
        }
        sum += arc_sum / count * arc_length;
    }
    return sum / length;
}

}  // namespace

TreeReport report_tree(const Shape& shape, const lod::SphereTree<2>& tree,
                       const ReportSettings& settings) {
    const BoundaryIndex index(shape.polygon);
    const PolygonPiece whole(shape.polygon);
    return lod::report_levels<2>(
        tree, whole, index, settings.tolerance, [&](std::span<const Disc> discs) {
            const std::vector<Arc> arcs = exposed_arcs(discs);
            return lod::UnionMeasures{mean_distance(index, discs, arcs, settings.samples),
                                      union_area(discs, arcs) / shape.area};
        });
}

}  // namespace lod2d
