#pragma once

#include "cli/options.hpp"
#include "cli/pictures.hpp"

namespace cli {

/// What `simulate` draws of a run: strip or plot as a still, and the motion as a video.
[[nodiscard]] Drawing drawing_of(const scenes::Setup& setup, const scenes::Run<2>& run,
                                 const Options& options);

}  // namespace cli
