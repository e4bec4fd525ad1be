#pragma once

/// \file
/// The true shape of a body that is a ball, or a few.

#include "lodlab/core/exact/walk_pairs.hpp"
#include "lodlab/core/math/box_tree.hpp"

namespace lod {

/// A union of balls as an exact shape: a body that is a ball, or what a level of a tree would be if
/// it were taken for the shape (figure 5 shows why it must not be).
template <int Dim>
class BallUnion final : public ExactShape<Dim> {
  public:
    /// Requires: at least one ball.
    explicit BallUnion(std::vector<Sphere<Dim>> balls);
    /// The level nodes of a tree.
    BallUnion(const SphereTree<Dim>& tree, int level);

    [[nodiscard]] double radius() const override { return radius_; }
    [[nodiscard]] std::uint64_t hash() const override { return hash_; }
    [[nodiscard]] std::span<const Vector<Dim>> witnesses() const override { return centres_; }
    [[nodiscard]] bool holds(const Vector<Dim>& p) const override;
    /// Walks the balls of both by trees of their boxes.
    void visit_pairs(const ExactShape<Dim>& b, const Placement<Dim>& b_in_a,
                     PartVisitor<Dim>& visitor) const override;
    /// Balls touch in single points: keeps all.
    void keep_corners(const Vector<Dim>&, double, std::vector<Contact<Dim>>&) const override {}

    /// Body frame.
    [[nodiscard]] std::span<const Sphere<Dim>> balls() const { return balls_; }
    /// A box of the tree of balls.
    [[nodiscard]] BoxNode<Dim> box_node(std::int32_t i) const;
    /// One of the balls.
    [[nodiscard]] const Sphere<Dim>& facet(std::int32_t i) const {
        return balls_[static_cast<std::size_t>(i)];
    }

  private:
    std::vector<Sphere<Dim>> balls_;
    BoxTree<Dim> tree_;
    std::vector<Vector<Dim>> centres_;
    double radius_ = 0;
    std::uint64_t hash_ = 0;
};

extern template class BallUnion<2>;
extern template class BallUnion<3>;

}  // namespace lod
