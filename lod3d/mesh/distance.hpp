#pragma once

/// \file
/// Distances from a mesh, and whether a point is inside.

#include <cstdint>
#include <limits>
#include <vector>

#include "lodlab/lod3d/mesh/wide_tree.hpp"

namespace lod3d {

/// The point of a surface nearest to another point.
struct Nearest {
    Point point = Point::Zero();
    double distance =
        std::numeric_limits<double>::infinity();  ///< [m]; infinite: none within reach
    std::int32_t triangle = -1;                   ///< the mesh's number
    /// Outward, angle-weighted over the triangles that meet at the point (not of unit length): a
    /// point is outside exactly if it lies on its side (Baerentzen and Aanaes 2005).
    Point normal = Point::Zero();
};

/// The point of a triangle that is nearest to p.
[[nodiscard]] Point nearest_on_triangle(const TriangleTree::Corners& t, const Point& p);

/// How a point is told to be inside.
enum class InsideRule {
    nearest_normal,  ///< by the side of the nearest surface: quick; for parts that do not overlap
    winding,         ///< by a winding number above 1/2: for overlapping parts and open surfaces
};

/// Distances from a mesh. Several threads may ask one at once.
class MeshDistance {
  public:
    /// Requires: numbers checked; for nearest_normal a closed, oriented mesh.
    explicit MeshDistance(const Mesh& mesh, InsideRule rule = InsideRule::nearest_normal);

    /// The nearest point of the surface, if one lies closer than `within` [m].
    [[nodiscard]] Nearest nearest(const Point& p,
                                  double within = std::numeric_limits<double>::infinity()) const;

    /// Whether the solid holds a point.
    [[nodiscard]] bool inside(const Point& p) const { return is_inside(p, nearest(p)); }
    /// The same, where the nearest point is known.
    [[nodiscard]] bool is_inside(const Point& p, const Nearest& at) const {
        return rule_ == InsideRule::winding ? winding_number(p) > 0.5
                                            : (p - at.point).dot(at.normal) < 0;
    }

    /// Distance from the surface, negative inside [m].
    [[nodiscard]] double signed_distance(const Point& p) const;

    /// The same where it is less than the limit; else infinity. Ends at the first triangle that
    /// shows the latter, so that to refuse a point costs little.
    [[nodiscard]] double signed_distance_below(const Point& p, double limit) const;

    /// Distance from the solid, 0 inside [m].
    [[nodiscard]] double distance(const Point& p) const {
        return (std::max)(signed_distance(p), 0.0);
    }
    /// The same where it is more than the floor; else 0. Ends at the first triangle that shows the
    /// latter.
    [[nodiscard]] double distance_above(const Point& p, double floor) const;

    /// How often the surface winds around a point: a whole number off a closed surface. Far groups
    /// of triangles count as dipoles (Barill et al. 2018), which errs by less than 0.1.
    [[nodiscard]] double winding_number(const Point& p) const;

    /// The triangles that queries walk.
    [[nodiscard]] const TriangleTree& tree() const { return tree_; }

  private:
    struct Dipole {
        Point centre = Point::Zero();       ///< weighted by area
        Point area_normal = Point::Zero();  ///< sum over the triangles
        double radius = 0;                  ///< of the ball at centre that holds them all
        double area = 0;
    };
    /// Pseudonormals of one triangle: face; sides ab, bc, ca; corners a, b, c.
    struct Normals {
        std::array<Point, 7> of;
    };

    /// A point of the surface on the way to the nearest one.
    struct Found {
        Point point = Point::Zero();
        double squared = 0;        ///< distance [m^2]
        std::int32_t number = -1;  ///< of the triangle, in the order of the leaves
        std::size_t feature = 0;   ///< into Normals::of
    };
    /// The nearest point of the surface closer than `within` [m], or the first one met whose
    /// squared distance is at most `enough` [m^2].
    [[nodiscard]] Found find(const Point& p, double within, double enough) const;
    [[nodiscard]] Nearest result_of(const Found& found) const;

    void find_normals(const Mesh& mesh);
    void find_dipoles();

    TriangleTree tree_;
    WideTree wide_;
    InsideRule rule_;
    std::vector<Normals> normals_;  ///< in the order of the leaves; empty for the winding rule
    std::vector<Dipole> dipoles_;   ///< of each node
};

}  // namespace lod3d
