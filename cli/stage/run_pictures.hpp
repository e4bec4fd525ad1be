#pragma once

#include "cli/arguments/options.hpp"
#include "cli/stage/pictures.hpp"
#include "lodlab/viz/draw/motion/draw_crowd.hpp"

namespace cli {

/// What a picture of a crowd needs to know of its run.
[[nodiscard]] viz::CrowdChoice crowd_choice(const lod::FrameSettings& settings,
                                            const scenes::Limits& limits);

/// Throws lod::Error (usage) where --quota asks for what a run under these limits has not.
void check_quota(const Options& options, const scenes::Limits& limits);

/// What `simulate` draws of a run: strip, plot or what a quota was spent on as a still, and the
/// motion as a video, of a crowd under a quota with what that was spent on.
template <int Dim>
[[nodiscard]] Drawing drawing_of(const scenes::Setup<Dim>& setup, const scenes::Run<Dim>& run,
                                 const Options& options);

}  // namespace cli
