#pragma once

/// \file
/// A body's tree carried to the world, as far as it is asked for.

#include <cstddef>
#include <span>

#include "lodlab/core/math/half_space.hpp"
#include "lodlab/core/tree/placement.hpp"

namespace lod {

/// A body's tree carried to the world frame (the paper's world_S), node by node, each when it is
/// asked for. A traversal asks for few: it tests families of nodes in the frame of one of the two
/// bodies.
template <int Dim>
class PosedTree {
  public:
    /// Takes over a pose.
    void pose(const Body<Dim>& body) { pose(body, Space<Dim>::rotation(body.orientation)); }
    /// The same of many bodies, faster. Requires: as many trees.
    static void pose_all(std::span<const Body<Dim>> bodies, std::span<PosedTree> posed);

    /// A node's ball, world frame: the same bits each time.
    [[nodiscard]] Sphere<Dim> sphere(int node) const {
        const auto n = static_cast<std::size_t>(node);
        Sphere<Dim> ball;
        for (int axis = 0; axis < Dim; ++axis) {
            double x = position()[axis];
            for (int d = 0; d < Dim; ++d)
                x += rotation()(axis, d) * tree_->centre[static_cast<std::size_t>(d)][n];
            ball.centre[axis] = x;
        }
        ball.radius = tree_->radius[n];
        return ball;
    }

    /// The root's, which every candidate pair asks for.
    [[nodiscard]] const Sphere<Dim>& root() const { return root_; }

    /// The node's mean normal (SphereTree::normal), turned to the world frame each time it is asked
    /// for: only the few nodes of a finished front need one.
    [[nodiscard]] Vector<Dim> mean_normal(int node) const {
        return rotation() * tree_->mean_normal(node);
    }

    /// Whether it stands for a half-space.
    [[nodiscard]] bool is_half_space() const { return tree_->is_half_space(); }
    /// World frame; its normal is a unit. Requires: is_half_space().
    [[nodiscard]] HalfSpace<Dim> half_space() const {
        const Vector<Dim> normal = rotation() * *tree_->half_space;
        return {normal, normal.dot(position())};
    }

    /// Body frame to world frame.
    [[nodiscard]] const Placement<Dim>& placement() const { return placement_; }
    /// Of the placement.
    [[nodiscard]] const Matrix<Dim>& rotation() const { return placement_.rotation; }
    /// Of the body's centre of mass, world frame [m].
    [[nodiscard]] const Vector<Dim>& position() const { return placement_.position; }
    /// The tree in the body frame. Requires: pose() was called.
    [[nodiscard]] const SphereTree<Dim>& tree() const { return *tree_; }
    /// Bound of all rounding between the pose and the verdict of a distance test, this body's share
    /// [m]: a test adds it to its reach, so that rounding never calls touching bodies apart. The
    /// test against a half-space, a sum of products of coordinates, adds it twice.
    [[nodiscard]] double rounding() const { return rounding_; }

  private:
    void pose(const Body<Dim>& body, const Matrix<Dim>& rotation);

    const SphereTree<Dim>* tree_ = nullptr;
    Placement<Dim> placement_;
    Sphere<Dim> root_;
    double rounding_ = 0;
};

extern template class PosedTree<2>;
extern template class PosedTree<3>;

}  // namespace lod
