#pragma once

/// \file
/// A closed surface for a mesh that is open or crosses itself.

#include <functional>

#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lod3d {

/// The closed surface around all points that `inside` accepts, found on a grid of cubes, each cut
/// into six tetrahedra (marching tetrahedra); a vertex is moved to within 1/256 of a grid edge of
/// where `inside` changes. What is thinner than a cube can be lost. The longest side of the box
/// takes `cells` cubes. Requires: a box of positive size, cells within 4..512.
[[nodiscard]] Mesh enclose(const Box& box, int cells,
                           const std::function<bool(const Point&)>& inside);

/// Fills a mesh that need not be closed, nor free of overlaps: the closed surface around the points
/// whose winding number exceeds 1/2 (Jacobson et al. 2013). Every closed surface keeps its
/// interior; a surface with a hole is closed by a smooth lid. Throws lod::Error where nothing is
/// enclosed.
[[nodiscard]] Mesh fill_by_winding(const Mesh& mesh, int cells = 64);

}  // namespace lod3d
