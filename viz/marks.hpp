#pragma once

#include "viz/page.hpp"

namespace viz {

/// Draws the marks of a panel within its frame, in order, then its words, each where it covers
/// least.
void paint_marks(const Panel& panel, const PanelPlace& place, Theme theme, Rgb ground,
                 Canvas& canvas);

}  // namespace viz
