#pragma once

/// \file
/// A body's tree carried to the world, as far as it is asked for.

#include <array>
#include <cstdint>
#include <vector>

#include "lodlab/core/math/half_space.hpp"
#include "lodlab/core/tree/body.hpp"

namespace lod {

/// A body's tree carried to the world frame (the paper's world_S). Only the nodes that a test
/// touches are carried, once a pose, a whole family of children at a time.
template <int Dim>
class PosedTree {
  public:
    /// The arrays end with room for a whole block of the distance test: `lanes` numbers may be read
    /// from any node on.
    static constexpr int lanes = 4;

    /// Takes over a pose; forgets every node carried for the pose before. Allocates only when the
    /// tree is larger than any before it.
    void pose(const Body<Dim>& body);

    /// Carries the children of `parent`, unless that is done already. The root needs no call.
    void carry_children(int parent);

    /// Requires: the node was carried (the root is at once).
    [[nodiscard]] Sphere<Dim> sphere(int node) const;

    /// The node's mean normal (SphereTree::normal), turned to the world frame each time it is asked
    /// for: only the few nodes of a finished front need one. No node need be carried for it.
    [[nodiscard]] Vector<Dim> mean_normal(int node) const {
        return rotation_ * tree_->mean_normal(node);
    }

    /// Whether it stands for a half-space.
    [[nodiscard]] bool is_half_space() const { return tree_->is_half_space(); }
    /// World frame; its normal is a unit. Requires: is_half_space().
    [[nodiscard]] HalfSpace<Dim> half_space() const {
        const Vector<Dim> normal = rotation_ * *tree_->half_space;
        return {normal, normal.dot(position_)};
    }

    /// Body frame to world frame.
    [[nodiscard]] const Matrix<Dim>& rotation() const { return rotation_; }
    /// Of the body's centre of mass, world frame [m].
    [[nodiscard]] const Vector<Dim>& position() const { return position_; }
    /// The tree in the body frame. Requires: pose() was called.
    [[nodiscard]] const SphereTree<Dim>& tree() const { return *tree_; }
    /// Bound of all rounding between the pose and the verdict of a distance test, this body's share
    /// [m]: a test adds it to its reach, so that rounding never calls touching bodies apart. The
    /// test against a half-space, a sum of products of coordinates, adds it twice.
    [[nodiscard]] double rounding() const { return rounding_; }
    /// One coordinate of every node, world frame; set for carried nodes.
    [[nodiscard]] const double* centres(int axis) const {
        return centre_[static_cast<std::size_t>(axis)].data();
    }
    /// Of every node [m].
    [[nodiscard]] const double* radii() const { return radius_.data(); }
    /// How many nodes this pose has carried so far: a measure of work.
    [[nodiscard]] int carried_nodes() const { return carried_nodes_; }

  private:
    void carry(int first, int count);

    const SphereTree<Dim>* tree_ = nullptr;
    Matrix<Dim> rotation_ = Matrix<Dim>::Identity();
    Vector<Dim> position_ = Vector<Dim>::Zero();
    double rounding_ = 0;
    std::array<std::vector<double>, Dim> centre_;
    std::vector<double> radius_;
    std::vector<std::uint64_t> carried_for_;  ///< of a parent: the pose its children stand in
    std::uint64_t pose_number_ = 0;
    int carried_nodes_ = 0;
};

extern template class PosedTree<2>;
extern template class PosedTree<3>;

}  // namespace lod
