#pragma once

#include "lodlab/core/builder/grow.hpp"
#include "lodlab/lod2d/builder/piece.hpp"
#include "lodlab/lod2d/shape/distance.hpp"

namespace lod2d {

/// Circles fitted to pieces that are split by their own power diagram, from geometric starts:
/// vertices far from each other, and slices along the piece's longest axis.
/// Throws lod::Error (limit exceeded) where a setting is out of range.
[[nodiscard]] lod::SphereTree<2> build_pieces(const PolygonPiece& whole, const BoundaryIndex& shape,
                                              const lod::GrowSettings& settings);

}  // namespace lod2d
