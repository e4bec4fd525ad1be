#pragma once

/// \file
/// A video of a turning sphere tree.

#include "lodlab/viz/draw/draw_scene.hpp"

namespace viz {

/// How the film goes.
struct Turntable {
    double frames_per_second = 30;
    double seconds_per_level = 3;
    double turns = 1;        ///< of the whole film, a whole number for a loop without a seam
    double elevation = 0.3;  ///< of the eye above the ground [rad]
    std::string title;       ///< empty: whose tree it is
};

/// A body in space that turns while its sphere tree passes level by level, in perspective. A loop:
/// the last level fades into the first. `levels` empty: all, or the first five and the last where
/// there are more than six. Throws lod::Error (usage) for a rate or time that is not above zero.
[[nodiscard]] Animation turntable(const Actor<3>& actor, std::vector<int> levels = {},
                                  const Turntable& choice = {});

}  // namespace viz
