#pragma once

#include <string>

#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lod3d {

// What is wrong with a mesh, in words for its refusal. `moved` is what was taken off its vertices:
// places are told in the frame of the file.

/// A number in so many significant digits, at most 20.
[[nodiscard]] std::string in_digits(double value, int digits);

/// "(1, 2.5, 3)"
[[nodiscard]] std::string place_in_words(const Point& p);

/// How many bad edges of each kind there are, and where the first is.
[[nodiscard]] std::string describe(const BadEdges& bad, const Mesh& mesh, const Point& moved);

/// Whether all of a mesh lies in one plane, to 1e-9 of its size.
[[nodiscard]] bool is_flat(const Mesh& mesh);

/// Whether a closed mesh, turned either way, bounds more volume than rounding leaves where what
/// some faces enclose others take away. Requires: at least one triangle.
[[nodiscard]] bool bounds_volume(const Mesh& mesh);

/// Why a closed mesh bounds no volume: it is flat, or its surface crosses or doubles itself.
[[nodiscard]] std::string why_no_volume(const Mesh& mesh, const Point& moved,
                                        const std::string& what = "the mesh");

/// Of the parts whose triangles are all there twice, turned both ways, as in a double-sided mesh,
/// drops one of each two: the later one. Only where the others close, or all of the mesh is so.
/// Returns how many were dropped.
int drop_other_sides(Mesh& mesh);

/// Drops triangles that lie back to back, unless all do: walls within a solid, where two parts
/// share a face. What was closed stays closed. Returns how many were dropped.
int drop_inner_walls(Mesh& mesh);

/// "1 edge", "2 edges"
[[nodiscard]] std::string counted(long count, const std::string& what);

}  // namespace lod3d
