#pragma once

/// \file
/// How well each level of a sphere tree fits its solid.

#include "lodlab/core/builder/tree_report.hpp"
#include "lodlab/core/tree/tree.hpp"
#include "lodlab/lod3d/solid/solid.hpp"

namespace lod3d {

using lod::LevelReport;
using lod::TreeReport;

/// How exactly a tree is measured.
struct ReportSettings {
    double tolerance = 1e-4;  ///< of the worst protrusion, as a share of the bounding diameter, > 0
    int samples = 20000;      ///< least number of points on a level's spheres, for mean and volume
};

/// Measures any sphere tree, built or loaded, against the solid that it stands for. Mean protrusion
/// and volume ratio are sampled, to about 1 / sqrt(samples).
/// Requires at least one node and finite numbers.
[[nodiscard]] lod::TreeReport report_tree(const Solid& solid, const lod::SphereTree<3>& tree,
                                          const ReportSettings& settings = {});

}  // namespace lod3d
