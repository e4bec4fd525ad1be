#pragma once

#include "lodlab/core/builder/grow.hpp"
#include "lodlab/lod2d/builder/piece.hpp"

namespace lod2d {

/// The classical circle tree, for teaching and as the baseline: the square about the shape is
/// halved both ways again and again, and each square that holds some of the shape gets the circle
/// through its corners. The shape's content of the squares is what the nodes own: on a grid, equal
/// circles have the grid's lines as their power diagram, so that the certificate holds.
///
/// Of the settings depth and progress count. Throws lod::Error (limit exceeded) where the depth is
/// out of range.
[[nodiscard]] lod::SphereTree<2> build_quadtree(const PolygonPiece& whole,
                                                const lod::GrowSettings& settings);

}  // namespace lod2d
