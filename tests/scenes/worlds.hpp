#pragma once

#include "lodlab/core/frame/frame.hpp"

/// A ball of radius 1 at rest, density such that its mass is 1 kg: with a tree of four leaves, so
/// that there is something to refine.
inline lod::Body<2> four_leaved(const lod::Vector<2>& position, const lod::Vector<2>& velocity) {
    std::vector<lod::TreeNode<2>> nodes(5);
    nodes[0] = {{{0, 0}, 1.5}, {0, 0}, {1, 2, 3, 4}};
    const double half = 0.5;
    nodes[1] = {{{half, half}, half}, {0, 0}, {}};
    nodes[2] = {{{-half, half}, half}, {0, 0}, {}};
    nodes[3] = {{{-half, -half}, half}, {0, 0}, {}};
    nodes[4] = {{{half, -half}, half}, {0, 0}, {}};
    lod::Body<2> body;
    body.tree = std::make_shared<const lod::SphereTree<2>>(lod::lay_out<2>(nodes));
    lod::set_mass<2>(body, 1.0, lod::Inertia<2>::Constant(0.5));
    body.position = position;
    body.velocity = velocity;
    return body;
}

/// Four bodies that meet in the middle, not at one instant and not head-on.
inline std::vector<lod::Body<2>> crossing() {
    return {four_leaved({-3, 0.1}, {2, 0}), four_leaved({3, 0}, {-1, 0}),
            four_leaved({0.2, 4}, {0, -2}), four_leaved({0, -4}, {0.1, 1.5})};
}
