#pragma once

#include <string>

#include "lodlab/viz/paint/canvas/canvas.hpp"

namespace viz {

/// The picture laid over a ground of one ink: opaque.
[[nodiscard]] Image over_ground(const Image& picture, Rgb ground);

/// An opaque picture as a link that holds it: "data:image/webp;base64,...". Lossy, at a quality at
/// which the lines of a shaded picture stay clear.
[[nodiscard]] std::string webp_link(const Image& opaque);

}  // namespace viz
