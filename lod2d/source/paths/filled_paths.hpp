#pragma once

/// \file
/// How curves of a file or a font become a shape, with the settings that all readers share.

#include <string>
#include <vector>

#include "lodlab/lod2d/source/paths/clean.hpp"
#include "lodlab/lod2d/source/paths/curve_path.hpp"

namespace lod2d {

/// A path and the rule by which its inside is told.
struct FilledPath {
    CurvePath path;
    FillRule rule = FillRule::nonzero;
};

/// How curves from a file or a font become a shape.
struct OutlineSettings {
    double size = 1;          ///< longer side of the shape's bounding box [m], > 0
    double tolerance = 1e-3;  ///< how far lines may stray from a curve: share of the box's diagonal
    CleanSettings clean;
};

/// The union of the insides of all paths, scaled to the size. Paths are in any unit, y up.
/// Throws lod::Error as clean() does, and where the size or the tolerance is out of range.
[[nodiscard]] Shape shape_of(const std::string& name, const std::vector<FilledPath>& paths,
                             const OutlineSettings& settings);

}  // namespace lod2d
