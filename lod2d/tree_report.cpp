#include "lod2d/tree_report.hpp"

#include <cmath>

#include "core/builder/certify.hpp"
#include "lod2d/disc_union.hpp"
#include "lod2d/distance.hpp"
#include "lod2d/piece.hpp"
#include "lod2d/protrusion.hpp"

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
    const auto certificates = lod::certify<2>(tree, whole);
    TreeReport report;
    report.bounding_diameter = 2 * lod::enclosing_ball<2>(whole.vertices()).radius;
    report.tolerance = settings.tolerance * report.bounding_diameter;
    for (int level = 0; level < tree.levels(); ++level) {
        lod::check_interrupted();
        std::vector<Disc> discs;
        for (const int node : tree.level_nodes(level)) discs.push_back(tree.sphere(node));
        const std::vector<Arc> arcs = exposed_arcs(discs);
        LevelReport entry;
        entry.level = level;
        entry.nodes = static_cast<int>(discs.size());
        entry.worst_protrusion = find_protrusion(index, discs, report.tolerance).most;
        entry.mean_protrusion = mean_distance(index, discs, arcs, settings.samples);
        entry.worst_protrusion_fraction = entry.worst_protrusion / report.bounding_diameter;
        entry.mean_protrusion_fraction = entry.mean_protrusion / report.bounding_diameter;
        entry.measure_ratio = union_area(discs, arcs) / shape.area;
        entry.uncovered = certificates[static_cast<std::size_t>(level)].uncovered;
        entry.certified = certificates[static_cast<std::size_t>(level)].certified;
        report.levels.push_back(entry);
    }
    return report;
}

}  // namespace lod2d
