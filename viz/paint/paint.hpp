#pragma once

#include "lodlab/viz/paint/canvas/canvas.hpp"

namespace viz {

/// Draws the whole figure on a canvas of the page's size.
void paint(const Figure& figure, Theme theme, Canvas& canvas);

/// Height of the figure's page, whose width is page_width.
[[nodiscard]] double page_height(const Figure& figure);

/// Pixels for one page unit.
[[nodiscard]] double pixels_per_unit(Quality quality);

/// The figure as pixels, both sides even. Throws as check_figure does.
[[nodiscard]] Image rasterise(const Figure& figure, Theme theme, Quality quality);

}  // namespace viz
