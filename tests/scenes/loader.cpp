#include <filesystem>
#include <numbers>

#include "core/error.hpp"
#include "scenes/scene.hpp"
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

constexpr const char* every_key = R"(
name = "n"
title = "A sentence"
dim = 2
time_step = 0.01
duration = 1
level = 3
response = "mean"
contact_model = "node_normal"
point_model = "plane_of_intersection"
priority = "in_order"
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
    CHECK(scene.point_model == lod::PointModel::plane_of_intersection);
    CHECK(scene.priority == lod::Priority::in_order);
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
    CHECK(first.spin == 7);
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
    CHECK(contains(refusal("dim = 3\n"), "scenes in space come later; write dim = 2"));
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
