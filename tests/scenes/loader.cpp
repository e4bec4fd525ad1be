#include <filesystem>
#include <numbers>

#include "lodlab/core/base/error.hpp"
#include "lodlab/scenes/scene.hpp"
#include "tests/catch.hpp"

namespace {

scenes::Scene parsed(const std::string& text) {
    return scenes::parse_scene(text, "/tmp/x/test.toml");
}

/// The line with which a scene is refused.
std::string refusal(const std::string& text) {
    try {
        (void)parsed(text);
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::input_refused);
        return error.what();
    }
    return "accepted";
}

/// A scene whose only body has this line; the line is the third of the file.
std::string body(const std::string& line) {
    return "[[body]]\nshape = \"box\"\n" + line + "\n";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

constexpr const char* in_space = R"(
dim = 3
priority = "perceptual"
eye = [1, 2, 30]
[[body]]
shape = "knot"
position = [1, 2, 3]
axis = [0, 3, 4]
angle = 90
velocity = [4, 5, 6]
spin = [7, 8, 9]
fill = true
[camera]
centre = [1, 2, 3]
azimuth = 180
elevation = -30
perspective = true
)";

constexpr const char* every_key = R"(
name = "n"
title = "A sentence"
dim = 2
time_step = 0.01
duration = 1
level = 3
response = "mean"
contact_model = "node_normal"
finest = "backtrack"
finest_pairs = 3
point_model = "plane_of_intersection"
priority = "in_order"
fixation = [0.5, -1]
restitution = 0.5
density = 2
builder = "pieces"
branching = 5
depth = 4
[camera]
centre = [1, 2]
width = 3
[[body]]
name = "first"
shape = "gear:9"
size = 2
mass = 3
position = [4, 5]
angle = 180
velocity = [-1, 0.5]
spin = 7
restitution = 0.25
builder = "quadtree"
branching = 4
depth = 6
[[body]]
shape = "text:R"
density = 8
static = true
)";

}  // namespace

TEST_CASE("every key of the scene arrives in its field") {
    const scenes::Scene scene = parsed(every_key);
    CHECK(scene.name == "n");
    CHECK(scene.title == "A sentence");
    CHECK(scene.dim == 2);
    CHECK(scene.time_step == 0.01);
    CHECK(scene.frames() == 100);
    CHECK(scene.limits.level == 3);
    CHECK_FALSE(scene.limits.node_tests);
    CHECK(scene.response == lod::Response::mean);
    CHECK(scene.contact_model == lod::ContactModel::node_normal);
    CHECK(scene.finest.level == lod::Finest::backtrack);
    CHECK(scene.finest.most_pairs == 3);
    CHECK(scene.point_model == lod::PointModel::plane_of_intersection);
    CHECK(scene.priority == lod::Priority::level_order);
    CHECK(scene.viewer.fixation == lod::Viewer::Point{0.5, -1, 0});
    CHECK_FALSE(scene.viewer.eye);
    REQUIRE(scene.camera);
    CHECK(scene.camera->centre == scenes::Triple{1, 2, 0});
    CHECK(scene.camera->width == 3);
}

TEST_CASE("every key of a body arrives in its field") {
    const scenes::Scene scene = parsed(every_key);
    REQUIRE(scene.bodies.size() == 2);
    const scenes::BodySpec& first = scene.bodies[0];
    CHECK(first.name == "first");
    CHECK(first.shape == "gear:9");
    CHECK(first.size == 2.0);
    CHECK(first.mass == 3.0);
    CHECK(first.density == 2);
    CHECK_FALSE(first.is_static);
    CHECK(first.position == scenes::Triple{4, 5, 0});
    CHECK(first.angle == Approx(std::numbers::pi));
    CHECK(first.velocity == scenes::Triple{-1, 0.5, 0});
    CHECK(first.spin == scenes::Triple{0, 0, 7});
    CHECK(first.restitution == 0.25);
    CHECK(first.builder == "quadtree");
    CHECK(first.branching == 4);
    CHECK(first.depth == 6);
    const scenes::BodySpec& second = scene.bodies[1];
    CHECK(second.name == "body 2");
    CHECK(second.is_static);
    CHECK(second.density == 8);
    CHECK(second.restitution == 0.5);
    CHECK(second.builder == "pieces");
    CHECK(second.branching == 5);
    CHECK(second.depth == 4);
}

