#include "lodlab/viz/paint/plot.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/viz/figure/number_text.hpp"
#include "lodlab/viz/paint/labels.hpp"

namespace viz {
namespace {

constexpr double tick_size = 15;
constexpr double name_size = 16;
constexpr double room_right = 16;
constexpr double room_top = 34;  ///< the vertical axis is named above its top, lying flat

Text tick_text(const std::string& words, const PageInks& inks, Align align) {
    return {.words = words, .size = tick_size, .ink = inks.muted, .align = align};
}

Text axis_name(const Axis& axis, const PageInks& inks, Align align) {
    const std::string scale = axis.scale == Scale::logarithmic ? ", logarithmic" : "";
    return {.words = axis.label + scale, .size = name_size, .ink = inks.text, .align = align};
}

double round_step(double rough) {
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= rough * 0.999) return step * power;
    return 10 * power;
}

std::vector<Tick> linear_ticks(const Axis& axis, double low, double high, int wanted) {
    double step = round_step((high - low) / std::max(1, wanted));
    if (axis.whole_numbers) step = std::max(1.0, std::round(step));
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    std::vector<Tick> ticks;
    const double first = std::ceil(low / step - 1e-9);
    for (double k = first; k * step <= high + 1e-9 * step && ticks.size() < 100; ++k) {
        const double at = k * step;
        const bool plain = decimals <= 6 && std::abs(at) < 1e6;
        ticks.push_back({at, plain ? fixed_text(at, decimals) : number_text(at)});
    }
    return ticks;
}

std::vector<Tick> logarithmic_ticks(double low, double high, int wanted) {
    const double decades = std::log10(high / low);
    const int every = std::max(1, static_cast<int>(std::ceil(decades / std::max(1, wanted))));
    const std::vector<double> factors =
        decades < 2 ? std::vector<double>{1, 2, 5} : std::vector<double>{1};
    std::vector<Tick> ticks;
    const int first = static_cast<int>(std::floor(std::log10(low)));
    const int last = static_cast<int>(std::ceil(std::log10(high)));
    for (int exponent = first; exponent <= last; ++exponent) {
        if (exponent % every != 0) continue;
        for (const double factor : factors) {
            const double at = factor * std::pow(10.0, exponent);
            if (at >= low * 0.999 && at <= high * 1.001) ticks.push_back({at, number_text(at)});
        }
    }
    return ticks;
}

int wanted_across(double width) {
    return std::clamp(static_cast<int>(width / 90), 2, 8);
}
int wanted_up(double height) {
    return std::clamp(static_cast<int>(height / 55), 2, 6);
}

/// Room at the right for the names of the curves that end there.
double room_for_names(const Panel& panel, Canvas& canvas) {
    double room = room_right;
    std::size_t names = 0;
    const double late = panel.view.low.x + 0.7 * (panel.view.high.x - panel.view.low.x);
    for (const Mark& mark : panel.marks) {
        const auto* curve = std::get_if<Polyline>(&mark);
        if (!curve || curve->end_label.empty() || curve->points.empty()) continue;
        if (curve->points.back().x < late) continue;
        const Text name{
            .words = curve->end_label, .size = label_size, .weight = Weight::medium, .ink = {}};
        room = std::max(room, canvas.measure(name).width + 16);
        ++names;
    }
    return names < fewest_in_column ? room : room + column_room;
}

}  // namespace

std::vector<Tick> ticks_of(const Axis& axis, double low, double high, int wanted) {
    if (axis.hidden) return {};
    if (!axis.ticks.empty()) {
        std::vector<Tick> ticks;
        for (const double at : axis.ticks)
            if (at >= low && at <= high) ticks.push_back({at, number_text(at)});
        return ticks;
    }
    if (axis.scale == Scale::logarithmic) return logarithmic_ticks(low, high, wanted);
    return linear_ticks(axis, low, high, wanted);
}

Rect plot_frame(const Panel& panel, const Rect& cell, Canvas& canvas) {
    double left = 0;
    for (const Tick& tick :
         ticks_of(panel.axes->y, panel.view.low.y, panel.view.high.y, wanted_up(cell.height - 70)))
        left =
            std::max(left, canvas.measure(tick_text(tick.words, PageInks{}, Align::right)).width);
    left += 10;
    const double bottom = panel.axes->x.hidden ? 6 : panel.axes->x.label.empty() ? 28 : 52;
    return {cell.x + left, cell.y + room_top,
            std::max(20.0, cell.width - left - room_for_names(panel, canvas)),
            std::max(20.0, cell.height - room_top - bottom)};
}

void paint_axes(const Panel& panel, const PanelPlace& place, const PageInks& inks, Canvas& canvas) {
    const Rect& frame = place.frame;
    const auto grid = [&](Point from, Point to, bool zero) {
        canvas.stroke({{from, to}}, false,
                      {zero ? inks.muted : inks.grid, zero ? 1.5 : 1.0, 1.0, false});
    };
    for (const Tick& tick :
         ticks_of(panel.axes->y, panel.view.low.y, panel.view.high.y, wanted_up(frame.height))) {
        const double y = place.mapping({panel.view.low.x, tick.at}).y;
        grid({frame.x, y}, {frame.right(), y}, tick.at == 0);
        const Text words = tick_text(tick.words, inks, Align::right);
        canvas.write(words, {frame.x - 8, y - canvas.measure(words).height / 2});
    }
    for (const Tick& tick :
         ticks_of(panel.axes->x, panel.view.low.x, panel.view.high.x, wanted_across(frame.width))) {
        const double x = place.mapping({tick.at, panel.view.low.y}).x;
        grid({x, frame.bottom()}, {x, frame.bottom() + 5}, false);
        canvas.write(tick_text(tick.words, inks, Align::centre), {x, frame.bottom() + 8});
    }
    canvas.write(axis_name(panel.axes->y, inks, Align::left),
                 {frame.x - 8, frame.y - room_top + 4});
    if (panel.axes->x.label.empty()) return;
    canvas.write(axis_name(panel.axes->x, inks, Align::right),
                 {frame.right(), frame.bottom() + 30});
}

}  // namespace viz
