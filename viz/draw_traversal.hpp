#pragma once

#include "viz/draw_scene.hpp"

namespace viz {

/// The traversal of a pair level by level (the paper's figure 2): the nodes tested at each level
/// thin, those that intersect and go on bold, leaf pairs doubled, until the bodies prove apart or
/// truly collide. `fronts` as lod::traverse_levels returns them. `levels` empty: all, or the first
/// five and the last where there are more than six.
[[nodiscard]] Figure traversal(const Actor& a, const Actor& b,
                               const std::vector<lod::Front>& fronts, std::vector<int> levels = {});

/// One level of it: a step of a lesson.
[[nodiscard]] Figure traversal_level(const Actor& a, const Actor& b,
                                     const std::vector<lod::Front>& fronts, int level);

/// The nodes of A (or B) that the tests of a level touched, in order.
struct TestedNodes {
    std::vector<int> a;
    std::vector<int> b;
};
[[nodiscard]] TestedNodes tested_nodes(const lod::Body<2>& a, const lod::Body<2>& b,
                                       const std::vector<lod::Front>& fronts, int level);

}  // namespace viz
