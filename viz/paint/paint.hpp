#pragma once

#include "lodlab/viz/paint/canvas/canvas.hpp"
#include "lodlab/viz/paint/page.hpp"

namespace viz {

/// Draws the whole figure on a canvas of the page's size.
void paint(const Figure& figure, Theme theme, Canvas& canvas, double width = page_width);

/// Height of the figure's page.
[[nodiscard]] double page_height(const Figure& figure, double width = page_width);

/// Where the panels of a figure stand on its page of that width.
[[nodiscard]] std::vector<PanelPlace> panel_places(const Figure& figure, double width = page_width);

/// Pixels for one page unit.
[[nodiscard]] double pixels_per_unit(Quality quality);

/// The figure as pixels, both sides even. Throws as check_figure does.
[[nodiscard]] Image rasterise(const Figure& figure, Theme theme, Quality quality);

}  // namespace viz
