#pragma once

#include <string>
#include <string_view>

#include "lodlab/lod2d/svg.hpp"

namespace lod2d {

/// A line drawn with a pen of some width, both in the frame of its element.
struct SvgStroke {
    CurvePath path;
    double width = 1;
    Affine to_page;
};

/// What a document draws, in its own frame turned upright (y up), user units.
struct SvgDrawing {
    std::vector<FilledPath> fills;
    std::vector<SvgStroke> strokes;
    std::string left_out;  ///< "2 texts, 1 image", for the reader of an error
};

/// Reads the document. `name` stands in the errors (see svg.hpp).
[[nodiscard]] SvgDrawing read_svg(const std::string& name, std::string_view text,
                                  const SvgSettings& settings);

}  // namespace lod2d
