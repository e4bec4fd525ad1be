#pragma once

/// \file
/// Figures of curves.

#include "lodlab/viz/figure/figure.hpp"

namespace viz {

/// One curve of a plot, named at its end. `low` and `high`, where given, are the 10-90 % band: one
/// value for each point.
struct Curve {
    std::string name;
    std::vector<Point> points;
    std::vector<double> low;
    std::vector<double> high;
    int series = 0;          ///< whose ink: that of body `series`
    bool reference = false;  ///< exact or Box2D: dashed
    bool dots = false;       ///< a dot on every point: measured at few places
};

/// A panel of curves with direct labels. Without a view: all that is drawn, from zero where the
/// values are not far from it (and not on a logarithmic axis). Points that a logarithmic axis
/// cannot show (<= 0) or that are not finite are left out.
[[nodiscard]] Panel plot_panel(const std::string& title, const Axes& axes,
                               const std::vector<Curve>& curves,
                               const std::optional<Box>& view = {});

/// A plot with a page of its own. `samples` goes into the caption when it is above zero.
[[nodiscard]] Figure plot(const std::string& title, const Axes& axes,
                          const std::vector<Curve>& curves, const std::string& caption,
                          long long samples = 0);

}  // namespace viz
