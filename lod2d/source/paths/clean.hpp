#pragma once

/// \file
/// From raw outlines, which may cross themselves, to a clean polygon.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// Which points a set of closed lines encloses, as in SVG: those they wind around at all, or those
/// they wind around an odd number of times.
enum class FillRule { nonzero, evenodd };

/// Closed lines as they come from a file: in any direction, crossing themselves, with points twice.
struct Outline {
    std::vector<Ring> rings;
    FillRule rule = FillRule::nonzero;
};

/// What cleaning may cost, and which parts are too small to keep.
struct CleanSettings {
    std::size_t most_points = 1'000'000;  ///< over all outlines
    /// Pairs of edges whose boxes meet, and edges passed by the sweep: what the time depends on.
    std::uint64_t most_edge_pairs = 50'000'000;
    std::uint64_t most_sweep_steps = 300'000'000;
    /// Pairs of edges that do cross: what the size of the result, and the time of trees, depends
    /// on.
    std::uint64_t most_crossings = 120'000;
    /// Parts and holes smaller than a square of this side are dropped (share of the longer side).
    double smallest_part = 1e-6;
};

/// The union of the regions that the outlines enclose, each by its own rule, as a clean polygon:
/// outer rings anticlockwise, holes clockwise, no ring meets itself, no two cross (they may touch
/// in points), no zero-length edge, no point twice, no three points in line. Several separate parts
/// are allowed: they are one rigid body.
///
/// Coordinates are put on a grid of 2^-29 to 2^-30 of the longer side's half; crossings are rounded
/// to it, and all points to every 16th line or coarser ones where edges run side by side within a
/// few steps. `name` stands in the errors. Throws lod::Error: input refused where a coordinate is
/// not finite or beyond 1e60, or nothing is enclosed; limit exceeded (naming the limit) beyond the
/// settings.
[[nodiscard]] Polygon clean(const std::string& name, std::span<const Outline> outlines,
                            const CleanSettings& settings = {});

/// The same for a single outline.
[[nodiscard]] Polygon clean(const std::string& name, const Outline& outline,
                            const CleanSettings& settings = {});

}  // namespace lod2d
