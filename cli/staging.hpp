#pragma once

#include "cli/options.hpp"
#include "scenes/run.hpp"
#include "scenes/setup.hpp"

namespace cli {

/// Loads the scene that the options name, lets the options override what it says, builds its trees
/// and reports bodies that start inside each other.
[[nodiscard]] scenes::Setup stage(const Options& options);

/// Runs a staged scene under its limits, with a progress bar. `label` heads the bar.
/// Throws lod::Error (limit exceeded) when that takes more frames than the limit.
[[nodiscard]] scenes::Run<2> play(const scenes::Setup& setup, const Options& options,
                                  const std::string& label);

/// The same, from a trace.
[[nodiscard]] scenes::Run<2> play_again(const scenes::Setup& setup, const Options& options);

}  // namespace cli
