#pragma once

/// \file
/// Trees of circles or spheres: what builders make, files hold and frames traverse.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lodlab/core/math/sphere.hpp"
#include "lodlab/core/tree/hull.hpp"

namespace lod {

/// A circle tree or sphere tree in the body frame (the paper's body_S), stored level by level, the
/// children of a node side by side, one array a coordinate, so that one node can be tested against
/// all children of another with SIMD.
///
/// Node 0 is the root. Nodes of level k are [level_begin[k], level_begin[k + 1]). A leaf has no
/// children; leaves may lie at any level. What a tree stands for at level k are its *level nodes*:
/// the nodes of level k and the leaves above it.
template <int Dim>
struct SphereTree {
    std::array<std::vector<double>, Dim> centre;  ///< body frame [m]
    std::vector<double> radius;                   ///< [m], >= 0
    std::vector<std::int32_t> first_child;        ///< undefined for a leaf
    std::vector<std::int32_t> child_count;        ///< 0 for a leaf
    std::vector<std::int32_t> parent;             ///< -1 for the root
    std::vector<std::int32_t> level_begin;        ///< levels() + 1 entries, the last is size()
    /// Mean outward unit normal of the surface that the node stands for, body frame. Its length,
    /// the coherence, is 1 on a flat face and near 0 on a corner; zero where a node has no surface.
    std::array<std::vector<double>, Dim> normal;
    NodeHulls<Dim> hulls;  ///< of each node, or none
    /// Radius of the ball about the body's origin that holds every node [m]; lay_out sets it. It
    /// bounds the rounding of a posed tree.
    double extent = 0;
    /// A copy of centres and radii in single precision, for tests of whole families: x, y, (z) and
    /// radius of the root, then of each family in turn all x, all y, (all z), all radii, and some
    /// zeros. lay_out sets it; without it, or with one of another length, tests take longer.
    std::vector<float> single;
    /// Of each level, an estimate of how far its nodes stand out of the leaves' union [m], 0 at the
    /// last; lay_out sets it. A ball's excess over its children is taken in few directions; those
    /// of a level's worst ball and of the worst below it add up.
    std::vector<double> level_error;
    /// Of a half-space: the outward unit normal of its border, which goes through the origin. Its
    /// only node stands for all of it, exactly; that node's ball is meaningless.
    std::optional<Vector<Dim>> half_space;

    /// Nodes.
    [[nodiscard]] int size() const { return static_cast<int>(radius.size()); }
    /// The root's included.
    [[nodiscard]] int levels() const { return static_cast<int>(level_begin.size()) - 1; }
    /// Whether it stands for a half-space.
    [[nodiscard]] bool is_half_space() const { return half_space.has_value(); }
    /// Whether its nodes have hulls, as those of every builder here do.
    [[nodiscard]] bool has_hulls() const { return !hulls.empty(); }
    /// Whether the node has no children.
    [[nodiscard]] bool is_leaf(int node) const { return child_count[index(node)] == 0; }
    /// The node's ball, body frame.
    [[nodiscard]] Sphere<Dim> sphere(int node) const;
    /// The node's entry of `normal`.
    [[nodiscard]] Vector<Dim> mean_normal(int node) const;
    /// 0 for the root.
    [[nodiscard]] int level_of(int node) const;

    /// The nodes of level k and the leaves above it, in order of their numbers.
    [[nodiscard]] std::vector<int> level_nodes(int level) const;

    /// Zeros at the end of `single`, so that a whole block of numbers may be read from any on.
    static constexpr std::size_t single_room = 16;

    /// The entry of `level_error`; 0 beyond the last level.
    [[nodiscard]] double error_at(int level) const {
        return level < static_cast<int>(level_error.size()) ? level_error[index(level)] : 0;
    }

    /// A node's number as the index of an array.
    static std::size_t index(int node) { return static_cast<std::size_t>(node); }
};

/// A tree as it is grown: nodes in any order, each naming its children.
template <int Dim>
struct TreeNode {
    Sphere<Dim> sphere;
    Vector<Dim> mean_normal = Vector<Dim>::Zero();
    std::vector<int> children;
};

/// Lays nodes out level by level. Requires: nodes[0] is the root and every node is reached from it
/// exactly once; otherwise throws Error (input refused).
template <int Dim>
[[nodiscard]] SphereTree<Dim> lay_out(std::span<const TreeNode<Dim>> nodes);

/// Sets anew what lay_out takes from centres and radii (extent, single, level_error). Call it where
/// these were changed afterwards: else distance tests still see the old ones.
template <int Dim>
void renew(SphereTree<Dim>& tree);

/// A tree of a single node, for bodies that are balls.
template <int Dim>
[[nodiscard]] SphereTree<Dim> single_sphere(const Sphere<Dim>& sphere);

/// What stands for the half-space on the other side of its border through the origin, for walls and
/// floors: no tree, but one node that is met exactly at every level. `normal` points outwards; it
/// is made a unit. Throws Error (input refused) for one that is zero or not finite.
template <int Dim>
[[nodiscard]] SphereTree<Dim> half_space(const Vector<Dim>& normal);

extern template struct SphereTree<2>;
extern template struct SphereTree<3>;

}  // namespace lod
