#pragma once

/// \file
/// Figures of a traversal, level by level.

#include "lodlab/viz/draw/draw_scene.hpp"

namespace viz {

/// What traversal shows.
struct TraversalChoice {
    /// Empty: all, or the first five and the last where there are more than six.
    std::vector<int> levels{};
    /// Though nodes of the last level intersect, their hulls or the true shapes do not.
    bool proved_apart = false;
};

/// The traversal of a pair level by level (the paper's figure 2): the nodes tested at each level
/// thin, those that intersect and go on bold, leaf pairs doubled, until the bodies prove apart or
/// truly collide. `fronts` as lod::traverse_levels returns them.
template <int Dim>
[[nodiscard]] Figure traversal(const Actor<Dim>& a, const Actor<Dim>& b,
                               const std::vector<lod::Front>& fronts,
                               const TraversalChoice& choice = {},
                               const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// One level of it: a step of a lesson.
template <int Dim>
[[nodiscard]] Figure traversal_level(const Actor<Dim>& a, const Actor<Dim>& b,
                                     const std::vector<lod::Front>& fronts, int level,
                                     const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// The nodes of A (or B) that the tests of a level touched, in order.
struct TestedNodes {
    std::vector<int> a;
    std::vector<int> b;
};
/// `fronts` as lod::traverse_levels returns them, down to the level before at least.
template <int Dim>
[[nodiscard]] TestedNodes tested_nodes(const lod::Body<Dim>& a, const lod::Body<Dim>& b,
                                       const std::vector<lod::Front>& fronts, int level);

/// The same of the first `tests` of the level after a front: of one that was cut short there.
template <int Dim>
[[nodiscard]] TestedNodes tested_nodes(const lod::Body<Dim>& a, const lod::Body<Dim>& b,
                                       const lod::Front& front, std::uint64_t tests);

}  // namespace viz
