#include "lodlab/lod2d/source/load.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/ending.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/source/font.hpp"
#include "lodlab/lod2d/source/svg.hpp"

namespace lod2d {
namespace {

constexpr std::string_view text_prefix = "text:";

bool is_svg_file(std::string_view spec) {
    return is_drawing_format(lod::ending_of(spec));
}

std::string understood() {
    std::string list = "give a file ending in .svg or .svgz, text:R, or one of: ";
    for (const Generator& generator : generators())
        list += (&generator == generators().data() ? "" : ", ") + std::string(generator.name);
    return list;
}

}  // namespace

bool names_shape(std::string_view spec) {
    return is_svg_file(spec) || spec.starts_with(text_prefix) || names_generator(spec);
}

Shape load_shape(std::string_view spec, const LoadSettings& settings) {
    if (is_svg_file(spec)) {
        SvgSettings svg;
        svg.outline = settings.outline;
        svg.most_bytes = settings.most_bytes;
        svg.most_elements = settings.most_elements;
        svg.most_memory = settings.most_memory;
        svg.most_seconds = settings.most_seconds;
        svg.strokes = settings.strokes;
        svg.strict = settings.strict;
        svg.page = settings.page;
        return load_svg(std::filesystem::path(spec), svg);
    }
    if (spec.starts_with(text_prefix)) {
        FontSettings font;
        font.outline = settings.outline;
        font.font = settings.font;
        return text_shape(spec.substr(text_prefix.size()), font);
    }
    if (names_generator(spec)) return generate(spec);
    throw lod::Error(lod::ErrorKind::usage,
                     "'" + std::string(spec) + "' names no shape; " + understood());
}

bool is_drawing_format(std::string_view ending) {
    return ending == "svg" || ending == "svgz";
}

}  // namespace lod2d
