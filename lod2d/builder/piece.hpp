#pragma once

/// \file
/// A part of a shape of the plane, as builders and certificates take it.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "lodlab/core/builder/piece.hpp"
#include "lodlab/core/math/sphere.hpp"
#include "lodlab/lod2d/shape/convex_parts.hpp"

namespace lod2d {

/// A straight bit of a polygon's border.
struct BorderSegment {
    Point from = {0, 0};
    Point to = {0, 0};
    Point normal = {0, 0};  ///< unit, outward
    std::int32_t edge = 0;  ///< of the polygon, counted over its rings in order
};

/// The part of a shape that a node of its circle tree owns (core/builder/grow.hpp): convex
/// polygons, and the shape's border among them. Body frame, metres.
class PolygonPiece {
  public:
    PolygonPiece() = default;
    /// The whole polygon. Requires what lod2d/shape/shape.hpp says of polygons.
    explicit PolygonPiece(const Polygon& polygon);

    /// What of the piece lies in every half-plane.
    [[nodiscard]] PolygonPiece within(std::span<const lod::HalfSpace<2>> cell) const;
    /// The corners of the convex parts; a shared corner comes more than once.
    [[nodiscard]] std::span<const Point> vertices() const { return parts_.corners; }
    [[nodiscard]] double measure() const;          ///< area [m^2]
    [[nodiscard]] double surface_measure() const;  ///< length of the shape's border in it [m]
    [[nodiscard]] Point surface_normal() const;    ///< integral of the unit normal over it [m]
    /// The parts of the piece that the disc holds, cut small where it holds some of a part, and an
    /// upper bound of the area of the rest (0 where the disc holds every vertex).
    [[nodiscard]] std::pair<PolygonPiece, double> held_by(const lod::Sphere<2>& disc) const;

    /// The corners and side normals of the piece's convex hull.
    [[nodiscard]] lod::HullHints<2> hull_hints() const;

    /// The convex polygons.
    [[nodiscard]] const ConvexParts& parts() const { return parts_; }
    /// The shape's border in the piece.
    [[nodiscard]] std::span<const BorderSegment> border() const { return border_; }

  private:
    ConvexParts parts_;
    std::vector<BorderSegment> border_;
};

/// Area of a ring, positive anticlockwise [m^2].
[[nodiscard]] double ring_area(std::span<const Point> ring);

}  // namespace lod2d
