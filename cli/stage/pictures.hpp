#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "cli/arguments/options.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"
#include "lodlab/viz/draw/scene_view.hpp"
#include "lodlab/viz/paint/options.hpp"

namespace cli {

/// A shape's outline or surface as pictures take it.
template <int Dim>
[[nodiscard]] viz::Visual<Dim> visual_of(const scenes::Shape<Dim>& shape, const std::string& name);

/// A body of a staged scene, in the state that `bodies` holds.
template <int Dim>
[[nodiscard]] viz::Actor<Dim> actor_of(const scenes::Setup<Dim>& setup,
                                       const std::vector<lod::Body<Dim>>& bodies,
                                       std::int32_t number);

/// A run as pictures take it. `name` heads its row or panel.
template <int Dim>
[[nodiscard]] viz::Run<Dim> seen(const scenes::Setup<Dim>& setup, const scenes::Run<Dim>& run,
                                 const std::string& name);

/// From where a scene's camera sees it.
template <int Dim>
[[nodiscard]] typename viz::DrawTraits<Dim>::Viewpoint viewpoint_of(const scenes::Scene& scene);

/// The figure with its scenes seen by the scene's camera, where that says how much it sees.
template <int Dim>
[[nodiscard]] viz::Figure framed(viz::Figure figure, const scenes::Scene& scene);
template <int Dim>
[[nodiscard]] viz::Animation framed(viz::Animation animation, const scenes::Scene& scene);

[[nodiscard]] viz::Theme theme_of(const Options& options);
[[nodiscard]] viz::Quality quality_of(const Options& options);

/// A file that is no picture: written by the command itself.
struct Export {
    std::string ending;  ///< ".sph"
    std::function<void(const std::string& path)> write;
};

/// What a command draws: only what an --out asks for is made.
struct Drawing {
    std::function<viz::Figure()> figure;        ///< nothing: the command has no still picture
    std::function<viz::Animation()> animation;  ///< nothing: the command has no video
    /// The first one whose ending fits is taken; a .json of none of them is the figure's data.
    std::vector<Export> exports;
};

/// Writes every --out, with a progress bar for videos.
void write_outputs(const Options& options, const Drawing& drawing);

}  // namespace cli
