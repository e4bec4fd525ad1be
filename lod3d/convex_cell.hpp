#pragma once

#include <span>
#include <vector>

#include "lodlab/core/builder/half_space.hpp"
#include "lodlab/lod3d/mesh.hpp"

namespace lod3d {

/// Appends the part of a convex polygon in space that lies in the half-space. Cut points stand
/// between the two corners of the cut side, so that they stray from neither. Returns how many
/// corners were added; a part of fewer than three is dropped.
std::size_t clip_polygon(std::span<const Point> polygon, const lod::HalfSpace<3>& side,
                         std::vector<Point>& out);

/// A bounded intersection of half-spaces. Each face is a polygon of its own, clipped by the planes
/// of all others, so that no rounding can spoil a structure between them.
class ConvexCell {
  public:
    ConvexCell() = default;  ///< empty
    explicit ConvexCell(const Box& box);

    /// What of the cell lies in the half-space too.
    void clip(const lod::HalfSpace<3>& side);

    [[nodiscard]] bool holds(const Point& p) const;
    [[nodiscard]] bool empty() const { return faces_.empty(); }
    /// Corners of all faces; a corner comes once for each face that it is of.
    [[nodiscard]] std::vector<Point> corners() const;
    [[nodiscard]] double volume() const;

  private:
    struct Face {
        lod::HalfSpace<3> side;
        std::vector<Point> corners;
    };
    [[nodiscard]] std::vector<Point> section(const lod::HalfSpace<3>& side) const;

    std::vector<Face> faces_;
    Box box_{Point::Zero(), Point::Zero()};  ///< of the first cell
};

}  // namespace lod3d
