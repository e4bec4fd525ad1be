#pragma once

#include "core/builder/grow.hpp"
#include "lod2d/distance.hpp"
#include "lod2d/piece.hpp"

namespace lod2d {

/// Circles fitted to pieces that are split by their own power diagram, from geometric starts:
/// vertices far from each other, and slices along the piece's longest axis.
struct PiecesConfig {
    int branching = 4;                       ///< see lod::GrowSettings
    int depth = 4;                           ///< see lod::GrowSettings
    double least_protrusion = 1e-7;          ///< share of the root circle's diameter
    double look_ahead_above = 0.005;         ///< share of the same; see lod::GrowSettings
    int most_rounds = 12;                    ///< of Lloyd's method from each start
    std::function<void(double)> progress{};  ///< share of the work done
};

/// Throws lod::Error (limit exceeded) where a setting is out of range.
[[nodiscard]] lod::SphereTree<2> build_pieces(const PolygonPiece& whole, const BoundaryIndex& shape,
                                              const PiecesConfig& config);

}  // namespace lod2d
