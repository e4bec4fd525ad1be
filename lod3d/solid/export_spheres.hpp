#pragma once

#include <string>

#include "lodlab/core/tree/tree.hpp"
#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lod3d {

// Sphere trees for other programs. All numbers are in the mesh's own frame: the body frame moved by
// the solid's centroid. They read back to the same bits.

/// The .sph text of the Sphere-Tree Construction Toolkit (Bradshaw and O'Sullivan 2004): a line
/// "LEVELS BRANCHING", then level by level "x y z r 1" for every node of the complete tree; nodes
/// that there are not have the radius 0. Throws lod::Error (limit exceeded) where the complete tree
/// would have more than 4 million nodes.
[[nodiscard]] std::string spheres_to_sph(const lod::SphereTree<3>& tree, const Point& centroid);

/// {"frame": "mesh", "levels": [{"level", "spheres": [{"centre": [x, y, z], "radius"}]}]}; a level
/// lists its nodes and the leaves above it.
[[nodiscard]] std::string spheres_to_json(const lod::SphereTree<3>& tree, const Point& centroid);

/// One link whose collision geometry is the spheres of a level, as robot planners read it.
[[nodiscard]] std::string spheres_to_urdf(const lod::SphereTree<3>& tree, const Point& centroid,
                                          int level, const std::string& name);

}  // namespace lod3d
