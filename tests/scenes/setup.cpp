#include "lodlab/scenes/setup.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/exact/exact_shape.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/sha256.hpp"
#include "tests/catch.hpp"

namespace {
template <int Dim = 2>
scenes::Setup<Dim> staged(const std::string& text) {
    return scenes::set_up<Dim>(scenes::parse_scene(text, "/tmp/test.toml"));
}
}  // namespace

TEST_CASE("a body has its shape's exact mass and inertia") {
    const scenes::Setup<2> setup = staged(R"(
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

TEST_CASE("a half-space is static, points up unless it is turned, and is met at its border") {
    const scenes::Setup<2> setup = staged(R"(
[[body]]
shape = "half_space"
position = [0, -1]
[[body]]
shape = "half_space"
position = [3, 0]
angle = 90
[[body]]
shape = "box:1,1"
position = [0, -0.6]
)");
    CHECK(setup.bodies[0].is_static());
    CHECK(setup.bodies[0].tree->half_space == lod::Vector<2>(0, 1));
    const auto normal =
        lod::Space<2>::rotation(setup.bodies[1].orientation) * *setup.bodies[1].tree->half_space;
    CHECK((normal - lod::Vector<2>(-1, 0)).norm() <= 1e-15);
    REQUIRE(setup.warnings.size() == 1);
    CHECK_THAT(setup.warnings[0], lodtest::contains("bodies body 1 and body 3 touch or overlap"));
    // The true shapes: the lower side of the box is 0.1 below the border.
    const auto& bodies = setup.bodies;
    CHECK(lod::exactly_overlap(bodies[0], bodies[2]));
    CHECK(lod::separation(bodies[1], bodies[2]).distance == Approx(2.5));
}

TEST_CASE("a half-space in space points along the second axis") {
    const scenes::Setup<3> setup = staged<3>(R"(
dim = 3
[[body]]
shape = "half_space"
[[body]]
shape = "box:1,1,1"
builder = "octree"
depth = 1
position = [200, 0.75, -300]
)");
    CHECK(setup.bodies[0].tree->half_space == lod::Vector<3>(0, 1, 0));
    CHECK(setup.warnings.empty());
    CHECK(lod::separation(setup.bodies[0], setup.bodies[1]).distance == Approx(0.25));
}

TEST_CASE("what a half-space does not have is refused with the mend") {
    const auto refusal = [](const std::string& key) {
        return [key] { (void)staged("[[body]]\nshape = \"half_space\"\n" + key); };
    };
    CHECK_THROWS_WITH(refusal("size = 2")(),
                      lodtest::contains("half-space, which has no size; drop the key"));
    CHECK_THROWS_WITH(refusal("mass = 2")(), lodtest::contains("which has no mass; drop the key"));
    CHECK_THROWS_WITH(refusal("velocity = [1, 0]")(),
                      lodtest::contains("is static and has a velocity"));
}

TEST_CASE("bodies with the same shape and settings share one tree") {
    const scenes::Setup<2> setup = staged(R"(
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
    const scenes::Setup<2> setup = staged(R"(
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
    const scenes::Setup<2> setup = staged(R"(
[[body]]
shape = "box:4,1"
static = true
[[body]]
shape = "box:1,4"
static = true
)");
    CHECK(setup.warnings.empty());
}

TEST_CASE("a solid has its exact mass and inertia") {
    const auto setup = staged<3>(R"(
dim = 3
builder = "octree"
depth = 0
density = 3
[[body]]
shape = "box:2,1,4"
[[body]]
shape = "box:2,1,4"
size = 8
mass = 12
)");
    // A box of a x b x c: mass = volume x density, inertia about x = m (b^2 + c^2) / 12, and so on.
    const auto& inertia = setup.bodies[0].inertia;
    CHECK(1 / setup.bodies[0].inverse_mass == Approx(24));
    CHECK(inertia(0, 0) == Approx(24.0 * (1 + 16) / 12));
    CHECK(inertia(1, 1) == Approx(24.0 * (4 + 16) / 12));
    CHECK(inertia(2, 2) == Approx(24.0 * (4 + 1) / 12));
    CHECK(inertia(0, 1) == Approx(0).margin(1e-12));
    CHECK(setup.bodies[1].inertia(0, 0) == Approx(12.0 * (4 + 64) / 12));  // twice as large
}

TEST_CASE("a body in space is turned about its axis by the right hand") {
    const auto setup = staged<3>(R"(
dim = 3
builder = "octree"
depth = 0
[[body]]
shape = "L"
axis = [0, 2, 0]
angle = 90
spin = [1, 2, 3]
[[body]]
shape = "L"
angle = 90
position = [5, 0, 0]
)");
    const auto turned = [&](std::size_t body, const lod::Vector<3>& v) {
        return lod::Vector<3>(lod::Space<3>::rotation(setup.bodies[body].orientation) * v);
    };
    CHECK(turned(0, {0, 0, 1}).isApprox(lod::Vector<3>(1, 0, 0)));
    CHECK(turned(1, {1, 0, 0}).isApprox(lod::Vector<3>(0, 1, 0)));  // as in the plane
    CHECK(setup.bodies[0].spin == lod::Vector<3>(1, 2, 3));
}

TEST_CASE("solids that touch, or lie one in the other, at the start are reported") {
    const auto warnings = [](const std::string& second) {
        return staged<3>(
                   "dim = 3\nbuilder = \"octree\"\ndepth = 0\n[[body]]\nshape = "
                   "\"box:1,1,1\"\n[[body]]\n" +
                   second)
            .warnings.size();
    };
    CHECK(warnings("shape = \"box:1,1,1\"\nposition = [0.9, 0.9, 0.9]\n") == 1);
    CHECK(warnings("shape = \"box:1,1,1\"\nposition = [1.01, 0, 0]\n") == 0);
    CHECK(warnings("shape = \"ball:1\"\nsize = 0.5\n") == 1);
    CHECK(warnings("shape = \"ball:1\"\nsize = 5\n") == 1);
    // Their balls meet, their faces do not.
    CHECK(warnings("shape = \"box:1,1,1\"\nposition = [0, 1.2, 0]\n") == 0);
}

TEST_CASE("a shape of the other dimension is refused with the mend") {
    const auto refusal = [](const std::string& dim, const std::string& shape) -> std::string {
        const std::string text =
            "dim = " + dim + "\n[[body]]\ndepth = 0\nshape = \"" + shape + "\"\n";
        try {
            if (dim == "2")
                (void)staged<2>(text);
            else
                (void)staged<3>(text);
        } catch (const lod::Error& error) {
            CHECK(error.kind() == lod::ErrorKind::input_refused);
            return error.what();
        }
        return "accepted";
    };
    CHECK_THAT(refusal("3", "text:R"), lodtest::contains("text:R is a shape of the plane"));
    CHECK_THAT(refusal("3", "star:5"), lodtest::contains("star:5 is a shape of the plane"));
    CHECK_THAT(refusal("2", "knot"), lodtest::contains("'knot' names no shape"));
    CHECK_THAT(refusal("3", "package:nothing/a.obj"), lodtest::contains("no such package"));
    CHECK_THAT(refusal("2", "package:glmark2-data/bunny.obj"), lodtest::contains("write dim = 3"));
}

TEST_CASE("a scene made with another version of a file, or with a font, says so once") {
    const auto warnings_of = [](const std::string& keys) {
        const std::string text = "duration = 1\n[[body]]\nname = \"one\"\n" + keys +
                                 "depth = 1\n[[body]]\nname = \"two\"\nposition = [9, 0]\n" + keys +
                                 "depth = 1\n";
        const auto path = std::filesystem::path(LODLAB_SOURCE_DIR) / "scenes" / "made_here.toml";
        return scenes::set_up<2>(scenes::parse_scene(text, path)).warnings;
    };
    const std::string letter = "shape = \"shapes/letter_R.svg\"\n";
    CHECK(warnings_of(letter).empty());
    const std::string right =
        io::sha256(lod::read_text_file(LODLAB_SOURCE_DIR "/scenes/shapes/letter_R.svg", 1 << 20));
    CHECK(warnings_of(letter + "sha256 = \"" + right + "\"\n").empty());

    const auto changed = warnings_of(letter + "sha256 = \"" + std::string(64, '0') + "\"\n");
    REQUIRE(changed.size() == 1);
    CHECK_THAT(changed[0], lodtest::contains("made_here.toml:2:"));
    CHECK_THAT(changed[0], lodtest::contains("another version of shapes/letter_R.svg"));

    const auto font = warnings_of("shape = \"text:R\"\n");
    REQUIRE(font.size() == 1);
    CHECK_THAT(font[0], lodtest::contains("font of this machine"));

    CHECK_THROWS_AS(warnings_of(letter + "sha256 = \"12\"\n"), lod::Error);
}
