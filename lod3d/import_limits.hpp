#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace lod3d {

/// What reading a mesh may cost. Every limit is named in the error that it causes.
struct ImportLimits {
    std::uint64_t most_bytes = 512u << 20;  ///< of the file
    std::uint64_t most_triangles = 4'000'000;
    std::uint64_t most_memory = 2048ull << 20;  ///< of the importer [bytes]
    double most_seconds = 60;                   ///< of the importer; 0 accepts no file
};

/// The formats that are read, by the ending in lower case: obj ply stl off 3ds gltf glb.
[[nodiscard]] bool is_mesh_format(const std::string& ending);

/// Checks what a file's header promises against the file's size, before any memory is taken.
/// Throws lod::Error: input refused where it promises more than it holds, or is no regular file;
/// limit exceeded where it is larger than the limits, or promises more triangles.
void check_declared_counts(const std::filesystem::path& path, const ImportLimits& limits);

}  // namespace lod3d
