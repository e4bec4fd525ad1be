#pragma once

/// \file
/// Whether triangles, or two posed meshes, meet.

#include "lodlab/lod3d/mesh/triangle_tree.hpp"

namespace lod3d {

/// Whether two triangles share a point; touching counts. Degenerate triangles count as the segment
/// or point that they are. Signs are taken in double precision: within rounding of touching,
/// either answer may come.
[[nodiscard]] bool triangles_intersect(const TriangleTree::Corners& s,
                                       const TriangleTree::Corners& t);

/// A pose: body frame to world frame.
struct Pose {
    lod::Matrix<3> rotation = lod::Matrix<3>::Identity();
    Point position = Point::Zero();
    /// A point of the body frame in the world.
    [[nodiscard]] Point carry(const Point& p) const { return rotation * p + position; }
};

/// Whether the surfaces of two posed meshes share a point. One that lies wholly within the other
/// does not: ask MeshDistance::inside for that.
[[nodiscard]] bool surfaces_intersect(const TriangleTree& a, const Pose& pose_a,
                                      const TriangleTree& b, const Pose& pose_b);

/// How the closed, outward parts of one mesh stand to each other at the worst: whether they share a
/// space, or only corners, edges or faces, to a hair [m]. One that lies wholly within another is
/// apart from it.
enum class PartsMeet { apart, touching, crossing };
/// Of all pairs of parts the worst. Requires: `parts` are those of the mesh.
[[nodiscard]] PartsMeet parts_meet(const Mesh& mesh, const Parts& parts, double hair);

}  // namespace lod3d
