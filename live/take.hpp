#pragma once

/// \file
/// From a scene of a file, set up, to one that a page holds.

#include "lodlab/live/scene.hpp"
#include "lodlab/scenes/setup.hpp"

namespace live {

/// Bodies of a page, at most: more are no longer followed at the pace of a screen.
inline constexpr std::size_t most_bodies = 100;

/// The scene as a page holds it. Its view is that of its camera, else it frames all that moves
/// until the end of its duration. A budget on the clock is left out: a page counts node tests.
/// Throws lod::Error (limit exceeded) for more bodies than most_bodies, and as scenes::run does.
[[nodiscard]] Scene scene_of(const scenes::Setup<2>& setup);

}  // namespace live