TEST_CASE("vectors of a scene in space are triples") {
    const scenes::Scene scene = parsed(in_space);
    CHECK(scene.dim == 3);
    CHECK(scene.priority == lod::Priority::perceptual);
    CHECK(scene.viewer.eye == lod::Viewer::Point{1, 2, 30});
    const scenes::BodySpec& body = scene.bodies.at(0);
    CHECK(body.position == scenes::Triple{1, 2, 3});
    CHECK(body.axis[1] == Approx(0.6));
    CHECK(body.axis[2] == Approx(0.8));
    CHECK(body.angle == Approx(std::numbers::pi / 2));
    CHECK(body.velocity == scenes::Triple{4, 5, 6});
    CHECK(body.spin == scenes::Triple{7, 8, 9});
    CHECK(body.fill);
    const scenes::Camera camera = scene.camera.value();
    CHECK(camera.centre == scenes::Triple{1, 2, 3});
    CHECK(camera.width == 0);
    CHECK(camera.azimuth.value() == Approx(std::numbers::pi));
    CHECK(camera.elevation.value() == Approx(-std::numbers::pi / 6));
    CHECK(camera.perspective);
}

TEST_CASE("what belongs to the other dimension is refused with the mend") {
    const auto in = [](int dim, const std::string& line) {
        return refusal("dim = " + std::to_string(dim) + "\n" + body(line));
    };
    CHECK(contains(in(2, "position = [1, 2, 3]"), "test.toml:4:1: position must be two numbers"));
    CHECK(contains(in(3, "position = [1, 2]"), "test.toml:4:1: position must be three numbers"));
    CHECK(contains(in(3, "velocity = 1"), "velocity must be three numbers"));
    CHECK(contains(in(3, "spin = 1"), "spin must be three numbers"));
    CHECK(contains(in(2, "spin = [0, 0, 1]"), "spin must be a number"));
    CHECK(contains(in(3, "axis = [0, 0, 0]"), "axis must not be [0, 0, 0]"));
    CHECK(contains(in(3, "axis = [0, nan, 1]"), "axis must lie between"));
    CHECK(contains(in(2, "axis = [0, 0, 1]"), "axis is a key of scenes in space; drop it, or"));
    CHECK(contains(in(2, "fill = true"), "fill is a key of scenes in space"));
    CHECK(contains(in(2, "[camera]\nazimuth = 1"), "test.toml:5:1: azimuth is a key of scenes in"));
    CHECK(contains(in(3, "fill = 1"), "fill must be true or false"));
}

TEST_CASE("dim says how long vectors are wherever it stands") {
    const scenes::Scene scene =
        parsed("duration = 1\ndim = 3\n[[body]]\nshape = \"box\"\nposition = [1, 2, 3]\n");
    CHECK(scene.bodies[0].position[2] == 3);
}

TEST_CASE("a scene that says nothing has the documented defaults") {
    const scenes::Scene scene = parsed("[[body]]\nshape = \"box\"\n");
    CHECK(scene.name == "test");
    CHECK(scene.time_step == 1.0 / 240);
    CHECK(scene.duration == 2);
    CHECK(scene.frames() == 480);
    CHECK_FALSE(scene.limits.level);
    CHECK(scene.response == lod::Response::net);
    CHECK(scene.bodies[0].restitution == 1);
    CHECK(scene.bodies[0].density == 1);
    CHECK_FALSE(scene.bodies[0].size);
}

TEST_CASE("a refusal names file, line and column") {
    CHECK(refusal(body("restitution = 1.5")).starts_with("/tmp/x/test.toml:3:1: restitution must"));
    CHECK(refusal("name = \"a\"\nname = \"b\"\n").starts_with("/tmp/x/test.toml:2:"));
    CHECK(contains(refusal("level = = 3\n"), "test.toml:1:9: this is no TOML"));
    CHECK(refusal("").starts_with("/tmp/x/test.toml:1:1: the scene has no body"));
}

TEST_CASE("an unknown key is refused with the key that was meant") {
    CHECK(contains(refusal(body("veloctiy = [1, 0]")), "(did you mean velocity?)"));
    CHECK(contains(refusal("respnse = \"net\"\n"), "(did you mean response?)"));
    CHECK(contains(refusal("response = \"nett\"\n"), "(did you mean net?)"));
    CHECK(contains(refusal(body("zzz = 1")), "unknown key zzz in a body; "));
}

