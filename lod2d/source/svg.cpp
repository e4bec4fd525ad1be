#include "lodlab/lod2d/source/svg.hpp"

#include <algorithm>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/lod2d/source/resolve/resolve.hpp"
#include "lodlab/lod2d/source/svg/plain.hpp"
#include "lodlab/lod2d/source/svg/regions.hpp"

namespace lod2d {
namespace {

std::string stem(const std::string& name) {
    return std::filesystem::path(name).stem().string();
}

/// A drawing is read by ourselves where it is plain.
SvgDrawing read(const std::string& name, std::string_view bytes, const SvgSettings& settings) {
    const SvgXml xml = parse_svg_xml(name, bytes, settings.most_bytes);
    if (auto plain = read_plain_svg(xml, settings)) return std::move(*plain);
    return resolve_svg(xml, settings);
}

std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += (all.empty() ? "" : "; ") + line;
    return all;
}

[[noreturn]] void refuse_empty(const std::string& name, bool drawn, const SvgNotes& notes) {
    const std::vector<std::string> losses = notes.losses();
    std::string why = "it fills no region";
    if (drawn) why = "it fills no region: its area is zero, or all of it is clipped or outside";
    lod::refuse_input(
        "cannot use " + name,
        why + (losses.empty() ? "; draw a filled outline"
                              : " (" + joined(losses) +
                                    "); convert texts to paths, or draw a filled outline"));
}

}  // namespace

Shape parse_svg(const std::string& name, std::string_view text, const SvgSettings& settings) {
    SvgDrawing drawing = read(name, text, settings);
    const bool drawn = !drawing.fills.empty() || !drawing.strokes.empty();
    const std::vector<FilledPath> regions = regions_of(name, drawing, settings);
    if (regions.empty()) refuse_empty(name, drawn, drawing.notes);
    const std::vector<std::string> losses = drawing.notes.losses();
    if (settings.strict && !losses.empty())
        lod::refuse_input("cannot use " + name,
                          "it is to be taken strictly, and " + joined(losses) +
                              "; change the drawing, or drop the option strict");
    OutlineSettings outline = settings.outline;
    // Plain drawings keep the bits that they always had; of others curves are followed more
    // closely.
    if (!drawing.plain) outline.tolerance = std::max(outline.tolerance / 4, 1e-7);
    Shape shape = shape_of(name, regions, outline);
    shape.name = stem(name);
    for (const std::string& line : drawing.notes.remarks)
        shape.remarks.push_back(shape.name + ": " + line);
    for (const std::string& line : losses) {
        const bool strokes = line.starts_with("left out ") && !settings.strokes &&
                             line.find("stroke") != std::string::npos;
        shape.remarks.push_back(shape.name + ": " + line +
                                (strokes ? " (the option strokes takes strokes in)" : ""));
    }
    return shape;
}

Shape load_svg(const std::filesystem::path& path, const SvgSettings& settings) {
    return parse_svg(path.string(), lod::read_text_file(path, settings.most_bytes), settings);
}

}  // namespace lod2d
