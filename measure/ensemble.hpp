#pragma once

/// \file
/// Random impacts of two bodies, the same for the same seed.

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lodlab/core/exact/time_of_impact.hpp"
#include "lodlab/core/tree/body.hpp"
#include "lodlab/scenes/shapes.hpp"

namespace measure {

/// A shape that takes part in impacts.
template <int Dim>
struct MeasuredShape {
    std::string name;
    /// At rest in the origin, density 1, with its tree and its exact shape.
    lod::Body<Dim> body;
    /// e_k: how far the union of the balls of level k stands out of the shape at most [m].
    std::vector<double> protrusion;

    /// e_k of a level; of the deepest for all that are deeper.
    [[nodiscard]] double protrusion_at(int level) const {
        return protrusion[(std::min)(static_cast<std::size_t>(level), protrusion.size() - 1)];
    }
};

/// Builds the tree of a shape, or takes it from the cache, and measures every level of it.
/// Throws lod::Error as scenes::Shapes does.
template <int Dim>
[[nodiscard]] MeasuredShape<Dim> measured_shape(const std::string& name,
                                                const scenes::Shape<Dim>& shape,
                                                const scenes::TreeChoice& tree,
                                                const io::TreeCache& cache);

/// Random impacts of two bodies. World frame; body A starts in the origin.
struct EnsembleSettings {
    std::uint64_t seed = 1;
    double speed = 1;  ///< of approach, shared by both bodies [m/s], > 0
    double spin = 2;   ///< each component of either spin lies within so much [rad/s], >= 0
    double aim = 0.8;  ///< the line of approach misses A's centre by at most this share of the
                       ///< sum of the two trees' radii, 0 to 1
    double restitution = 1;  ///< 0 to 1

    friend bool operator==(const EnsembleSettings&, const EnsembleSettings&) = default;
};

/// Two bodies that meet.
template <int Dim>
struct Approach {
    int shape_a = 0;
    int shape_b = 0;
    lod::Body<Dim> a;  ///< at the start, apart
    lod::Body<Dim> b;
    double time = 0;               ///< from the start to the touch [s]
    lod::TimeOfImpact<Dim> touch;  ///< of the exact shapes; its own time counts from a frame
};

/// Exact shapes count as touching within so much [m]: far below any error that is measured, far
/// above rounding for shapes of some metres.
inline constexpr double touching_within = 1e-11;

/// Impact `number` of an ensemble, counted from 0: shapes, poses and spins drawn from a stream of
/// random numbers of its own, so that it is the same whichever other impacts are drawn. Draws again
/// where the bodies miss each other, or where nothing pushes as they touch.
/// `step` is the frame's [s]: bodies move by lod::integrate, and the touch is looked for within a
/// frame. Throws lod::Error (input refused) where 1000 draws find no impact.
template <int Dim>
[[nodiscard]] Approach<Dim> draw_approach(std::span<const MeasuredShape<Dim>> shapes,
                                          const EnsembleSettings& settings, std::uint64_t number,
                                          double step);

}  // namespace measure