TEST_CASE("numbers outside their range are refused") {
    const std::string value =
        GENERATE("nan", "inf", "-inf", "1e300", "-1e300", "\"1\"", "[1]", "true", "1979-05-27");
    for (const char* key : {"size", "mass", "density", "angle", "spin", "restitution"}) {
        const std::string line = refusal(body(std::string(key) + " = " + value));
        CHECK(contains(line, std::string("test.toml:3:1: ") + key + " must"));
    }
    for (const char* key : {"position", "velocity"}) {
        const std::string line = refusal(body(std::string(key) + " = [0, " + value + "]"));
        CHECK(contains(line, std::string("test.toml:3:1: ") + key + " must"));
    }
    for (const char* key : {"time_step", "duration", "milliseconds", "level", "node_tests"})
        CHECK(contains(refusal(std::string(key) + " = " + value), "test.toml:1:1: "));
    CHECK(contains(refusal("fixation = [0, " + value + "]"), "test.toml:1:1: "));
}

TEST_CASE("a quota below nothing is refused, one of nothing is taken") {
    CHECK(contains(refusal("milliseconds = -1e-9"), "must lie between 0 and 1e+06, not -1e-09"));
    CHECK(contains(refusal("node_tests = -1"), "must lie between 0 and"));
    CHECK(parsed("milliseconds = 0\n[[body]]\nshape = \"box\"\n").limits.milliseconds == 0.0);
    CHECK(parsed("node_tests = 0\n[[body]]\nshape = \"box\"\n").limits.node_tests == 0U);
}

TEST_CASE("values that mean nothing are refused with the mend") {
    CHECK(contains(refusal(body("mass = 0")), "mass must be above 0, not 0"));
    CHECK(contains(refusal(body("mass = -2")), "write static = true"));
    CHECK(contains(refusal(body("density = 0")), "above 0"));
    CHECK(contains(refusal(body("restitution = -0.1")), "between 0 and 1, not -0.1"));
    CHECK(contains(refusal(body("branching = 1")), "between 2 and 64, not 1"));
    CHECK(contains(refusal(body("branching = 65")), "between 2 and 64, not 65"));
    CHECK(contains(refusal(body("depth = -1")), "between 0 and 12, not -1"));
    CHECK(contains(refusal(body("depth = 13")), "between 0 and 12, not 13"));
    CHECK(contains(refusal(body("depth = 2.5")), "whole number"));
    CHECK(contains(refusal(body("size = 0")), "size must lie between"));
    CHECK(contains(refusal("time_step = 0"), "time_step must lie between"));
    CHECK(contains(refusal("dim = 4\n"), "between 2 and 3"));
    CHECK(contains(refusal("level = 2\nmilliseconds = 3\n"), "is a second limit; keep one"));
    CHECK(contains(refusal(body("static = true\nspin = 1")),
                   "is static and has a velocity or a spin"));
    CHECK(contains(refusal("[body]\nshape = \"box\"\n"), "write [[body]], with two brackets"));
    CHECK(contains(refusal("[[body]]\nname = \"a\"\n"), "has no shape"));
    CHECK(
        contains(refusal(body("name = \"a\"") + body("name = \"a\"")), "second body is called a"));
    CHECK(contains(refusal(body("") + "[camera]\ncentre = [0, 0]\n"), "the camera has no width"));
}

TEST_CASE("a shape file outside the scene's folder is refused") {
    const auto shape = [](const std::string& name) {
        return refusal("[[body]]\nshape = \"" + name + "\"\n");
    };
    CHECK(contains(shape("../secret.svg"), "lies outside the folder of the scene"));
    CHECK(contains(shape("/etc/passwd"), "lies outside the folder of the scene"));
    CHECK(contains(shape("a/../../secret.svg"), "lies outside the folder of the scene"));
    CHECK(contains(shape("absent.svg"), "there is no shape file"));
    CHECK(contains(shape("absent.obj"), "there is no shape file"));
    CHECK(contains(shape("/usr/bunny.obj"), "package:glmark2-data/bunny.obj"));
}

TEST_CASE("a scene with too many bodies exceeds a limit") {
    std::string text;
    for (std::size_t i = 0; i <= scenes::most_bodies; ++i) text += "[[body]]\n";
    try {
        (void)parsed(text);
        FAIL("accepted");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::limit_exceeded);
        CHECK(contains(error.what(), "the limit is 10000"));
    }
}

TEST_CASE("every scene that comes with lodlab loads") {
    for (const auto& entry : std::filesystem::directory_iterator(LODLAB_SOURCE_DIR "/scenes")) {
        if (entry.path().extension() != ".toml") continue;
        INFO(entry.path());
        const scenes::Scene scene = scenes::load_scene(entry.path());
        CHECK(scene.name == entry.path().stem());
        CHECK_FALSE(scene.title.empty());
    }
}
