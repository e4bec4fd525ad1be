#pragma once

#include <string>

#include "lodlab/lod2d/source/svg/drawing.hpp"
#include "lodlab/lod2d/source/svg/settings.hpp"
#include "lodlab/lod2d/source/svg/xml.hpp"

namespace lod2d {

/// A drawing as a library is to see it, which knows less of CSS than a browser and has no window.
struct PreparedSvg {
    std::string text;   ///< its root stands in a viewport of `size`
    Point size;         ///< of the page, user units
    bool paged = true;  ///< the page cuts off what lies outside
    SvgNotes notes;     ///< what was left out of the text, or is seen in another way
};

/// Puts a document in words that a library understands: CSS as lod2d/source/css/css.hpp does,
/// conditions decided (English, no extensions), masks of plain shapes as clips; without texts,
/// images, scripts, filters and animations, which are counted. Throws lod::Error: input refused,
/// with the place, for a path, points or transform that is broken and for elements that draw
/// themselves; limit exceeded beyond the settings.
[[nodiscard]] PreparedSvg prepare_svg(const SvgXml& xml, const SvgSettings& settings);

}  // namespace lod2d
