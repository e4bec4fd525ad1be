#pragma once

#include <cstdint>
#include <string>

namespace lod3d {

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
