#pragma once

#include "lodlab/lod2d/source/svg/drawing.hpp"
#include "lodlab/lod2d/source/svg/settings.hpp"
#include "lodlab/lod2d/source/svg/xml.hpp"

namespace lod2d {

/// Reads a drawing by librsvg, which resolves style sheets, inheritance, view boxes, `use`, switch,
/// clips, markers and units, and draws to a script that is read back (cairo_script.hpp). Outlines
/// are then right to about 1e-9 of the whole drawing's size, pens to 1e-6 of their width, and
/// circles and rounded corners that only CSS sizes to 3e-4 of their radius. Throws lod::Error as
/// parse_svg() does; input refused where parts lie too far outside the page.
[[nodiscard]] SvgDrawing resolve_svg(const SvgXml& xml, const SvgSettings& settings);

}  // namespace lod2d
