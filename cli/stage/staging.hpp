#pragma once

#include "cli/arguments/options.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"

namespace cli {

/// The user's cache of trees, unless the options say no.
[[nodiscard]] io::TreeCache cache_of(const Options& options);

/// The scene that the options name, with what the options override. Throws lod::Error as
/// scenes::load_scene does; limit exceeded where it has more frames than the limit.
[[nodiscard]] scenes::Scene scene_of(const Options& options);

/// Builds the trees of a scene, with a progress bar, and reports bodies that start inside each
/// other.
template <int Dim>
[[nodiscard]] scenes::Setup<Dim> stage(const scenes::Scene& scene, const Options& options);

/// Runs a staged scene under its limits, with a progress bar. `label` heads the bar.
/// Throws lod::Error (limit exceeded) when that takes more frames than the limit.
template <int Dim>
[[nodiscard]] scenes::Run<Dim> play(const scenes::Setup<Dim>& setup, const Options& options,
                                    const std::string& label);

/// How a staged scene is run: under its limits, on the clock.
[[nodiscard]] scenes::RunOptions run_options(const scenes::Scene& scene);

/// Throws lod::Error (limit exceeded) when the scene takes more frames than the limit.
void check_frames(const scenes::Scene& scene, const Options& options);

}  // namespace cli
