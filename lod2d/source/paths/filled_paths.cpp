#include "lodlab/lod2d/source/paths/filled_paths.hpp"

#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"

namespace lod2d {
namespace {

void check(const std::string& name, const std::vector<FilledPath>& paths,
           const OutlineSettings& settings) {
    const auto refuse = [&](const std::string& why) {
        throw lod::Error(lod::ErrorKind::input_refused, "cannot use '" + name + "': " + why);
    };
    if (!(settings.size >= 1e-6 && settings.size <= 1e6))
        refuse("the size must be from 1e-6 to 1e6 m");
    if (!(settings.tolerance >= 1e-7 && settings.tolerance <= 0.1))
        refuse("the tolerance of curves must be from 1e-7 to 0.1 of the diagonal");
    for (const FilledPath& filled : paths)
        if (!filled.path.finite())
            refuse("a coordinate is not finite or beyond 1e60; check the numbers");
}

/// Outlines that may enclose something, flattened to the tolerance.
std::vector<Outline> flattened(const std::string& name, const std::vector<FilledPath>& paths,
                               const OutlineSettings& settings) {
    Box box;
    for (const FilledPath& filled : paths) box.hold(filled.path.control_box());
    const double tolerance = box.is_empty() ? 1 : settings.tolerance * box.size().norm();
    std::vector<Outline> outlines;
    std::size_t points = 0;
    for (const FilledPath& filled : paths) {
        Outline outline{filled.path.flatten(std::max(tolerance, 1e-300)), filled.rule};
        std::erase_if(outline.rings, [](const Ring& ring) { return ring.size() < 3; });
        for (const Ring& ring : outline.rings) points += ring.size();
        if (points > settings.clean.most_points)
            throw lod::Error(lod::ErrorKind::limit_exceeded,
                             "cannot use '" + name + "': its curves need more than " +
                                 std::to_string(settings.clean.most_points) +
                                 " points; simplify it, or raise the limit or the tolerance");
        if (!outline.rings.empty()) outlines.push_back(std::move(outline));
        lod::check_interrupted();
    }
    return outlines;
}

Box box_of(const std::vector<Outline>& outlines) {
    Box box;
    for (const Outline& outline : outlines) box.hold(bounds({outline.rings}));
    return box;
}

/// Moves the middle of `box` to the origin and makes its longer side `size`.
void fit(std::vector<Outline>& outlines, const Box& box, double size) {
    const Point middle = box.centre();
    const double scale = size / box.size().maxCoeff();
    for (Outline& outline : outlines)
        for (Ring& ring : outline.rings)
            for (Point& p : ring) p = scale * (p - middle);
}

}  // namespace

Shape shape_of(const std::string& name, const std::vector<FilledPath>& paths,
               const OutlineSettings& settings) {
    check(name, paths, settings);
    std::vector<Outline> outlines = flattened(name, paths, settings);
    const Box raw = box_of(outlines);
    if (!raw.is_empty() && raw.size().maxCoeff() > 0) fit(outlines, raw, settings.size);
    Polygon polygon = clean(name, outlines, settings.clean);
    // What encloses nothing may have reached further than the shape: then fit once more.
    const Box box = bounds(polygon);
    if (std::abs(box.size().maxCoeff() / settings.size - 1) > 1e-6) {
        fit(outlines, box, settings.size);
        polygon = clean(name, outlines, settings.clean);
    }
    return make_shape(name, polygon);
}

}  // namespace lod2d
