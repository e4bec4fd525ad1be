#pragma once

/// \file
/// The true shape of a body that is a ball, or a few.

#include "lodlab/core/exact/exact_shape.hpp"

namespace lod {

/// A union of balls as an exact shape: a body that is a ball, or what a level of a tree would be if
/// it were taken for the shape (figure 5 shows why it must not be). Two unions are compared ball by
/// ball: for trees' coarse levels.
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
    /// Walks every ball of one against every ball of the other.
    void visit_pairs(const ExactShape<Dim>& b, const Placement<Dim>& b_in_a,
                     PartVisitor<Dim>& visitor) const override;
    /// Balls touch in single points: keeps all.
    void keep_corners(const Vector<Dim>&, double, std::vector<Contact<Dim>>&) const override {}

    /// Body frame.
    [[nodiscard]] std::span<const Sphere<Dim>> balls() const { return balls_; }

  private:
    std::vector<Sphere<Dim>> balls_;
    std::vector<Vector<Dim>> centres_;
    double radius_ = 0;
    std::uint64_t hash_ = 0;
};

extern template class BallUnion<2>;
extern template class BallUnion<3>;

}  // namespace lod
