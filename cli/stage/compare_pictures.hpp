#pragma once

#include "cli/stage/pictures.hpp"
#include "lodlab/measure/comparison.hpp"

namespace cli {

/// What `compare` draws: the runs laid over Box2D's as a still, side by side with it as a video.
/// Both arguments must outlive the result.
[[nodiscard]] Drawing drawing_of(const scenes::Setup<2>& setup,
                                 const measure::Comparison& comparison);

}  // namespace cli
