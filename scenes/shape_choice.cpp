#include "lodlab/core/base/ending.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/shapes.hpp"

namespace scenes {

void check_drawing_choice(const std::string& spec, const ShapeChoice& choice) {
    const std::string ending = lod::ending_of(spec);
    if (ending == "svg" || ending == "svgz") return;
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
