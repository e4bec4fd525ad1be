#pragma once

#include "cli/arguments/options.hpp"
#include "cli/stage/pictures.hpp"

namespace cli {

/// What `simulate` draws of a run: strip or plot as a still, and the motion as a video.
template <int Dim>
[[nodiscard]] Drawing drawing_of(const scenes::Setup<Dim>& setup, const scenes::Run<Dim>& run,
                                 const Options& options);

}  // namespace cli
