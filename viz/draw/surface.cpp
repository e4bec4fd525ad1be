#include "lodlab/viz/draw/surface.hpp"

#include <algorithm>
#include <set>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/lod3d/mesh/mesh_sides.hpp"
#include "lodlab/viz/draw/corner_normals.hpp"
#include "lodlab/viz/figure/camera.hpp"

namespace viz {
namespace {

using Vector3 = lod::Vector<3>;

constexpr int extreme_directions = 7;  ///< steps along each side of a cube of directions

std::vector<Vector3> face_normals(const lod3d::Mesh& mesh) {
    std::vector<Vector3> normals;
    normals.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vector3 a = mesh.corner(t, 0);
        normals.push_back((mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a));
    }
    return normals;  // twice the area long: large faces weigh more
}

/// Where more than two triangles share an edge, two by two.
void find_edges(const lod3d::Mesh& mesh, const std::vector<Vector3>& faces, Surface& surface) {
    lod3d::each_edge(lod3d::sorted_sides(mesh), [&](auto side, auto last) {
        while (side != last) {
            Surface::Edge edge{side->low, side->high, side->triangle, -1, true};
            if (++side != last) {
                edge.right = side++->triangle;
                const Vector3& a = faces[lod::at(edge.left)];
                const Vector3& b = faces[lod::at(edge.right)];
                edge.sharp = !turn_little(a, a.norm(), b, b.norm());
            }
            surface.edges.push_back(edge);
        }
    });
}

/// The vertices that lie furthest out in directions all over a cube.
void find_outermost(const lod3d::Mesh& mesh, Surface& surface) {
    std::set<std::size_t> found;
    constexpr int steps = extreme_directions;
    for (int i = 0; i < steps * steps * steps; ++i) {
        const int x = 2 * (i % steps) - steps + 1;
        const int y = 2 * (i / steps % steps) - steps + 1;
        const int z = 2 * (i / steps / steps) - steps + 1;
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) != steps - 1) continue;
        const Vector3 direction(x, y, z);
        const auto furthest = std::max_element(mesh.vertices.begin(), mesh.vertices.end(),
                                               [&](const Vector3& a, const Vector3& b) {
                                                   return a.dot(direction) < b.dot(direction);
                                               });
        found.insert(static_cast<std::size_t>(furthest - mesh.vertices.begin()));
    }
    for (const std::size_t i : found) surface.outermost.push_back(surface.vertices[i]);
}

}  // namespace

Surface surface_of(const lod3d::Mesh& mesh) {
    Surface surface;
    surface.vertices.reserve(mesh.vertices.size());
    for (const Vector3& v : mesh.vertices) surface.vertices.push_back(point3(v));
    surface.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
    const std::vector<Vector3> faces = face_normals(mesh);
    surface.normals = corner_normals(mesh, faces).of;
    find_edges(mesh, faces, surface);
    find_outermost(mesh, surface);
    return surface;
}

}  // namespace viz
