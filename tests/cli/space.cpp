// The program in space: the same commands, keys and refusals as in the plane.

#include <filesystem>
#include <fstream>

#include "lodlab/io/files/read_file.hpp"
#include "tests/catch.hpp"
#include "tests/cli/keys.hpp"

namespace {

std::string text_of(const std::string& path) {
    return lod::read_text_file(path, 10'000'000);
}

/// A tetrahedron whose legs along the axes are 2 m long, its corner in the origin.
constexpr const char* corner =
    "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
/// The same without its last face.
constexpr const char* open_corner =
    "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";

}  // namespace

TEST_CASE("a mesh file's tree is measured with exact integrals") {
    const Scratch scratch;
    const std::string file = scratch.write("corner.obj", corner);
    const Json json = result({"tree", file, "--builder", "octree", "--depth", "1", "--json"});
    CHECK(json["dim"] == 3);
    // Legs of length a: volume a^3 / 6, centre a / 4 on each axis, I_xx = a^5 / 80 about the
    // centre.
    CHECK(json["shape"]["measure"] == Approx(8.0 / 6));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        CHECK(json["shape"]["centroid"][axis] == Approx(0.5));
        CHECK(json["shape"]["inertia"][axis][axis] == Approx(32.0 / 80));
    }
    CHECK(json["shape"]["inertia"][0][1] == json["shape"]["inertia"][1][0]);
    CHECK(json["shape"]["approximate"] == false);
    CHECK(json["builder"] == "octree");
    REQUIRE(json["levels"].size() == 2);
    CHECK(json["levels"][1]["certified"] == true);
    CHECK(json["levels"][1]["worst_protrusion"] < json["levels"][0]["worst_protrusion"]);
}

TEST_CASE("what is asked of a tree in space is what comes") {
    const auto nodes = [](std::vector<std::string> more) {
        std::vector<std::string> all{"tree", "ball:1", "--builder", "octree", "--json"};
        all.insert(all.end(), more.begin(), more.end());
        const Json json = result(all);
        std::vector<int> counts;
        for (const Json& level : json["levels"]) counts.push_back(level["nodes"]);
        return counts;
    };
    CHECK(nodes({"--depth", "2"}).size() == 3);
    CHECK(nodes({"--nodes", "9"}) == std::vector<int>{1, 8});
    CHECK(nodes({"--nodes", "8"}) == std::vector<int>{1});
    const Json coarse = result(
        {"tree", "tetrahedron", "--effort", "0.02", "--depth", "2", "--error", "0.2", "--json"});
    const Json fine = result({"tree", "tetrahedron", "--effort", "0.02", "--depth", "2", "--json"});
    const auto last = [](const Json& json) { return json["levels"].back()["nodes"].get<int>(); };
    CHECK(last(coarse) < last(fine));
    CHECK(coarse["levels"].back()["worst_protrusion_fraction"] < 0.2);
    CHECK(result({"tree", "box:2,1,4", "--dim", "3", "--size", "8", "--depth", "0",
                  "--json"})["shape"]["measure"] == Approx(64));
}

TEST_CASE("an open mesh is refused, or filled and marked as approximate") {
    const Scratch scratch;
    const std::string file = scratch.write("open.obj", open_corner);
    const std::vector<std::string> command{"tree",    file, "--builder", "octree",
                                           "--depth", "1",  "--json"};
    check_failure(lodlab(command), 3,
                  "open.obj: the mesh does not bound a solid: 3 edges with one triangle only, the "
                  "first from ");
    auto filled = command;
    filled.emplace_back("--fill");
    const Outcome outcome = lodlab(filled);
    REQUIRE(outcome.code == 0);
    CHECK(contains(outcome.err, "filled by winding number"));
    const Json json = Json::parse(outcome.out);
    CHECK(json["shape"]["approximate"] == true);
    CHECK_FALSE(json["shape"]["remarks"].empty());
}

