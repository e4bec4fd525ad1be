#pragma once

/// \file
/// A part of a solid, as builders and certificates take it.

#include <cstdint>
#include <memory>
#include <utility>

#include "lodlab/core/builder/piece.hpp"
#include "lodlab/core/math/convex_cell.hpp"
#include "lodlab/core/math/sphere.hpp"
#include "lodlab/lod3d/solid/solid.hpp"

namespace lod3d {

/// The part of a solid that a node of its sphere tree owns (METHOD.md, pieces and the power
/// diagram): what of the solid lies in a convex cell. Its corners are those of the surface's
/// triangles clipped by the cell, and the cell's own corners that lie inside the solid: where an
/// edge of the cell passes through the surface, two cuts of a triangle meet. Body frame, metres.
class MeshPiece {
  public:
    MeshPiece() = default;
    /// The whole solid. `inside` must outlive every piece made from this one.
    MeshPiece(const Solid& solid, const MeshDistance& inside);

    /// What of the piece lies in every half-space.
    [[nodiscard]] MeshPiece within(std::span<const lod::HalfSpace<3>> cell) const;
    /// Their convex hull holds the piece; a shared corner comes more than once.
    [[nodiscard]] std::span<const Point> vertices() const { return points_; }
    /// Volume [m^3]: of the whole solid exactly, of a part from above.
    [[nodiscard]] double measure() const { return measure_; }
    [[nodiscard]] double surface_measure() const;  ///< area of the solid's surface in it [m^2]
    [[nodiscard]] Point surface_normal() const;    ///< integral of the unit normal over it [m^2]
    /// A part of the piece that the ball holds (all of it, where the ball holds every vertex; else
    /// what lies in the cube inside the ball), and an upper bound of the volume of the rest.
    [[nodiscard]] std::pair<MeshPiece, double> held_by(const lod::Sphere<3>& ball) const;

    /// Of the vertices those that lie outermost in some of many directions, and the normals of the
    /// surface and of the cell where they are few.
    [[nodiscard]] lod::HullHints<3> hull_hints() const;

    /// Corners of the clipped surface; the rest of the vertices lie inside the solid.
    [[nodiscard]] std::span<const Point> surface_corners() const {
        return std::span(points_).first(surface_end());
    }
    /// The convex cell that cuts the piece out of the solid.
    [[nodiscard]] const lod::ConvexCell<3>& cell() const { return cell_; }
    /// The box of all vertices. Requires: not empty.
    [[nodiscard]] Box bounds() const;
    /// Calls visit(corners) for every polygon of the surface.
    template <typename Visit>
    void each_polygon(const Visit& visit) const {
        std::size_t begin = 0;
        for (const std::int32_t end : polygon_end_) {
            const std::size_t count = static_cast<std::size_t>(end) - begin;
            visit(std::span(points_).subspan(begin, count));
            begin += count;
        }
    }

  private:
    [[nodiscard]] std::size_t surface_end() const {
        return polygon_end_.empty() ? 0 : static_cast<std::size_t>(polygon_end_.back());
    }
    void add_inner_corners();

    const MeshDistance* inside_ = nullptr;
    lod::ConvexCell<3> cell_;
    std::vector<Point> points_;  ///< corners of the surface's polygons, then the inner corners
    std::vector<std::int32_t> polygon_end_;  ///< into points_
    double measure_ = 0;
};

}  // namespace lod3d
