#include "lodlab/lod2d/svg.hpp"

#include <cmath>

#include "lodlab/core/error.hpp"
#include "lodlab/core/output_file.hpp"
#include "lodlab/lod2d/stroke.hpp"
#include "lodlab/lod2d/svg_document.hpp"

namespace lod2d {
namespace {

/// A stroke as a path to fill, in the frame of the page.
FilledPath covered_by(const SvgStroke& stroke, double tolerance) {
    const double extent = stroke.path.control_box().size().maxCoeff() + stroke.width;
    FilledPath filled;
    for (const Ring& ring : stroke_outline(stroke.path, stroke.width, tolerance * extent).rings) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            i == 0 ? filled.path.move_to(ring[i]) : filled.path.line_to(ring[i]);
        filled.path.close();
    }
    filled.path.transform(stroke.to_page);
    return filled;
}

std::string stem(const std::string& name) {
    return std::filesystem::path(name).stem().string();
}

}  // namespace

Shape parse_svg(const std::string& name, std::string_view text, const SvgSettings& settings) {
    SvgDrawing drawing = read_svg(name, text, settings);
    if (drawing.fills.empty())
        for (const SvgStroke& stroke : drawing.strokes)
            drawing.fills.push_back(covered_by(stroke, settings.outline.tolerance));
    if (drawing.fills.empty())
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot use " + name + ": it fills no region" +
                             (drawing.left_out.empty()
                                  ? "; draw a filled outline"
                                  : " (left out: " + drawing.left_out +
                                        "); convert its text to paths or draw a filled outline"));
    Shape shape = shape_of(name, drawing.fills, settings.outline);
    shape.name = stem(name);
    return shape;
}

Shape load_svg(const std::filesystem::path& path, const SvgSettings& settings) {
    return parse_svg(path.string(), lod::read_text_file(path, settings.most_bytes), settings);
}

}  // namespace lod2d
