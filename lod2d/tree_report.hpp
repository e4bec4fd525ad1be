#pragma once

#include <vector>

#include "core/tree.hpp"
#include "lod2d/shape.hpp"

namespace lod2d {

/// What one level of a circle tree (the nodes of the level and the leaves above it) is worth.
struct LevelReport {
    int level = 0;
    int nodes = 0;
    /// Largest distance of a point of the circles' union to the shape [m]: never less than the true
    /// one, and more by at most TreeReport::tolerance.
    double worst_protrusion = 0;
    double mean_protrusion = 0;            ///< over the union's border [m]
    double worst_protrusion_fraction = 0;  ///< of the bounding circle's diameter
    double mean_protrusion_fraction = 0;
    double measure_ratio =
        0;                 ///< area of the circles' union over that of the shape, >= 1 if certified
    double uncovered = 0;  ///< upper bound of the share of the area without a chain of circles
    bool certified = false;  ///< the level covers the shape (core/builder/certify.hpp)
};

struct TreeReport {
    double bounding_diameter = 0;  ///< of the shape's least enclosing circle [m]
    double tolerance = 0;          ///< of the worst protrusions [m]
    std::vector<LevelReport> levels;
};

struct ReportSettings {
    double tolerance = 1e-6;  ///< of the worst protrusion, as a share of the bounding diameter, > 0
    int samples = 4000;       ///< least number of points on a level's border, for the mean
};

/// Measures any circle tree, built or loaded, against the shape that it stands for.
/// Requires at least one node and finite numbers.
[[nodiscard]] TreeReport report_tree(const Shape& shape, const lod::SphereTree<2>& tree,
                                     const ReportSettings& settings = {});

}  // namespace lod2d
