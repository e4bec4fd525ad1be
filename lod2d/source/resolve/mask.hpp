#pragma once

#include "lodlab/lod2d/source/svg/drawing.hpp"

namespace pugi {
class xml_document;
class xml_node;
}  // namespace pugi

namespace lod2d {

/// Turns masks into clips where that is the same: masks of a basic shape or path that is filled
/// with a colour other than black (or with any, by alpha). Others and all filters are taken off
/// their elements, and noted. The style of the document is plain CSS (lod2d/source/css/css.hpp).
void masks_to_clips(pugi::xml_document& document, SvgNotes& notes);

/// Puts groups around what is clipped by a clip that is clipped itself, one for each; where that
/// cannot be, it is noted.
void unnest_clips(pugi::xml_document& document, SvgNotes& notes);

/// The box of a shape's outline in its own frame; nothing where that takes more than its numbers.
[[nodiscard]] std::optional<Box> svg_box_of(const pugi::xml_node& node);

/// Notes windows within the drawing that browsers cut off in another way than a library does: of
/// symbols, markers and nested <svg>s that are used.
void check_viewports(const pugi::xml_document& document, SvgNotes& notes);

/// Puts clips in units of their object's box (clipPathUnits="objectBoundingBox") in its own units,
/// where the object is a basic shape or path with numbers; others are taken off and noted.
void box_clips_to_user_space(pugi::xml_document& document, SvgNotes& notes);

/// Turns patterns into gradients of one colour, so that what they fill counts as a whole, or as
/// nothing where they draw nothing; notes those that are named.
void fill_patterns(pugi::xml_document& document, SvgNotes& notes);

}  // namespace lod2d
