#pragma once

#include <vector>

#include "lodlab/lod2d/source/paths/clean.hpp"
#include "lodlab/lod2d/source/paths/curve_path.hpp"

namespace lod2d {

enum class StrokeJoin { miter, round, bevel };
enum class StrokeCap { butt, round, square };

/// How a pen follows a path, as in SVG. Lengths in the path's frame.
struct StrokeStyle {
    double width = 1;  ///< > 0
    StrokeJoin join = StrokeJoin::miter;
    StrokeCap cap = StrokeCap::butt;
    double miter_limit = 4;      ///< longest miter, in widths; beyond it a corner is bevelled
    std::vector<double> dashes;  ///< lengths on, off, on, ...; >= 0; empty: one unbroken line
    double dash_offset = 0;      ///< where in the pattern a subpath begins
};

/// The region that the pen covers when it follows the path: a polygon for each piece of line, join
/// and cap, to be filled by the nonzero rule. Subpaths that are closed have no caps, and a dash
/// goes on over their closing point; subpaths of no length are dots where caps are not butt.
/// Corners turn by the directions of curves, and a bend tighter than the pen is covered beyond its
/// centre. Lines stray from curves, round joins and round caps by at most `tolerance`. Requires
/// finite coordinates, width > 0, tolerance > 0.
[[nodiscard]] Outline stroke_pieces(const CurvePath& path, const StrokeStyle& style,
                                    double tolerance);

/// How many dashes stroke_pieces would draw, at most `most`.
[[nodiscard]] std::size_t count_dashes(const CurvePath& path, const StrokeStyle& style,
                                       double tolerance, std::size_t most);

}  // namespace lod2d
