#include "lodlab/viz/draw/corner_normals.hpp"

#include <cmath>
#include <numbers>

#include "lodlab/viz/figure/camera.hpp"
#include "tests/catch.hpp"

using namespace viz;

namespace {

using Vector3 = lod::Vector<3>;

/// The sides of a cone without its base, each from the tip, which comes first.
lod3d::Mesh cone(int sides, double height) {
    lod3d::Mesh mesh;
    mesh.vertices.emplace_back(0, height, 0);
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        mesh.vertices.emplace_back(std::cos(angle), 0, -std::sin(angle));
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % sides});
    }
    return mesh;
}

std::vector<Vector3> normals_of(const lod3d::Mesh& mesh) {
    std::vector<Vector3> normals;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vector3 a = mesh.corner(t, 0);
        normals.push_back((mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a));
    }
    return normals;
}

CornerNormals shaded(const lod3d::Mesh& mesh) {
    return corner_normals(mesh, normals_of(mesh));
}

}  // namespace

TEST_CASE("a flat fan has one normal at every corner, however many triangles it has", "[surface]") {
    for (const int sides : {5, 128, 129, 1000})
        for (const auto& corners : shaded(cone(sides, 0)).of)
            for (const Point3& normal : corners)
                CHECK((vector3(normal) - Vector3::UnitY()).norm() < 1e-12);
}

TEST_CASE("four sharp sides keep their own normals", "[surface]") {
    const lod3d::Mesh pyramid = cone(4, 1);
    const std::vector<Vector3> faces = normals_of(pyramid);
    const CornerNormals shading = shaded(pyramid);
    for (std::size_t t = 0; t < 4; ++t)
        for (const Point3& normal : shading.of[t])
            CHECK((vector3(normal) - faces[t].normalized()).norm() < 1e-12);
}

TEST_CASE(
    "the tip of a cone looks to the side of each face, and taking faces together changes little",
    "[surface]") {
    for (const double height : {0.3, 1.0, 4.0}) {
        const Vector3 exact = vector3(shaded(cone(128, height)).of[0][0]);
        for (const int sides : {129, 500, 5000}) {
            const lod3d::Mesh mesh = cone(sides, height);
            const CornerNormals shading = shaded(mesh);
            CHECK((vector3(shading.of[0][0]) - exact).norm() < std::sin(0.1));  // six degrees
            CHECK(vector3(shading.of[0][0]).norm() == Approx(1));
        }
    }
}

TEST_CASE("the normals at a hub cost what its triangles are, not their square", "[surface]") {
    for (const double height : {0.0, 1.0, 100.0})
        for (const std::uint64_t sides : {1000, 2000, 4000}) {
            const std::uint64_t others = 4 * sides;  // round the base two meet at each vertex
            CHECK(shaded(cone(static_cast<int>(sides), height)).compared <= others + 384 * sides);
        }
    CHECK(shaded(cone(128, 1)).compared == 4 * 128 + 128 * 128);  // few: each with each
}
