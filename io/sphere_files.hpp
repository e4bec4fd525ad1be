#pragma once

/// \file
/// Sphere trees for other programs: .spheres.json, .sph, .urdf.

#include <span>
#include <string>
#include <string_view>

#include "lodlab/core/tree/tree.hpp"

namespace io {

/// A sphere tree for other programs.
struct SphereExport {
    const lod::SphereTree<3>& tree;
    lod::Vector<3> centroid;  ///< of the solid, in the frame of its mesh: the body frame's origin
    int level = 0;            ///< for files that hold one level only
    std::string name;         ///< of the solid
};

/// A format of files of spheres. All numbers in them are in the mesh's own frame and read back to
/// the same bits.
struct SphereFormat {
    std::string_view ending;  ///< ".sph"
    bool one_level = false;
    std::string (*text)(const SphereExport&);
};

/// All of them, the one with the longest ending first.
///
/// .spheres.json: {"frame": "mesh", "levels": [{"level", "spheres": [{"centre": [x, y, z],
/// "radius"}]}]}; a level lists its nodes and the leaves above it.
///
/// .sph, of the Sphere-Tree Construction Toolkit (Bradshaw and O'Sullivan 2004): a line
/// "LEVELS BRANCHING", then level by level "x y z r 1" for every node of the complete tree; nodes
/// that there are not have the radius 0. Throws lod::Error (limit exceeded) where the complete tree
/// would have more than 4 million nodes.
///
/// .urdf: one link whose collision geometry is the spheres of a level, as robot planners read it.
[[nodiscard]] std::span<const SphereFormat> sphere_formats();

/// The one that a path's ending names, or null.
[[nodiscard]] const SphereFormat* sphere_format_of(std::string_view path);

}  // namespace io
