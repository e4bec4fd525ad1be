#pragma once

#include "viz/draw_scene.hpp"

namespace viz {

/// A body's tree level by level over its outline (the paper's figure 1): one panel a level, the
/// level's nodes and the leaves above it. `levels` empty: all, or the first five and the last where
/// there are more than six. The body is drawn as it stands.
[[nodiscard]] Figure tree_levels(const Actor& actor, std::vector<int> levels = {});

/// One level of it, for a picture of its own.
[[nodiscard]] Figure tree_level(const Actor& actor, int level);

/// The levels that a montage of so many shows.
[[nodiscard]] std::vector<int> montage_levels(int count);

}  // namespace viz
