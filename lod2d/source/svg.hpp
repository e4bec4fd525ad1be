#pragma once

/// \file
/// The shape that an SVG drawing shows.

#include <filesystem>
#include <string_view>

#include "lodlab/lod2d/shape/shape.hpp"
#include "lodlab/lod2d/source/svg/settings.hpp"

namespace lod2d {

/// The shape that a browser shows of an SVG file: the union of all its filled regions, whatever
/// their colour (white too), as one rigid body, which may have several parts. Up in the picture is
/// up (+y). The shape is scaled by settings.outline.size; width, height and viewBox of the file set
/// no scale and cut nothing off, unless settings.page asks for it (where that matters, a remark
/// says so).
///
/// A drawing of paths, basic shapes, groups, transforms and colours is read to the last bit. Any
/// other goes through librsvg, which resolves style sheets, `use`, nested `svg`, switch (English is
/// taken), clips, markers and units, to about 1e-9 of the drawing's size; a remark says so. A file
/// that only strokes is drawn by its strokes: width, joins, caps, miter limit, dashes.
///
/// Left out, and counted in the shape's remarks: strokes where there are fills (settings.strokes
/// takes them in), texts (convert them to paths), images, filters, masks that are no plain shape,
/// scripts, animations (a drawing stands as it is written). Gradients that fade to nothing and
/// patterns count as whole regions; a remark says that too, and what of CSS is not followed.
///
/// Throws lod::Error naming the file and, where there is one, line and column: input refused for a
/// file that is missing, no SVG, broken, that uses itself, that fills nothing, or (settings.strict)
/// of which something is left out; limit exceeded (naming the limit) beyond the settings. Reads no
/// other file.
[[nodiscard]] Shape load_svg(const std::filesystem::path& path, const SvgSettings& settings = {});

/// The same from text, which may be compressed (svgz); `name` stands in the errors and names the
/// shape.
[[nodiscard]] Shape parse_svg(const std::string& name, std::string_view text,
                              const SvgSettings& settings = {});

}  // namespace lod2d
