#pragma once

#include <vector>

#include "lodlab/viz/paint/page.hpp"

namespace viz {

struct Tick {
    double at = 0;
    std::string words;
};

/// Round numbers within low..high: 1, 2 or 5 times powers of ten, about `wanted` of them; powers of
/// ten (and 2 and 5 times them where few) on a logarithmic axis. The words of all ticks of a linear
/// axis have the same number of decimals.
[[nodiscard]] std::vector<Tick> ticks_of(const Axis& axis, double low, double high, int wanted);

/// The part of a cell that is left for the curves once the axes' words have their room.
[[nodiscard]] Rect plot_frame(const Panel& panel, const Rect& cell, Canvas& canvas);

/// Grid, zero lines, ticks and the axes' names.
void paint_axes(const Panel& panel, const PanelPlace& place, const PageInks& inks, Canvas& canvas);

}  // namespace viz
