#pragma once

#include "lodlab/lod3d/builder/build_tree.hpp"

namespace bench {

/// Prints what a query of two posed bodies of the same solid costs at each level of its sphere
/// tree, against FCL's exact query of the meshes in the same run, with the geometric error beside
/// it. `depth` of that tree.
void query_pairs(const lod3d::Solid& solid, int pairs, int depth);

}  // namespace bench
