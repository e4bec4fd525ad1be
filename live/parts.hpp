#pragma once

#include <span>

#include "lodlab/live/stage.hpp"
#include "lodlab/viz/draw/draw_scene.hpp"

// What the pictures of a stage as it stands and of a frame taken apart share.
namespace live::detail {

inline constexpr double normal_length = 0.06;    ///< of the view's longer side
inline constexpr double longest_impulse = 0.16;  ///< the same
inline constexpr std::size_t told_impulses = 4;  ///< have their value beside them

/// Of nodes that were tested: their body's ink where they are all that there is to see.
[[nodiscard]] viz::Role tested_role(const Stage& stage);

/// A line for each pair of nodes that meet, from centre to centre; none of a half-space, nor where
/// they are too many to be told apart.
void add_lines(viz::Panel& panel, const lod::Body<2>& a, const lod::Body<2>& b,
               std::span<const lod::NodePair> pairs, double opacity = 1);

/// The frame that is taken apart, as of Stage::event.
void add_inside(viz::Panel& panel, const Stage& stage);

/// Where that stands, in a sentence.
[[nodiscard]] std::string inside_finding(const Stage& stage);

}  // namespace live::detail
