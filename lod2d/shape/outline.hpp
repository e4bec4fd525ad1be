#pragma once

/// \file
/// A polygon as the true shape of a body, for exact contact.

#include <cstdint>
#include <memory>

#include "lodlab/core/exact/walk_pairs.hpp"
#include "lodlab/lod2d/shape/distance.hpp"

namespace lod2d {

/// A polygon as a body's exact shape.
class ExactOutline final : public lod::ExactShape<2> {
  public:
    /// Copies the shape's polygon.
    explicit ExactOutline(const Shape& shape);

    [[nodiscard]] double radius() const override { return radius_; }
    [[nodiscard]] std::uint64_t hash() const override { return hash_; }
    [[nodiscard]] std::span<const Point> witnesses() const override { return witnesses_; }
    /// Whether the closed region holds the point.
    [[nodiscard]] bool holds(const Point& p) const override { return index_.inside(p); }
    /// Walks the edges of both by their trees of boxes.
    void visit_pairs(const lod::ExactShape<2>& b, const lod::Placement<2>& b_in_a,
                     lod::PartVisitor<2>& visitor) const override;
    /// The two end points.
    void keep_corners(const Point& normal, double tolerance,
                      std::vector<lod::Contact<2>>& contacts) const override;

    /// A box of the tree of edges.
    [[nodiscard]] lod::BoxNode<2> box_node(std::int32_t i) const;
    /// The two ends of an edge.
    [[nodiscard]] lod::Facet<2> facet(std::int32_t edge) const;

  private:
    BoundaryIndex index_;
    std::vector<Point> witnesses_;  ///< the first point of every ring
    double radius_ = 0;
    std::uint64_t hash_ = 0;
};

/// Where two edges are nearest to each other. An edge runs with its region on its left.
[[nodiscard]] lod::PartPair<2> nearest_edges(const lod::Facet<2>& a, const lod::Facet<2>& b,
                                             double feet_within);

}  // namespace lod2d
