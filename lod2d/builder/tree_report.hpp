#pragma once

/// \file
/// How well each level of a circle tree fits its shape.

#include "lodlab/core/builder/tree_report.hpp"
#include "lodlab/core/tree/tree.hpp"
#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

using lod::LevelReport;
using lod::TreeReport;

/// How exactly a tree is measured.
struct ReportSettings {
    double tolerance = 1e-6;  ///< of the worst protrusion, as a share of the bounding diameter, > 0
    int samples = 4000;       ///< least number of points on a level's border, for the mean
};

/// Measures any circle tree, built or loaded, against the shape that it stands for.
/// Requires at least one node and finite numbers.
[[nodiscard]] TreeReport report_tree(const Shape& shape, const lod::SphereTree<2>& tree,
                                     const ReportSettings& settings = {});

}  // namespace lod2d
