#include "scenes/setup.hpp"

#include "core/error.hpp"
#include "tests/catch.hpp"

namespace {
scenes::Setup staged(const std::string& text) {
    return scenes::set_up(scenes::parse_scene(text, "/tmp/test.toml"));
}
}  // namespace

TEST_CASE("a body has its shape's exact mass and inertia") {
    const scenes::Setup setup = staged(R"(
density = 3
[[body]]
shape = "box:2,1"
[[body]]
shape = "box:2,1"
mass = 12
[[body]]
shape = "box:2,1"
static = true
)");
    // A box of 2 x 1: mass = area x density, inertia = m (a^2 + b^2) / 12.
    CHECK(1 / setup.bodies[0].inverse_mass == Approx(6));
    CHECK(setup.bodies[0].inertia(0, 0) == Approx(6.0 * 5 / 12));
    CHECK(1 / setup.bodies[1].inverse_mass == Approx(12));
    CHECK(setup.bodies[1].inertia(0, 0) == Approx(12.0 * 5 / 12));
    CHECK(setup.bodies[2].is_static());
}

TEST_CASE("bodies with the same shape and settings share one tree") {
    const scenes::Setup setup = staged(R"(
depth = 3
[[body]]
shape = "gear:9"
position = [-5, 0]
[[body]]
shape = "gear:9"
angle = 30
[[body]]
shape = "gear:9"
depth = 2
position = [5, 0]
)");
    CHECK(setup.shapes[0] == setup.shapes[1]);
    CHECK(setup.bodies[0].tree == setup.bodies[1].tree);
    CHECK(setup.shapes[0] == setup.shapes[2]);
    CHECK(setup.bodies[0].tree != setup.bodies[2].tree);
}

TEST_CASE("a shape that is refused is named with its place in the file") {
    try {
        (void)staged("[[body]]\nshape = \"geer:9\"\n");
        FAIL("accepted");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::input_refused);
        CHECK(std::string(error.what()).starts_with("/tmp/test.toml:1:1: body body 1: "));
    }
}

TEST_CASE("bodies that start inside each other are allowed and reported") {
    const scenes::Setup setup = staged(R"(
[[body]]
name = "left"
shape = "box:1,1"
[[body]]
name = "right"
shape = "box:1,1"
position = [0.9, 0]
[[body]]
name = "far"
shape = "box:1,1"
position = [0, 1.01]
)");
    REQUIRE(setup.warnings.size() == 1);
    CHECK(setup.warnings[0].starts_with(
        "/tmp/test.toml:5:1: bodies left and right touch or overlap at the start"));
}

TEST_CASE("static bodies may overlap each other without a word") {
    const scenes::Setup setup = staged(R"(
[[body]]
shape = "box:4,1"
static = true
[[body]]
shape = "box:1,4"
static = true
)");
    CHECK(setup.warnings.empty());
}
