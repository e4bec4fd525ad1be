#pragma once

/// \file
/// The triangles of a mesh file: OBJ, PLY, STL, OFF, 3DS, glTF.

#include <filesystem>
#include <string>

#include "lodlab/lod3d/source/file_mesh.hpp"

namespace lod3d {

/// Reads all triangles of an OBJ, PLY, STL, OFF, 3DS or glTF file, polygons cut into triangles,
/// placed as the file's scene places them. Not welded or checked for more than numbers: that is
/// make_solid's. The format is the one that the ending names.
///
/// OBJ, PLY, STL and OFF arrive in double, as they are written. 3DS and glTF come through assimp in
/// 32-bit numbers (import_scene.hpp), and a remark says so; so does one where a mesh stands so far
/// from the origin that its numbers hold fewer digits of it than they could.
///
/// `name`: what refusals call the file; the path where it is empty.
/// Throws lod::Error: input refused (missing, unreadable, unknown format, broken, no triangles),
/// limit exceeded.
[[nodiscard]] FileMesh read_mesh(const std::filesystem::path& path, const ImportLimits& limits = {},
                                 const std::string& name = "");

/// The mesh alone.
[[nodiscard]] Mesh load_mesh(const std::filesystem::path& path, const ImportLimits& limits = {});

}  // namespace lod3d
