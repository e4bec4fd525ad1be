#pragma once

/// \file
/// A mesh of triangles, and what is asked of its numbers and edges.

#include <array>
#include <cstdint>
#include <vector>

#include "lodlab/core/math/box.hpp"

namespace lod3d {

/// A point of space [m].
using Point = lod::Vector<3>;
using Triangle = std::array<std::int32_t, 3>;  ///< indices; anticlockwise seen from outside

/// Triangles in space that share vertices. Metres.
struct Mesh {
    std::vector<Point> vertices;
    std::vector<Triangle> triangles;

    /// A corner of a triangle; `which`: 0 to 2.
    [[nodiscard]] const Point& corner(std::size_t triangle, int which) const {
        return vertices[static_cast<std::size_t>(
            triangles[triangle][static_cast<std::size_t>(which)])];
    }
};

/// A box of space [m].
using Box = lod::Box<3>;

/// Whether a point's coordinates are finite and within 1e100.
[[nodiscard]] bool is_usable(const Point& p);

/// The box of all vertices. Requires: at least one vertex.
[[nodiscard]] Box bounding_box(const Mesh& mesh);

/// Throws lod::Error (input refused) that says how many vertices are not finite or beyond 1e100 and
/// which is the first, and how many indices point nowhere; or that there are no triangles. Vertices
/// that no triangle uses may hold anything.
void check_numbers(const Mesh& mesh);

/// Drops the vertices that no triangle uses; the others keep their order. Returns how many went.
/// Requires: indices within range.
int drop_unused_vertices(Mesh& mesh);

/// What weld() took away.
struct Welded {
    int vertices = 0;    ///< merged into another one, or used by no triangle
    int collapsed = 0;   ///< triangles with two equal corners
    int duplicates = 0;  ///< triangles that were there already, turned the same way
};

/// Merges vertices no further apart than the tolerance [m] on any axis (0: equal coordinates only)
/// and drops the triangles that this collapses, repeated triangles and unused vertices.
/// A closed mesh stays closed. Requires: check_numbers passed.
Welded weld(Mesh& mesh, double tolerance = 0);

/// Edges that keep a mesh from bounding a solid. All zero: closed, manifold and oriented.
struct BadEdges {
    int open = 0;      ///< one triangle only
    int crowded = 0;   ///< more triangles than can be matched two by two: odd, or turned alike
    int reversed = 0;  ///< two triangles that pass it in the same direction
    int shared = 0;  ///< no fault: four triangles or more that can be matched, of parts that touch
    std::array<std::int32_t, 2> first{};  ///< the vertices of one of them
    /// Whether the mesh is closed, manifold and oriented.
    [[nodiscard]] bool none() const { return open == 0 && crowded == 0 && reversed == 0; }
};
/// Counts them.
[[nodiscard]] BadEdges find_bad_edges(const Mesh& mesh);

/// Turns triangles until neighbours agree, each connected part by the majority of its own. Returns
/// how many were turned. What can't agree (a one-sided surface) shows up in find_bad_edges.
int orient(Mesh& mesh);

/// For each triangle the number of its part; triangles that share an edge are of one part.
struct Parts {
    std::vector<std::int32_t> of_triangle;
    int count = 0;
};
/// Numbers the parts of a mesh.
[[nodiscard]] Parts find_parts(const Mesh& mesh);
/// Each part as a mesh of its own, its vertices in the order in which its triangles name them.
[[nodiscard]] std::vector<Mesh> split(const Mesh& mesh, const Parts& parts);

/// Exact integrals over what a closed mesh bounds, each point counted by its winding number.
struct Integrals {
    double volume = 0;               ///< [m^3]; negative where the mesh is inside-out
    Point centroid = Point::Zero();  ///< [m]; zero where there is no volume
    lod::Inertia<3> inertia = lod::Inertia<3>::Zero();  ///< about the centroid [m^5]; times density
};
/// Requires: a closed mesh.
[[nodiscard]] Integrals integrate(const Mesh& mesh);

/// Turns every triangle over.
void flip(Mesh& mesh);

}  // namespace lod3d
