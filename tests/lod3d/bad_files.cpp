// Bad meshes as files, in every format that can say them: each is refused in one line, or made good
// and said so. And files of ten million triangles, of which none is read.
#include <algorithm>
#include <cstring>
#include <limits>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/lod3d/source/load_mesh.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/mesh_files.hpp"

using namespace lod3d;
using namespace lodtest;

namespace {

Mesh cube() {
    return lod::make_from_spec(generators(), "box:1,1,1");
}

/// "accepted", or the one line of the refusal.
std::string outcome(const fs::path& path, const ImportLimits& limits = {}) {
    try {
        static_cast<void>(make_solid("it", load_mesh(path, limits)));
    } catch (const lod::Error& error) {
        CHECK((error.kind() == lod::ErrorKind::input_refused ||
               error.kind() == lod::ErrorKind::limit_exceeded));
        CHECK(std::string(error.what()).find('\n') == std::string::npos);
        return error.what();
    }
    return "accepted";
}

const std::string formats[] = {"obj", "off", "ply", "stl", "gltf"};

}  // namespace

TEST_CASE("a good box is accepted in every format", "[bad_files]") {
    const Folder folder;
    for (const std::string& format : formats) {
        INFO(format);
        const Solid solid = make_solid("it", load_mesh(folder.write(format, cube())));
        CHECK(solid.volume == Approx(1).epsilon(1e-6));
        CHECK(solid.mended.empty());
    }
}

TEST_CASE("an empty file, one that is cut short and one of noise are refused", "[bad_files]") {
    const Folder folder;
    for (const std::string& format : formats) {
        INFO(format);
        const fs::path whole = folder.write(format, cube());
        const auto size = fs::file_size(whole);
        for (const double share : {0.0, 0.3, 0.6, 0.9}) {
            static_cast<void>(folder.write(format, cube()));
            fs::resize_file(whole, static_cast<std::uintmax_t>(static_cast<double>(size) * share));
            INFO("cut to " << share);
            CHECK(outcome(whole) != "accepted");
        }
        CHECK(outcome(folder.write("noise." + format, std::string(300, '\xf7'))) != "accepted");
    }
}

TEST_CASE("a vertex that is no number is refused, whatever the format", "[bad_files]") {
    const Folder folder;
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        for (const std::string& format : formats) {
            INFO(format << " with " << bad);
            Mesh mesh = cube();
            mesh.vertices[3].y() = bad;
            CHECK(outcome(folder.write(format, mesh)) != "accepted");
        }
}

TEST_CASE("a vertex number out of range is refused, whatever the format", "[bad_files]") {
    const Folder folder;
    for (const std::int32_t bad : {8, 1'000'000, -1})
        for (const std::string& format : formats) {
            if (format == "stl") continue;  // has no numbers
            INFO(format << " with " << bad);
            Mesh mesh = cube();
            mesh.triangles[2][1] = bad;
            CHECK(outcome(folder.write(format, mesh)) != "accepted");
        }
}

TEST_CASE("one triangle, and triangles without area, bound nothing", "[bad_files]") {
    const Folder folder;
    Mesh one = cube();
    one.triangles.resize(1);
    Mesh flat = cube();
    for (Point& p : flat.vertices) p.z() = 0.5;
    Mesh point = cube();
    for (Point& p : point.vertices) p = Point(1, 2, 3);
    for (const std::string& format : formats) {
        INFO(format);
        CHECK_THAT(outcome(folder.write(format, one)),
                   lodtest::contains("3 edges with one triangle only"));
        CHECK(outcome(folder.write(format, flat)) != "accepted");
        CHECK(outcome(folder.write(format, point)) != "accepted");
    }
}

TEST_CASE("triangles without area among good ones do no harm", "[bad_files]") {
    const Folder folder;
    Mesh mesh = cube();
    mesh.triangles.push_back({3, 3, 5});
    mesh.triangles.push_back({7, 7, 7});
    for (const std::string& format : formats) {
        INFO(format);
        CHECK(make_solid("it", load_mesh(folder.write(format, mesh))).volume == Approx(1));
    }
}

TEST_CASE("two closed parts are one solid, and inside-out ones are turned", "[bad_files]") {
    const Folder folder;
    Mesh two = cube();
    const Mesh other = cube();
    for (const Point& p : other.vertices) two.vertices.push_back(0.5 * p + Point(2, 0, 0));
    for (const Triangle& t : other.triangles)
        two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    for (const std::string& format : formats) {
        INFO(format);
        const Solid solid = make_solid("it", load_mesh(folder.write(format, two)));
        CHECK(solid.volume == Approx(1.125));
        CHECK(solid.mended.empty());
        Mesh turned = two;
        flip(turned);
        const Solid mended = make_solid("it", load_mesh(folder.write(format, turned)));
        CHECK(mended.volume == Approx(1.125));
        REQUIRE(mended.mended.size() == 1);
        CHECK_THAT(mended.mended[0], lodtest::contains("inside-out"));
    }
}

