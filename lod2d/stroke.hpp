#pragma once

#include "lodlab/lod2d/clean.hpp"
#include "lodlab/lod2d/curve_path.hpp"

namespace lod2d {

/// The region that a pen of some width covers when it follows the path: round joins, butt ends,
/// closed where a subpath is closed. Lines stray from curves and from round joins by at most
/// `tolerance`. Requires finite coordinates, width > 0, tolerance > 0; all in the path's frame.
[[nodiscard]] Outline stroke_outline(const CurvePath& path, double width, double tolerance);

}  // namespace lod2d
