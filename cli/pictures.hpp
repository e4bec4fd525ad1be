#pragma once

#include <functional>
#include <string>

#include "cli/options.hpp"
#include "scenes/run.hpp"
#include "scenes/setup.hpp"
#include "viz/scene_view.hpp"
#include "viz/write.hpp"

namespace cli {

/// A shape's outline as pictures take it.
[[nodiscard]] viz::Look<2> look_of(const lod2d::Shape& shape, const std::string& name);

/// A body of a staged scene, in the state that `bodies` holds.
[[nodiscard]] viz::Actor<2> actor_of(const scenes::Setup& setup,
                                     const std::vector<lod::Body<2>>& bodies, std::int32_t number);

/// A run as pictures take it. `name` heads its row or panel.
[[nodiscard]] viz::Run<2> seen(const scenes::Setup& setup, const scenes::Run<2>& run,
                               const std::string& name);

[[nodiscard]] viz::Theme theme_of(const Options& options);
[[nodiscard]] viz::Quality quality_of(const Options& options);

/// What a command draws: only what an --out asks for is made.
struct Drawing {
    std::function<viz::Figure()> figure;        ///< nothing: the command has no still picture
    std::function<viz::Animation()> animation;  ///< nothing: the command has no video
    std::function<void(const std::string& path)> json;  ///< nothing: a .json is the figure's data
};

/// Before any work: throws lod::Error, usage for an ending that the command does not write, output
/// failed for a place that cannot be written.
void check_outputs(const Options& options, bool has_video);

/// Writes every --out, with a progress bar for videos.
void write_outputs(const Options& options, const Drawing& drawing);

}  // namespace cli
