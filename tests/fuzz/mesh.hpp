#pragma once

#include "lodlab/lod3d/solid/solid.hpp"
#include "lodlab/lod3d/source/mesh_readers.hpp"
#include "tests/fuzz/fuzz.hpp"

/// Reads a mesh and, where it is small, makes it a solid.
template <class Reader>
int try_mesh(const std::uint8_t* bytes, std::size_t size, const Reader& reader) {
    return try_reading(bytes, size, [&](std::string_view text) {
        lod3d::FileMesh read = reader(text, "mesh", {});
        lod3d::check_numbers(read.mesh);
        if (read.mesh.triangles.size() > 200) return;
        lod3d::SolidOptions options;
        options.fill_cells = 8;
        const lod3d::Solid solid = lod3d::make_solid("mesh", std::move(read.mesh), options);
        if (!(solid.volume > 0)) std::abort();
    });
}
