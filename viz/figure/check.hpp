#pragma once

#include "lodlab/viz/figure/figure.hpp"

namespace viz {

/// Throws lod::Error (input refused) unless the figure can be drawn: every number finite and of a
/// size that a picture can hold (below 1e12), radii >= 0, opacities within 0..1, views not empty,
/// logarithmic axes above 0.
void check_figure(const Figure& figure);

}  // namespace viz
