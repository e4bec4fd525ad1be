// PLY files, and the solids that they bound.
#include "tests/fuzz/mesh.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return try_mesh(bytes, size, lod3d::read_ply);
}
