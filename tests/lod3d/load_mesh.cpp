#include "lodlab/lod3d/source/load_mesh.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/mesh_files.hpp"

using namespace lod3d;
using namespace lodtest;

namespace {

std::string refusal(const fs::path& path, lod::ErrorKind kind, const ImportLimits& limits = {}) {
    try {
        static_cast<void>(load_mesh(path, limits));
    } catch (const lod::Error& error) {
        CHECK(error.kind() == kind);
        CHECK(std::string(error.what()).find('\n') == std::string::npos);
        return error.what();
    }
    return "accepted";
}

const std::string tetrahedron_obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 4 3\nf 1 2 4\nf 2 3 4\n";

constexpr auto refused = lod::ErrorKind::input_refused;
constexpr auto exceeded = lod::ErrorKind::limit_exceeded;

}  // namespace

TEST_CASE("one tetrahedron comes out of every format the same", "[load]") {
    const Folder folder;
    const std::string off =
        "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 3 2\n3 0 1 3\n3 1 2 3\n";
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 3 2\n3 0 1 3\n3 1 2 3\n";
    const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                    {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
    for (const fs::path& path :
         {folder.write("t.obj", tetrahedron_obj), folder.write("t.off", off),
          folder.write("t.ply", ply), folder.write("t.stl", binary_stl(mesh, 4)),
          folder.write("T.OBJ", tetrahedron_obj)}) {
        INFO(path);
        const Solid solid = make_solid("t", load_mesh(path));
        CHECK(solid.mesh.vertices.size() == 4);
        CHECK(solid.volume == Approx(1.0 / 6).epsilon(1e-12));
        CHECK(solid.centroid.isApprox(Point::Constant(0.25), 1e-12));
    }
}

TEST_CASE("polygons are cut into triangles and lines are left out", "[load]") {
    const Folder folder;
    const Mesh mesh = load_mesh(
        folder.write("cube.obj",
                     "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                     "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nl 1 7\n"));
    CHECK(mesh.triangles.size() == 12);
    CHECK(make_solid("cube", mesh).volume == Approx(1));
}

TEST_CASE("files that are none are refused in one line", "[load]") {
    const Folder folder;
    CHECK_THAT(refusal(folder.path() / "none.obj", refused), lodtest::contains("no such file"));
    CHECK_THAT(refusal(folder.path(), refused), lodtest::contains("no regular file"));
    CHECK_THAT(refusal(folder.write("a.txt", "hello"), refused),
               lodtest::contains("obj, ply, stl"));
    for (const char* ending : {"obj", "ply", "stl", "off", "3ds", "gltf", "glb"}) {
        const std::string name = std::string("file.") + ending;
        CHECK_THAT(refusal(folder.write(name, ""), refused), lodtest::contains("is empty"));
        CHECK(refusal(folder.write(name, "rubbish\nrubbish\n"), refused) != "accepted");
        CHECK(refusal(folder.write(name, std::string(1000, '\0')), refused) != "accepted");
    }
}

TEST_CASE("a NaN vertex and a vertex number out of range are refused", "[load]") {
    const Folder folder;
    const auto solid_of = [&](const std::string& text) -> std::string {
        try {
            static_cast<void>(make_solid("it", load_mesh(folder.write("it.obj", text))));
        } catch (const lod::Error& error) {
            return error.what();
        }
        return "accepted";
    };
    CHECK(solid_of(tetrahedron_obj) == "accepted");
    CHECK(solid_of("v nan 0 0\n" + tetrahedron_obj.substr(8)) != "accepted");
    CHECK(solid_of(tetrahedron_obj + "f 1 2 9\n") != "accepted");
    CHECK(solid_of(tetrahedron_obj + "f 1 2 -9\n") != "accepted");
}

TEST_CASE("headers that promise more than the file holds are refused", "[load]") {
    const Folder folder;
    const Mesh mesh = lod::make_from_spec(generators(), "box");
    CHECK_THAT(refusal(folder.write("a.off", "OFF\n353000000000 4 6\n0 0 0\n"), refused),
               lodtest::contains("353000000000 vertices"));
    CHECK_THAT(refusal(folder.write("a.stl", binary_stl(mesh, 4000000000u)), refused),
               lodtest::contains("4000000000 triangles"));
    CHECK_THAT(refusal(folder.write("a.ply",
                                    "ply\nformat binary_little_endian 1.0\n"
                                    "element vertex 2000000000\nproperty float x\n"
                                    "end_header\n"),
                       refused),
               lodtest::contains("2000000000 of element vertex"));
    CHECK_THAT(refusal(folder.write("a.gltf", R"({"asset":{"version":"2.0"},"accessors":[
                 {"count":900000000000,"type":"VEC3","componentType":5126}]})"),
                       refused),
               lodtest::contains("900000000000 elements"));
}

TEST_CASE("a file beyond a limit is refused by that limit's name", "[load]") {
    const Folder folder;
    const fs::path path = folder.write("t.obj", tetrahedron_obj);
    CHECK_THAT(refusal(path, exceeded, {.most_bytes = 10}), lodtest::contains("limit of 10"));
    CHECK_THAT(refusal(path, exceeded, {.most_triangles = 3}), lodtest::contains("limit of 3"));
}

TEST_CASE("a file whose scene takes too much memory or time is refused", "[load]") {
    const Folder folder;
    std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 300000; ++i) faces += "f 1 2 3\n";
    const fs::path path = folder.write("faces.obj", faces);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
    CHECK_THAT(refusal(path, exceeded, {.most_memory = 4 << 20}), lodtest::contains("4 MB"));
#endif
    CHECK_THAT(refusal(path, exceeded, {.most_seconds = 0}), lodtest::contains("longer than"));
}

TEST_CASE("no file outside the folder is opened", "[load]") {
    const Folder folder;
    // A glTF file whose vertices stand in a buffer one folder up.
    std::string buffer;
    for (float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) buffer += bytes_of(value);
    const std::string gltf =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
                          "min":[0,0,0],"max":[1,1,0]}],
            "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36}],
            "buffers":[{"byteLength":36,"uri":"URI"}]})";
    const auto with = [&](const std::string& uri) {
        std::string text = gltf;
        return text.replace(text.find("URI"), 3, uri);
    };
    static_cast<void>(folder.write("in/points.bin", buffer));
    static_cast<void>(folder.write("points.bin", buffer));
    CHECK(load_mesh(folder.write("in/a.gltf", with("points.bin"))).triangles.size() == 1);
    CHECK(refusal(folder.write("in/b.gltf", with("../points.bin")), refused) != "accepted");
}

TEST_CASE("a stop signal ends the reading of a mesh", "[load]") {
    const Folder folder;
    std::string big;
    for (int i = 0; i < 200000; ++i) big += "v " + std::to_string(i) + " 1 2\n";
    for (int i = 0; i < 200000; ++i) big += "f 1 2 3\n";
    const fs::path path = folder.write("big.obj", big);
    lod::stop_requested = true;
    CHECK_THROWS_AS(static_cast<void>(load_mesh(path)), lod::Interrupted);
    lod::stop_requested = false;
}
