// Refuses what no picture can hold, before any of it reaches a drawing library.

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/figure/check.hpp"

namespace viz {
namespace {

constexpr double largest = 1e12;
constexpr double least_extent = 1e-12;

struct Place {
    std::string where;

    [[noreturn]] void refuse(const std::string& what, const std::string& mend) const {
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot draw the figure: " + what + " in " + where + "; " + mend);
    }
    void number(double value, const char* name) const {
        if (!std::isfinite(value))
            refuse(std::string(name) + " is not a finite number", "check what was computed");
        if (std::abs(value) > largest)
            refuse(std::string(name) + " is beyond 1e12", "scale the scene down");
    }
    void point(Point p, const char* name) const {
        number(p.x, name);
        number(p.y, name);
    }
    void share(double value, const char* name) const {
        number(value, name);
        if (value < 0 || value > 1) refuse(std::string(name) + " is not within 0..1", "clamp it");
    }
    void length(double value, const char* name) const {
        number(value, name);
        if (value < 0) refuse(std::string(name) + " is below zero", "check what was computed");
    }
};

void check(const Disc& disc, const Place& place) {
    place.point(disc.centre, "a disc's centre");
    place.length(disc.radius, "a disc's radius");
}
void check(const Dot& dot, const Place& place) {
    place.point(dot.at, "a dot's place");
}
void check(const Path& path, const Place& place) {
    for (const Ring& ring : path.rings)
        for (const Point& p : ring) place.point(p, "a path's point");
}
void check(const Polyline& line, const Place& place) {
    for (const Point& p : line.points) place.point(p, "a line's point");
    place.share(line.start_opacity, "a line's start_opacity");
}
void check(const Arrow& arrow, const Place& place) {
    place.point(arrow.tail, "an arrow's tail");
    place.point(arrow.tip, "an arrow's tip");
}
void check(const Label& label, const Place& place) {
    place.point(label.anchor, "a label's anchor");
    place.length(label.clearance, "a label's clearance");
}

void check_axis(const Axis& axis, double low, double high, const Place& place) {
    for (const double tick : axis.ticks) place.number(tick, "a tick");
    if (axis.scale == Scale::logarithmic && low <= 0)
        place.refuse("a logarithmic axis starts at zero or below", "start its view above zero");
    if (axis.scale == Scale::logarithmic && high / low < 1.0001)
        place.refuse("a logarithmic axis spans nothing", "widen its view");
}

void check(const Panel& panel, const Place& place) {
    for (const Entry& entry : panel.entries) place.share(entry.style.opacity, "an opacity");
    if (!panel.entries.empty()) return;
    place.point(panel.view.low, "the view");
    place.point(panel.view.high, "the view");
    const double width = panel.view.high.x - panel.view.low.x;
    const double height = panel.view.high.y - panel.view.low.y;
    if (!(width >= least_extent) || !(height >= least_extent))
        place.refuse("the view is empty", "give it a width and a height");
    if (panel.axes) {
        check_axis(panel.axes->x, panel.view.low.x, panel.view.high.x, place);
        check_axis(panel.axes->y, panel.view.low.y, panel.view.high.y, place);
    }
}

void check(Point3 p, const char* name, const Place& place) {
    for (const double v : {p.x, p.y, p.z}) place.number(v, name);
}

double distance(Point3 a, Point3 b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

void check(const Camera& camera, const Place& place) {
    check(camera.eye, "the camera's eye", place);
    check(camera.target, "the camera's target", place);
    check(camera.up, "the camera's up", place);
    const Point3 f{camera.target.x - camera.eye.x, camera.target.y - camera.eye.y,
                   camera.target.z - camera.eye.z};
    const Point3 u = camera.up;
    const Point3 across{f.y * u.z - f.z * u.y, f.z * u.x - f.x * u.z, f.x * u.y - f.y * u.x};
    if (!(distance(across, {}) > least_extent * distance(f, {})))
        place.refuse("the camera looks nowhere, or along its own up",
                     "move its eye or turn its up");
}

void check(const Ball& ball, const Place& place) {
    place.share(ball.style.opacity, "the opacity");
    check(ball.centre, "a ball's centre", place);
    place.length(ball.radius, "a ball's radius");
}

void check(const Facets& facets, const Place& place) {
    place.share(facets.style.opacity, "the opacity");
    check(facets.origin, "a surface's origin", place);
    for (const Point3& axis : facets.axes) check(axis, "a surface's axis", place);
    if (!facets.surface) place.refuse("there is no surface", "give it one");
    for (const Point3& v : facets.surface->vertices) check(v, "a surface's vertex", place);
}

void check(const SpaceScene& scene, const std::string& panel) {
    const Place place{panel};
    check(scene.camera, place);
    for (std::size_t i = 0; i < scene.balls.size(); ++i)
        check(scene.balls[i], Place{panel + ", ball " + std::to_string(i + 1)});
    for (std::size_t i = 0; i < scene.facets.size(); ++i)
        check(scene.facets[i], Place{panel + ", surface " + std::to_string(i + 1)});
    if (!scene.ground) return;
    place.number(scene.ground->height, "the ground's height");
    check(scene.ground->centre, "the ground's centre", place);
    for (const Ball& caster : scene.ground->casters) check(caster, place);
    if (!(scene.ground->spacing >= least_extent && scene.ground->reach >= least_extent) ||
        scene.ground->reach > largest || scene.ground->spacing > largest)
        place.refuse("the ground's grid is empty or endless", "give it a spacing and a reach");
}

}  // namespace

void check_figure(const Figure& figure) {
    const Place page{"the page"};
    page.number(figure.aspect, "the aspect");
    if (figure.aspect < 0.2 || figure.aspect > 5)
        page.refuse("the aspect is not within 0.2..5", "choose another");
    for (const double weight : figure.column_weights) page.length(weight, "a column's weight");
    for (const double weight : figure.row_weights) page.length(weight, "a row's weight");
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        const Panel& panel = figure.panels[p];
        const std::string name = "panel " + std::to_string(p + 1);
        check(panel, Place{name});
        if (panel.space) check(*panel.space, name);
        for (std::size_t m = 0; m < panel.marks.size(); ++m) {
            const Place place{name + ", mark " + std::to_string(m + 1)};
            std::visit(
                [&](const auto& mark) {
                    place.share(mark.style.opacity, "the opacity");
                    check(mark, place);
                },
                panel.marks[m]);
        }
    }
}

}  // namespace viz
