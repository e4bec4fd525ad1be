#pragma once

/// \file
/// Letters as shapes, from an installed font.

#include <string>
#include <string_view>

#include "lodlab/lod2d/source/paths/filled_paths.hpp"

namespace lod2d {

/// How a text becomes a shape.
struct FontSettings {
    OutlineSettings outline;
    /// A fontconfig name: "Inter", "Inter:bold", "DejaVu Serif". Where no such font is installed,
    /// fontconfig's nearest is taken.
    std::string font = "Inter";
    std::size_t most_characters = 200;
};

/// The outlines of a text's letters, side by side on one line, as one rigid body (a letter may have
/// several parts, and holes). Named "text:" and the text.
/// Throws lod::Error: input refused where the text is no UTF-8, has nothing to draw, or the font
/// has no glyph for one of its characters (naming it); limit exceeded beyond most_characters; not
/// installed where there is no font at all (with the line that installs one).
[[nodiscard]] Shape text_shape(std::string_view text, const FontSettings& settings = {});

}  // namespace lod2d
