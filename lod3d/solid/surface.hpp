#pragma once

/// \file
/// A mesh as the true shape of a body, for exact contact.

#include <cstdint>

#include "lodlab/core/exact/walk_pairs.hpp"
#include "lodlab/lod3d/solid/solid.hpp"

namespace lod3d {

/// A mesh as a body's exact shape. Where closed parts overlap, hidden triangles count as boundary:
/// another body never reaches them.
class ExactSurface final : public lod::ExactShape<3> {
  public:
    /// Copies the solid's mesh.
    explicit ExactSurface(const Solid& solid);

    [[nodiscard]] double radius() const override { return radius_; }
    [[nodiscard]] std::uint64_t hash() const override { return hash_; }
    [[nodiscard]] std::span<const Point> witnesses() const override { return witnesses_; }
    /// Whether the solid holds the point.
    [[nodiscard]] bool holds(const Point& p) const override { return distance_.inside(p); }
    /// Walks the triangles of both by their trees of boxes.
    void visit_pairs(const lod::ExactShape<3>& b, const lod::Placement<3>& b_in_a,
                     lod::PartVisitor<3>& visitor) const override;
    /// The corners of the convex polygon, anticlockwise about the normal.
    void keep_corners(const Point& normal, double tolerance,
                      std::vector<lod::Contact<3>>& contacts) const override;

    /// A box of the tree of triangles.
    [[nodiscard]] lod::BoxNode<3> box_node(std::int32_t i) const;
    /// The three corners of a triangle.
    [[nodiscard]] lod::Facet<3> facet(std::int32_t triangle) const;

  private:
    MeshDistance distance_;
    std::vector<Point> witnesses_;  ///< a corner of every part
    double radius_ = 0;
    std::uint64_t hash_ = 0;
};

/// Where two triangles are nearest to each other. Corners run anticlockwise seen from outside.
[[nodiscard]] lod::PartPair<3> nearest_triangles(const lod::Facet<3>& a, const lod::Facet<3>& b,
                                                 double feet_within);

}  // namespace lod3d
