#pragma once

#include <vector>

#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lod3d {

/// Points spread evenly over the unit sphere (a spiral of the golden angle).
[[nodiscard]] std::vector<Point> spread_directions(int count);

}  // namespace lod3d