TEST_CASE("sphere trees go to other programs by the ending of the file") {
    const Scratch scratch;
    const std::string file = scratch.write("corner.obj", corner);
    const Outcome outcome =
        lodlab({"tree", file, "--builder", "octree", "--depth", "2", "--level", "1", "--out",
                scratch / "t.json", "--out", scratch / "t.spheres.json", "--out", scratch / "t.sph",
                "--out", scratch / "t.urdf"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const Json tree = Json::parse(text_of(scratch / "t.json"));
    CHECK(tree["format"] == "lodlab tree");
    CHECK(tree["dim"] == 3);
    const Json spheres = Json::parse(text_of(scratch / "t.spheres.json"));
    CHECK(spheres["frame"] == "mesh");
    const std::size_t of_level_1 = spheres["levels"][1]["spheres"].size();
    CHECK(text_of(scratch / "t.sph").starts_with("3 8\n"));
    const std::string urdf = text_of(scratch / "t.urdf");
    std::size_t count = 0;
    for (auto at = urdf.find("<sphere"); at != std::string::npos; at = urdf.find("<sphere", at + 1))
        ++count;
    CHECK(count == of_level_1);
    check_failure(lodlab({"tree", "gear:9", "--out", scratch / "t.urdf"}), 2, "t.urdf");
}

TEST_CASE("a scene in space runs, repeats and is played again to the same bits") {
    const Scratch scratch;
    const std::string trace = scratch / "trace.json";
    const Json timed = result(
        {"simulate", "knot_meets_ring", "--milliseconds", "0.02", "--trace", trace, "--json"});
    const Json again = result({"simulate", "knot_meets_ring", "--replay", trace, "--json"});
    CHECK(timed["dim"] == 3);
    CHECK(timed["momentum"]["start"].size() == 3);
    CHECK(timed["state_hash"] == again["state_hash"]);
    const Json coarse = result({"simulate", "knot_meets_ring", "--level", "1", "--json"});
    const Json fine = result({"simulate", "knot_meets_ring", "--json"});
    CHECK(coarse["tests"] < fine["tests"]);
    CHECK(coarse["level_reached"]["max"] == 1);
    CHECK(fine["contacts"] > 0);
    CHECK(fine["energy"]["end"] == Approx(fine["energy"]["start"].get<double>()));
}

TEST_CASE("a near miss in space is a collision at a coarse level and none at the leaves") {
    const Json coarse = result({"collide", "near_miss_in_space", "--level", "1", "--json"});
    CHECK(coarse["dim"] == 3);
    CHECK(coarse["pairs"][0]["verdict"] == "possible");
    CHECK(coarse["pairs"][0]["contacts"][0]["normal"].size() == 3);
    const Json fine = result({"collide", "near_miss_in_space", "--json"});
    CHECK(fine["pairs"][0]["verdict"] == "apart");
}

TEST_CASE("what is nonsense in space is refused in one line") {
    const Scratch scratch;
    check_failure(lodlab({"tree", "text:R", "--dim", "3"}), 2, "text:R is a shape of the plane");
    check_failure(lodlab({"tree", "star:5", "--dim", "3"}), 2, "star:5 is a shape of the plane");
    check_failure(lodlab({"tree", "knot", "--dim", "2"}), 2, "knot");
    check_failure(lodlab({"tree", "knot", "--dim", "4"}), 2, "--dim");
    check_failure(lodlab({"tree", "knot", "--builder", "quadtree"}), 2, "choose octree or cover");
    check_failure(lodlab({"tree", "knot", "--error", "2"}), 2, "--error");
    check_failure(lodlab({"tree", "knot", "--nodes", "0"}), 2, "--nodes");
    check_failure(lodlab({"tree", "gear:9", "--fill"}), 2, "only meshes are filled");
    check_failure(lodlab({"tree", "gear:9", "--effort", "1"}), 2, "only the builder cover");
    check_failure(lodlab({"tree", scratch / "absent.obj"}), 3, "absent.obj");
    check_failure(lodlab({"tree", scratch.write("empty.obj", "")}), 3, "empty.obj");
    check_failure(
        lodlab({"tree", scratch.write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")}), 3,
        "nan");
    check_failure(
        lodlab({"tree", scratch.write("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")}), 3,
        "far");
    check_failure(lodlab({"tree", scratch.write("torn.glb", "glTF\x02")}), 3, "torn.glb");
    check_failure(lodlab({"tree", "package:nothing/bunny.obj"}), 3, "no such package");
    check_failure(lodlab({"tree", "package:glmark2-data/../x.obj"}), 3,
                  "names no file of the package");
    check_failure(lodlab({"collide", "offset_boxes", "--projected", "--out", scratch / "f.png"}), 2,
                  "drop --projected");
    check_failure(lodlab({"figure", "4", "--dim", "3"}), 2, "leave --dim 3 out");
    const std::string flat =
        scratch.write("flat.toml", "dim = 3\n[[body]]\nshape = \"box\"\nposition = [1, 2]\n");
    check_failure(lodlab({"simulate", flat}), 3, "flat.toml:4:1: position must be three numbers");
    scratch.write("open.obj", open_corner);
    const std::string open =
        scratch.write("open.toml", "dim = 3\n[[body]]\nshape = \"open.obj\"\n");
    check_failure(lodlab({"simulate", open}), 3, "open.obj: the mesh does not");
}

TEST_CASE("remarks say what the numbers of a mesh file hold, and exports stand in its frame") {
    const Scratch scratch;
    const std::string far =
        scratch.write("far.obj",
                      "v 30000000.25 0 0\nv 30000001.25 0 0\nv 30000000.25 1 0\nv 30000000.25 0 1\n"
                      "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const Json json = result({"tree", far, "--builder", "octree", "--depth", "0", "--out",
                              scratch / "far.spheres.json", "--json"});
    CHECK(json["shape"]["measure"] == Approx(1.0 / 6).epsilon(1e-12));
    CHECK(contains(json["shape"]["remarks"].dump(), "far from the origin"));
    std::ifstream in(scratch / "far.spheres.json");
    const Json spheres = Json::parse(in);
    CHECK(spheres["levels"][0]["spheres"][0]["centre"][0] == Approx(30000000.75).margin(0.3));
}

TEST_CASE("built trees are kept for the next time, unless the user says no") {
    const Scratch scratch;
    Start start;
    start.environment = {"PATH=/usr/bin:/bin", "HOME=/nonexistent",
                         "XDG_CACHE_HOME=" + scratch.path().string()};
    const std::vector<std::string> command{"tree", "L", "--depth", "1", "--json"};
    auto without = command;
    without.emplace_back("--no-cache");
    const Outcome built = lodlab(without, start);
    CHECK(scratch.files().empty());
    const Outcome kept = lodlab(command, start);
    const auto entries = [&] {
        const auto folder = std::filesystem::directory_iterator(scratch.path() / "lodlab");
        return std::distance(begin(folder), end(folder));
    };
    CHECK(entries() == 1);
    const Outcome found = lodlab(command, start);
    CHECK(entries() == 1);
    CHECK(built.out == kept.out);
    CHECK(built.out == found.out);
    REQUIRE(lodlab({"simulate", "offset_boxes", "--duration", "0.1"}, start).code == 0);
    CHECK(entries() > 1);
}

TEST_CASE("space is drawn: a tree, a traversal, a strip") {
    const Scratch scratch;
    const auto drawn = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--quality", "draft", "--out", scratch / "f.png"});
        const Outcome outcome = lodlab(arguments);
        INFO(outcome.err);
        CHECK(outcome.code == 0);
        CHECK(std::filesystem::file_size(scratch.path() / "f.png") > 5000);
    };
    drawn({"tree", "ring", "--dim", "3", "--builder", "octree", "--depth", "2"});
    drawn({"collide", "near_miss_in_space"});
    drawn({"simulate", "knot_meets_ring", "--level", "2"});
    drawn({"simulate", "offset_balls", "--plot"});
    drawn({"collide", "knot_meets_ring", "--projected"});
    drawn({"figure", "2", "--dim", "3"});
    drawn({"figure", "3", "--dim", "3"});
}
