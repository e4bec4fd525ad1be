#include "lodlab/lod2d/stroke.hpp"

#include <cmath>
#include <polyclipping/clipper.hpp>

namespace lod2d {

Outline stroke_outline(const CurvePath& path, double width, double tolerance) {
    Box box = path.control_box();
    const Point middle = box.centre();
    const double extent = box.size().maxCoeff() + 2 * width;
    const double step = extent / 0x1p29;
    ClipperLib::ClipperOffset offset(2.0, std::max(0.25, tolerance / step));
    const std::vector<Ring> lines = path.flatten(tolerance);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ClipperLib::Path line;
        for (const Point& p : lines[i]) {
            const Point q = (p - middle) / step;
            line.emplace_back(std::llround(q.x()), std::llround(q.y()));
        }
        const bool closed = path.subpaths()[i].closed;
        offset.AddPath(line, ClipperLib::jtRound,
                       closed ? ClipperLib::etClosedLine : ClipperLib::etOpenButt);
    }
    ClipperLib::Paths covered;
    offset.Execute(covered, width / 2 / step);
    Outline outline;
    for (const ClipperLib::Path& ring : covered) {
        Ring& points = outline.rings.emplace_back();
        for (const ClipperLib::IntPoint& p : ring)
            points.push_back(middle +
                             step * Point(static_cast<double>(p.X), static_cast<double>(p.Y)));
    }
    return outline;
}

}  // namespace lod2d
