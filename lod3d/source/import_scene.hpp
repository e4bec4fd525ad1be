#pragma once

#include <filesystem>
#include <string>

#include "lodlab/lod3d/source/mesh_readers.hpp"

namespace lod3d {

/// A scene file and what refusals call it.
struct SceneFile {
    std::filesystem::path path;
    std::string name;
    std::string ending;  ///< 3ds, gltf or glb
};

/// Reads all triangles of a 3DS or glTF file, placed as its scene places them, by assimp, whose
/// coordinates are 32-bit numbers. What places them is composed in double.
///
/// The importer runs in a child process under limits of memory and time, and hands the triangles
/// back through a pipe: a file that hangs it, crashes it or blows it up costs a refusal. It opens
/// no file outside the folder of the one that is named.
///
/// Throws lod::Error as load_mesh does. Requires: a regular file.
[[nodiscard]] FileMesh import_scene(const SceneFile& file, const ImportLimits& limits);

/// Checks a glTF file before any memory is taken: what its header promises against the size of its
/// buffers, its extensions against those that are understood.
/// Throws lod::Error: input refused, where it names what it needs; limit exceeded.
void check_gltf(const SceneFile& file, const ImportLimits& limits);

}  // namespace lod3d
