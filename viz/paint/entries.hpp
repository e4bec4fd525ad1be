#pragma once

#include <span>

#include "lodlab/viz/paint/canvas/canvas.hpp"

namespace viz {

/// A list: a line each of a swatch, words, and a value at the right end; lines move together where
/// there are many.
void paint_entries(std::span<const Entry> entries, const Rect& frame, Theme theme, Canvas& canvas);

}  // namespace viz
