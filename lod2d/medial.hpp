#pragma once

#include "core/builder/grow.hpp"
#include "lod2d/distance.hpp"
#include "lod2d/piece.hpp"
#include "lod2d/shape.hpp"

namespace lod2d {

/// Circles that start on the medial axis. For each piece, largest discs within the shape that touch
/// the piece's border are gathered; swollen by an allowance, a few of them have to cover the piece;
/// the least allowance with which so many can is found by bisection, and a greedy choice shows
/// them. They are then fitted to the pieces of their power diagram, as by build_pieces, whose
/// starts are tried too.
struct MedialConfig {
    int branching = 4;                ///< see lod::GrowSettings
    int depth = 4;                    ///< see lod::GrowSettings
    double least_protrusion = 1e-7;   ///< share of the root circle's diameter
    double look_ahead_above = 0.005;  ///< share of the same; see lod::GrowSettings
    double normal_weight = 0.25;      ///< see lod::GrowSettings; 0: the closest fit
    double most_growth = 1.5;         ///< see DiscFit
    int most_rounds = 12;             ///< of Lloyd's method from each start
    int samples = 48;                 ///< discs and points tried along a piece's border, 8 to 512
    std::function<void(double)> progress{};  ///< share of the work done
};

/// Throws lod::Error (limit exceeded) where a setting is out of range.
[[nodiscard]] lod::SphereTree<2> build_medial(const Polygon& polygon, const PolygonPiece& whole,
                                              const BoundaryIndex& shape,
                                              const MedialConfig& config);

}  // namespace lod2d
