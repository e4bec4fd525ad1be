#pragma once

/// \file
/// Figures of a tree, level by level.

#include "lodlab/viz/draw/draw_scene.hpp"

namespace viz {

/// A body's tree level by level over its outline (the paper's figure 1): one panel a level, the
/// level's nodes and the leaves above it. `levels` empty: all, or the first five and the last where
/// there are more than six. The body is drawn as it stands.
template <int Dim>
[[nodiscard]] Figure tree_levels(const Actor<Dim>& actor, std::vector<int> levels = {},
                                 const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// One level of it, for a picture of its own.
template <int Dim>
[[nodiscard]] Figure tree_level(const Actor<Dim>& actor, int level,
                                const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// The levels that a montage of so many shows.
[[nodiscard]] std::vector<int> montage_levels(int count);

}  // namespace viz
