#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/ending.hpp"
#include "lodlab/lod2d/source/load.hpp"
#include "lodlab/scenes/shapes.hpp"

namespace scenes {

void check_drawing_choice(const std::string& spec, const ShapeChoice& choice) {
    if (lod2d::is_drawing_format(lod::ending_of(spec))) return;
    if (choice.strokes || choice.page || choice.strict)
        throw lod::Error(lod::ErrorKind::usage,
                         "only drawings have strokes and a page, and may be taken strictly; " +
                             spec + " is none: drop the option");
}

void check_effort(const TreeChoice& choice, bool has_effort) {
    if (choice.effort && !has_effort)
        throw lod::Error(lod::ErrorKind::usage,
                         "only the builder cover of sphere trees has an effort; drop it");
}

}  // namespace scenes
