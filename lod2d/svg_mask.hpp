#pragma once

#include "lodlab/lod2d/svg_drawing.hpp"

namespace pugi {
class xml_document;
}

namespace lod2d {

/// Turns masks into clips where that is the same: masks of basic shapes and paths that are filled
/// with a colour other than black (or with any, by alpha). Others and all filters are taken off
/// their elements, and noted. The style of the document is plain CSS (svg_css.hpp).
void masks_to_clips(pugi::xml_document& document, SvgNotes& notes);

/// Puts clips in units of their object's box (clipPathUnits="objectBoundingBox") in its own units,
/// where the object is a basic shape or path with numbers; others are taken off and noted.
void box_clips_to_user_space(pugi::xml_document& document, SvgNotes& notes);

/// Turns patterns into gradients of one colour, so that what they fill counts as a whole, or as
/// nothing where they draw nothing; notes those that are named.
void fill_patterns(pugi::xml_document& document, SvgNotes& notes);

}  // namespace lod2d
