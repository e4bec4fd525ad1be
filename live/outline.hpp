#pragma once

/// \file
/// Bodies from outlines that a reader drew, and a scene in which they meet.

#include <string>
#include <string_view>
#include <vector>

#include "lodlab/live/scene.hpp"

namespace live {

/// Corners of an outline, at most.
inline constexpr std::size_t most_corners = 400;
/// Levels below the root of a drawn body's tree, at most.
inline constexpr int most_depth = 6;

/// A closed line without holes, in any unit.
struct DrawnOutline {
    std::string name;
    viz::Ring ring;
};

/// One body, or two that approach each other at 1.2 m/s, each 1 m long, with a tree of so many
/// levels below the root. Throws lod::Error (input refused), with the mend, for another number of
/// outlines, one with fewer than three corners or more than most_corners, one that crosses or
/// touches itself or bounds no area, and for a depth beyond most_depth.
[[nodiscard]] Scene scene_of(const std::vector<DrawnOutline>& outlines, int depth);

/// The same from JSON: {"depth": 4, "outlines": [{"name", "points": [x, y, x, y, ...]}]}.
[[nodiscard]] Scene scene_of_outlines(std::string_view text);

}  // namespace live