TEST_CASE("ten million triangles are refused before they are read, in every format that counts",
          "[bad_files]") {
    // Holes take no room on the disk.
    const Folder folder;
    const auto refused = [&](const std::string& name, const std::string& head, std::size_t size) {
        const fs::path path = folder.write(name, head);
        fs::resize_file(path, size);
        INFO(name);
        CHECK_THAT(outcome(path), lodtest::contains("10000000 triangles, more than the limit"));
    };
    const std::string count("\x80\x96\x98\x00", 4);
    refused("a.stl", std::string(80, ' ') + count, 84 + 50 * 10'000'000ull);
    refused("a.ply",
            "ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty float x\n"
            "property float y\nproperty float z\nelement face 10000000\n"
            "property list uchar int vertex_indices\nend_header\n",
            130'000'200);
    refused("a.off", "OFF\n8 10000000 0\n0 0 0\n", 60'000'000);
    const fs::path buffer = folder.write("a.bin", std::string());
    fs::resize_file(buffer, 120'000'096);
    const std::string accessors =
        R"("accessors":[{"count":8,"type":"VEC3","componentType":5126},
                        {"count":30000000,"type":"SCALAR","componentType":5125}],
           "buffers":[{"byteLength":120000096,"uri":"a.bin"}],
           "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])";
    const std::string gltf = R"({"asset":{"version":"2.0"},)" + accessors + "}";
    refused("a.gltf", gltf, gltf.size());
}

TEST_CASE("a small mesh that a scene shows ten million times counts as so many triangles",
          "[bad_files]") {
    const Folder folder;
    const std::string gltf =
        R"({"asset":{"version":"2.0"},"accessors":[{"count":300,"type":"VEC3"}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
            "nodes":[{"mesh":0},{"mesh":0},{"mesh":0},{"name":"none"},{"mesh":7}],
            "filler":")" +
        std::string(400, '.') + "\"}";
    const fs::path path = folder.write("many.gltf", gltf);
    CHECK_THAT(outcome(path, {.most_triangles = 299}),
               lodtest::contains("300 triangles, more than"));
    CHECK_THAT(outcome(path, {.most_triangles = 300}), !lodtest::contains("more than"));
}

TEST_CASE("a glTF file whose numbers and lists are of another kind is refused", "[bad_files]") {
    const Folder folder;
    for (const char* text :
         {R"({"accessors":7})", R"({"meshes":{"a":[1]},"nodes":[{"mesh":"x"}]})",
          R"({"accessors":[{"count":"many"}],"meshes":[{"primitives":[{"indices":-1}]}]})",
          R"({"buffers":[{"uri":5},3],"nodes":[null],"meshes":[[]]})", "[]", "{"}) {
        INFO(text);
        CHECK(outcome(folder.write("odd.gltf", text)) != "accepted");
    }
}

TEST_CASE("a glTF file that requires an extension not read is refused by its name", "[bad_files]") {
    const Folder folder;
    const std::string good = gltf(cube());
    const auto with = [&](const std::string& more) {
        return outcome(folder.write("more.gltf", "{" + more + "," + good.substr(1)));
    };
    CHECK(with(R"("extensionsRequired":["KHR_materials_unlit","KHR_texture_transform"])") ==
          "accepted");
    for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                             "KHR_mesh_quantization", "EXT_mesh_gpu_instancing"}) {
        const std::string line = with("\"extensionsRequired\":[\"" + std::string(name) + "\"]");
        CHECK_THAT(line, lodtest::contains("more.gltf: requires the extension") &&
                             lodtest::contains(name));
    }
    CHECK(with(R"("extensionsRequired":[7,null])") == "accepted");
    std::string bytes = good;
    bytes.replace(bytes.find("5126"), 4, "5122");
    CHECK_THAT(outcome(folder.write("short.gltf", bytes)),
               lodtest::contains("KHR_mesh_quantization"));
}

TEST_CASE("a vertex index beyond those of a glTF mesh is named, also in a file of its own",
          "[bad_files]") {
    const Folder folder;
    Mesh astray = cube();
    astray.triangles.back()[1] = 8;
    const std::string text = gltf(astray);
    const std::string names = "a face of mesh 0 names the vertex index 8, but there are 8 vertices";
    CHECK_THAT(outcome(folder.write("astray.gltf", text)), lodtest::contains(names));

    std::string bytes;
    for (const Point& p : astray.vertices)
        for (int d = 0; d < 3; ++d) bytes += bytes_of(static_cast<float>(p[d]));
    for (const Triangle& t : astray.triangles)
        for (const std::int32_t v : t) bytes += bytes_of(static_cast<std::uint32_t>(v));
    const std::size_t uri = text.find(",\"uri\"");
    static_cast<void>(folder.write("astray.bin", bytes));
    CHECK_THAT(
        outcome(folder.write("astray.gltf", text.substr(0, uri) + ",\"uri\":\"astray.bin\"}]}")),
        lodtest::contains(names));
    std::string json = text.substr(0, uri) + "}]}";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto length = [](std::size_t count) {
        return bytes_of(static_cast<std::uint32_t>(count));
    };
    CHECK_THAT(outcome(folder.write("astray.glb",
                                    "glTF" + length(2) + length(28 + json.size() + bytes.size()) +
                                        length(json.size()) + "JSON" + json + length(bytes.size()) +
                                        std::string("BIN\0", 4) + bytes)),
               lodtest::contains(names));
    CHECK(outcome(folder.write("good.gltf", gltf(cube()))) == "accepted");
}

TEST_CASE("a part that a glTF scene places far away keeps its digits", "[bad_files]") {
    const Folder folder;
    std::string text = gltf(cube());
    const std::string node = R"("nodes":[{"mesh":0)";
    text.replace(text.find(node), node.size(), node + R"(,"translation":[1000000,-2000000,0.5])");
    const Solid solid = make_solid("it", load_mesh(folder.write("placed.gltf", text)));
    CHECK(solid.volume == Approx(1).epsilon(1e-9));
    CHECK(solid.centroid.isApprox(Point(1e6, -2e6, 0.5), 1e-15));
}
