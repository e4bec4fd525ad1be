#include "lodlab/viz/draw/motion/draw_plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

bool shows(const Axis& axis, double value) {
    return std::isfinite(value) && (axis.scale == Scale::linear || value > 0);
}

/// The curve without what the axes cannot show.
Curve shown(const Curve& curve, const Axes& axes) {
    Curve kept = curve;
    kept.points.clear();
    kept.low.clear();
    kept.high.clear();
    const bool band =
        curve.low.size() == curve.points.size() && curve.high.size() == curve.points.size();
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const Point p = curve.points[i];
        if (!shows(axes.x, p.x) || !shows(axes.y, p.y)) continue;
        if (band && (!shows(axes.y, curve.low[i]) || !shows(axes.y, curve.high[i]))) continue;
        kept.points.push_back(p);
        if (!band) continue;
        kept.low.push_back(curve.low[i]);
        kept.high.push_back(curve.high[i]);
    }
    return kept;
}

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void take_in(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// Rounds a range outwards: a little air above, zero where it is near.
void make_room(Range& range, const Axis& axis, bool across) {
    if (range.low > range.high) range = {1, 2};  // nothing to show
    if (axis.scale == Scale::logarithmic) {
        if (range.high / range.low < 10) {
            range.low /= std::sqrt(10.0);
            range.high *= std::sqrt(10.0);
        } else if (!across) {
            range.low /= 1.3;
            range.high *= 1.3;
        }
        return;
    }
    if (across && range.high > range.low) return;
    const double size = std::max(std::abs(range.low), std::abs(range.high));
    if (range.low > 0 && range.low < 0.7 * range.high) range.low = 0;
    if (range.high < 0 && range.high > 0.7 * range.low) range.high = 0;
    double spread = range.high - range.low;
    if (spread < 1e-9 * size || spread == 0) spread = size == 0 ? 1 : 0.2 * size;
    if (range.high > 0 || range.low == range.high) range.high += 0.08 * spread;
    if (range.low < 0) range.low -= 0.08 * spread;
    if (range.high - range.low < 0.5 * spread) range.low -= spread;
}

Box view_of(const std::vector<Curve>& curves, const Axes& axes) {
    Range x;
    Range y;
    for (const Curve& curve : curves) {
        for (const Point& p : curve.points) {
            x.take_in(p.x);
            y.take_in(p.y);
        }
        for (const double value : curve.low) y.take_in(value);
        for (const double value : curve.high) y.take_in(value);
    }
    make_room(x, axes.x, true);
    make_room(y, axes.y, false);
    return {{x.low, y.low}, {x.high, y.high}};
}

Path band_of(const Curve& curve) {
    Ring ring;
    for (std::size_t i = 0; i < curve.points.size(); ++i)
        ring.push_back({curve.points[i].x, curve.low[i]});
    for (std::size_t i = curve.points.size(); i-- > 0;)
        ring.push_back({curve.points[i].x, curve.high[i]});
    return {{.role = Role::band, .body = curve.series}, {ring}};
}

}  // namespace

Panel plot_panel(const std::string& title, const Axes& axes, const std::vector<Curve>& curves,
                 const std::optional<Box>& view) {
    std::vector<Curve> kept;
    for (const Curve& curve : curves) kept.push_back(shown(curve, axes));
    Panel panel;
    panel.title = title;
    panel.axes = axes;
    panel.view = view ? *view : view_of(kept, axes);
    for (const Curve& curve : kept)
        if (!curve.low.empty()) panel.marks.push_back(band_of(curve));
    for (const Curve& curve : kept) {
        const Style style{.role = curve.reference ? Role::reference : Role::curve,
                          .body = curve.series};
        panel.marks.push_back(Polyline{style, curve.points, 1, curve.name});
        if (!curve.dots) continue;
        for (const Point& p : curve.points) panel.marks.push_back(Dot{style, p, 0.7});
    }
    return panel;
}

Figure plot(const std::string& title, const Axes& axes, const std::vector<Curve>& curves,
            const std::string& caption, long long samples) {
    Figure figure;
    figure.title = title;
    figure.caption = caption;
    if (samples > 0) figure.caption.append(" ").append(count_text(samples, "sample")).append(".");
    figure.panels.push_back(plot_panel("", axes, curves));
    figure.alt = plain_text(title) + ". A plot of " + plain_text(axes.y.label) + " against " +
                 plain_text(axes.x.label) + ".";
    for (const Curve& curve : curves) {
        if (curve.points.empty()) continue;
        const Point from = curve.points.front();
        const Point to = curve.points.back();
        figure.alt += ' ';
        figure.alt += plain_text(curve.name) + ": from " + number_text(from.y) + " at " +
                      number_text(from.x) + " to " + number_text(to.y) + " at " +
                      number_text(to.x) + ".";
    }
    return figure;
}

}  // namespace viz
