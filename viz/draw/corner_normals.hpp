#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/lod3d/mesh/mesh.hpp"
#include "lodlab/viz/figure/figure.hpp"

namespace viz {

/// The cosine of 40 degrees: faces that turn more against each other meet in a sharp edge. What has
/// nine sides or more all round is drawn round.
inline constexpr double smooth_cosine = 0.766;

/// Whether the directions of two vectors, whose lengths are given, differ by less than that; a
/// vector of no length has every direction.
[[nodiscard]] inline bool turn_little(const lod::Vector<3>& a, double length_a,
                                      const lod::Vector<3>& b, double length_b) {
    return a.dot(b) >= smooth_cosine * length_a * length_b;
}

/// What a surface is shaded with.
struct CornerNormals {
    std::vector<std::array<Point3, 3>> of;  ///< of each triangle's corners, unit
    std::uint64_t compared = 0;             ///< pairs of directions, in all
};

/// For each corner of a triangle the mean normal of those faces round its vertex that turn little
/// against its own, larger faces weighing more. Where more than 128 meet at a vertex, they are
/// taken together by direction, some 14 degrees each way, so that no vertex costs its square.
/// `faces`: the triangles' normals, as long as their areas, in any unit.
[[nodiscard]] CornerNormals corner_normals(const lod3d::Mesh& mesh,
                                           std::span<const lod::Vector<3>> faces);

}  // namespace viz
