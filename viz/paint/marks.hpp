#pragma once

#include <functional>

#include "lodlab/viz/paint/page.hpp"

namespace viz {

/// What a panel is painted with.
struct PanelInk {
    Theme theme = Theme::light;
    Rgb ground;  ///< behind its marks
};

/// Draws the marks of a panel within its frame, in order, then its words, each where it covers
/// least.
/// `hidden` says whether a point of the page at a depth lies behind a surface of the panel's scene.
using Hidden = std::function<bool(Point at, double depth)>;
void paint_marks(const Panel& panel, const PanelPlace& place, const PanelInk& ink,
                 const Hidden& hidden, Canvas& canvas);

}  // namespace viz
