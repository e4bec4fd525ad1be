#pragma once

#include "lodlab/lod3d/mesh/mesh.hpp"
#include "lodlab/viz/figure/figure.hpp"

namespace viz {

/// Makes a mesh ready to be drawn: smooth normals but over edges sharper than 40 degrees, its edges
/// and its outermost points. Requires: numbers checked (lod3d::check_numbers).
[[nodiscard]] Surface surface_of(const lod3d::Mesh& mesh);

}  // namespace viz
