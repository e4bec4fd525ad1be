#pragma once

#include <filesystem>

#include "lodlab/lod3d/import_limits.hpp"
#include "lodlab/lod3d/mesh.hpp"

namespace lod3d {

/// Reads all triangles of an OBJ, PLY, STL, OFF, 3DS or glTF file, polygons cut into triangles,
/// placed as the file's scene places them. Not welded or checked: that is make_solid's.
///
/// The importer (assimp) runs in a child process under limits of memory and time, and hands the
/// triangles back through a pipe: a file that hangs it, crashes it or blows it up costs a refusal.
/// It opens no file outside the folder of the one that is named.
///
/// Throws lod::Error: input refused (missing, unreadable, unknown format, broken, no triangles),
/// limit exceeded.
[[nodiscard]] Mesh load_mesh(const std::filesystem::path& path, const ImportLimits& limits = {});

}  // namespace lod3d
