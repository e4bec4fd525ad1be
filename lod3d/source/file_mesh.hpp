#pragma once

/// \file
/// What a mesh file holds before a solid is made of it, what reading it may cost, and which formats
/// are read.

#include <cstdint>
#include <string>
#include <vector>

#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lod3d {

/// A mesh as its file holds it, in the file's frame.
struct FileMesh {
    Mesh mesh;  ///< its vertices are those that triangles use, in that order
    /// Between coordinates next to each other as its numbers can be, at the largest of them [m];
    /// of a text: as its digits can be, where they are few for the mesh.
    double step = 0;
    std::vector<std::string> remarks;  ///< what was taken otherwise than the file says
};

/// The step between numbers of so many significant bits at the largest coordinate [m].
/// Requires: at least one vertex, numbers checked.
[[nodiscard]] double coordinate_step(const Mesh& mesh, int significant_bits);

/// What reading a mesh may cost. Every limit is named in the error that it causes.
struct ImportLimits {
    std::uint64_t most_bytes = 512u << 20;  ///< of the file
    std::uint64_t most_triangles = 4'000'000;
    std::uint64_t most_memory = 2048ull << 20;  ///< of the reader [bytes]
    double most_seconds = 60;                   ///< of the reader; 0 accepts no file
};

/// The formats that are read, by the ending in lower case: obj ply stl off 3ds gltf glb.
[[nodiscard]] bool is_mesh_format(const std::string& ending);

}  // namespace lod3d
