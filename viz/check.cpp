// Refuses what no picture can hold, before any of it reaches a drawing library.

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "viz/write.hpp"

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
