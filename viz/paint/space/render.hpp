#pragma once

#include <vector>

#include "lodlab/viz/paint/canvas/canvas.hpp"

namespace viz {

/// A shaded picture of a scene.
struct SpacePicture {
    Image image;               ///< colours premultiplied by how much they cover
    std::vector<float> depth;  ///< of the first surface that hides what is behind, one a pixel [m];
                               ///< infinite: none
};

struct SpaceRendering {
    Box view;         ///< the part of the panel that the picture covers
    int width = 0;    ///< pixels, > 0
    int height = 0;   ///< pixels, > 0
    double line = 1;  ///< pixels for a line of 1 px of a 1280-pixel page
    Theme theme = Theme::light;
};

/// Looks along the line of sight of every pixel, at nine samples where it matters: surfaces hide,
/// shine through and cut each other where they truly do, whatever their order. Light from the upper
/// left; a line round every ball, along silhouettes and sharp edges, and where meeting balls of two
/// bodies cut each other. The same input gives the same bits.
[[nodiscard]] SpacePicture render_space(const SpaceScene& scene, const SpaceRendering& choice);

}  // namespace viz
