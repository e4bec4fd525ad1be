#pragma once

#include <string>
#include <vector>

#include "lodlab/lod2d/source/svg/drawing.hpp"
#include "lodlab/lod2d/source/svg/settings.hpp"

namespace lod2d {

/// The regions that a drawing shows: its fills that enclose something, and its strokes where
/// settings.strokes asks for them or where there are no such fills; cut off by their clips and by
/// the page. Fills that nothing cuts are left as they are. Notes what is left out.
/// Throws lod::Error: limit exceeded for strokes of too many dashes or crossings.
[[nodiscard]] std::vector<FilledPath> regions_of(const std::string& name, SvgDrawing& drawing,
                                                 const SvgSettings& settings);

}  // namespace lod2d
