#pragma once

/// \file
/// How well each level of a tree fits its shape, in numbers.

#include <utility>
#include <vector>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/builder/certify.hpp"
#include "lodlab/core/builder/node_hulls.hpp"
#include "lodlab/core/builder/protrusion.hpp"

namespace lod {

/// What one level of a tree (the nodes of the level and the leaves above it) is worth.
struct LevelReport {
    int level = 0;
    int nodes = 0;
    /// Largest distance of a point of the balls' union to the shape [m]: never less than the true
    /// one, and more by at most TreeReport::tolerance.
    double worst_protrusion = 0;
    double mean_protrusion = 0;            ///< over the union's border [m]
    double worst_protrusion_fraction = 0;  ///< of the bounding ball's diameter
    double mean_protrusion_fraction = 0;
    double measure_ratio = 0;  ///< area or volume of the union over the shape's, >= 1 if certified
    double uncovered = 0;      ///< upper bound of the share of the measure without a chain of balls
    bool certified = false;    ///< the level covers the shape (core/builder/certify.hpp)
    bool hulls_certified = false;  ///< every node's hull holds its piece (certify_hulls)
};

/// What every level of a tree is worth.
struct TreeReport {
    double bounding_diameter = 0;  ///< of the shape's least enclosing ball [m]
    double tolerance = 0;          ///< of the worst protrusions [m]
    std::vector<LevelReport> levels;
};

/// What a union of balls is, as the plane and space measure it.
struct UnionMeasures {
    double mean_protrusion = 0;  ///< over its border [m]
    double measure_ratio = 0;    ///< of its area or volume to the shape's
};

/// Measures every level of a tree against the shape: its whole as a piece, distances from it, and
/// measure_union(balls) -> UnionMeasures. `tolerance` is a share of the
/// bounding diameter. Requires at least one node and finite numbers.
template <int Dim, PieceOf<Dim> Piece, DistanceFrom<Dim> Distance, typename MeasureUnion>
[[nodiscard]] TreeReport report_levels(const SphereTree<Dim>& tree, const Piece& whole,
                                       const Distance& distance, double tolerance,
                                       const MeasureUnion& measure_union) {
    const auto certificates = certify<Dim>(tree, whole);
    const auto hulls = certify_hulls<Dim>(tree, whole);
    TreeReport report;
    report.bounding_diameter = 2 * enclosing_ball<Dim>(whole.vertices()).radius;
    report.tolerance = tolerance * report.bounding_diameter;
    for (int level = 0; level < tree.levels(); ++level) {
        check_interrupted();
        std::vector<Sphere<Dim>> balls;
        for (const int node : tree.level_nodes(level)) balls.push_back(tree.sphere(node));
        const UnionMeasures of_union = measure_union(balls);
        LevelReport entry;
        entry.level = level;
        entry.nodes = static_cast<int>(balls.size());
        entry.worst_protrusion =
            find_protrusion<Dim>(distance, std::span<const Sphere<Dim>>(balls), report.tolerance)
                .most;
        entry.mean_protrusion = of_union.mean_protrusion;
        entry.worst_protrusion_fraction = entry.worst_protrusion / report.bounding_diameter;
        entry.mean_protrusion_fraction = entry.mean_protrusion / report.bounding_diameter;
        entry.measure_ratio = of_union.measure_ratio;
        entry.uncovered = certificates[static_cast<std::size_t>(level)].uncovered;
        entry.certified = certificates[static_cast<std::size_t>(level)].certified;
        entry.hulls_certified = hulls[static_cast<std::size_t>(level)] != 0;
        report.levels.push_back(entry);
    }
    return report;
}

}  // namespace lod
