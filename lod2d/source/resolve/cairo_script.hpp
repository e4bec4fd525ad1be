#pragma once

#include <string>
#include <string_view>

#include "lodlab/lod2d/source/svg/drawing.hpp"

namespace lod2d {

/// Reads what Cairo's script surface wrote (%!CairoScript): fills, strokes, clips and groups. Paths
/// are in the frame that `to_page` takes to the page. What is painted with no ink is left out;
/// regions filled with a pattern count whole, and the notes say so.
/// Throws lod::Error (input refused, naming `name`) for an instruction that it does not know.
[[nodiscard]] SvgDrawing read_cairo_script(const std::string& name, std::string_view script,
                                           const Affine& to_page);

}  // namespace lod2d
