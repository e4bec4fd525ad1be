#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lodlab/lod3d/source/file_mesh.hpp"

namespace lod3d {

// Each reader takes the bytes of a whole file and the name that refusals call it. Coordinates
// arrive as the nearest doubles. Polygons are cut into triangles; points, lines, normals, colours
// and all that bounds nothing are left out, and so are vertices that no triangle uses, whatever
// their numbers.
//
// Any bytes may come. Throws lod::Error, input refused, in one line: the file, the line or byte,
// why, and the mend; where a triangle's vertex is not finite or beyond 1e100, too. Limit exceeded
// where the triangles, the memory or the time exceed the limits, before more is taken.

/// Wavefront OBJ: v and f in all their forms, the rest is passed over.
[[nodiscard]] FileMesh read_obj(std::string_view bytes, const std::string& name,
                                const ImportLimits& limits = {});
/// STL, text or binary, told apart by what the file holds and not by its first word alone.
[[nodiscard]] FileMesh read_stl(std::string_view bytes, const std::string& name,
                                const ImportLimits& limits = {});
/// PLY, ascii or binary of either byte order: elements vertex, face and tristrips, in any order.
[[nodiscard]] FileMesh read_ply(std::string_view bytes, const std::string& name,
                                const ImportLimits& limits = {});
/// Geomview's OFF as text, with the prefixes ST, C, N and 4, in any layout of lines.
[[nodiscard]] FileMesh read_off(std::string_view bytes, const std::string& name,
                                const ImportLimits& limits = {});

}  // namespace lod3d
