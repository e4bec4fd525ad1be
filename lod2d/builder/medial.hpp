#pragma once

#include "lodlab/core/builder/grow.hpp"
#include "lodlab/lod2d/builder/piece.hpp"
#include "lodlab/lod2d/shape/distance.hpp"
#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// Circles that start on the medial axis. For each piece, largest discs within the shape that touch
/// the piece's border are gathered; swollen by an allowance, a few of them have to cover the piece;
/// the least allowance with which so many can is found by bisection, and a greedy choice shows
/// them. They are then fitted to the pieces of their power diagram, as by build_pieces, whose
/// starts are tried too.
struct MedialConfig {
    lod::GrowSettings grow{};
    double most_growth = 1.5;  ///< see DiscFit; without a weight of the normals there is no limit
    int samples = 48;          ///< discs and points tried along a piece's border, 8 to 512
};

/// Throws lod::Error (limit exceeded) where a setting is out of range.
[[nodiscard]] lod::SphereTree<2> build_medial(const Polygon& polygon, const PolygonPiece& whole,
                                              const BoundaryIndex& shape,
                                              const MedialConfig& config);

}  // namespace lod2d
