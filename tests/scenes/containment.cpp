// Nobody leaves a closed container and nobody passes a wall, at any level and budget.

#include "lodlab/core/frame/frame.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/sanitized.hpp"

using lod::Body;
using lodtest::Random;

namespace {

/// A generator's shape, `size` times as large.
Body<2> body_of(const char* spec, double size = 1) {
    lod2d::Shape shape = lod2d::generate(spec);
    for (lod2d::Ring& ring : shape.polygon.rings)
        for (lod2d::Point& point : ring) point *= size;
    shape = lod2d::make_shape(shape.name, shape.polygon);
    Body<2> body;
    lod::set_mass<2>(body, shape.area, lod::Inertia<2>::Constant(shape.second_moment));
    lod2d::TreeSettings settings;
    settings.depth = 3;
    body.tree = std::make_shared<lod::SphereTree<2>>(lod2d::build_tree(shape, settings));
    return body;
}

Body<3> solid_of(const char* spec) {
    const lod3d::Solid solid = lod3d::generate(spec);
    Body<3> body;
    lod::set_mass<3>(body, solid.volume, solid.second_moment);
    lod3d::TreeSettings settings;
    settings.builder = lod3d::Builder::octree;
    settings.depth = 2;
    body.tree = std::make_shared<lod::SphereTree<3>>(lod3d::build_tree(solid, settings));
    return body;
}

template <int Dim>
Body<Dim> standing(Body<Dim> body, const lod::Vector<Dim>& position) {
    lod::make_static(body);
    body.position = position;
    return body;
}

/// What may leave: `movers` of the bodies of a container, which stand first.
template <int Dim>
struct World {
    std::vector<Body<Dim>> bodies;
    std::size_t movers = 0;
    double half = 0;  ///< of the container, to the middle of its walls: nobody's centre gets there

    /// A body at a place and a speed drawn at random.
    void add(Random& random, Body<Dim> body, const lod::Vector<Dim>& position, double speed) {
        body.position = position;
        body.velocity = speed * lodtest::random_unit<Dim>(random);
        body.spin = lodtest::random_spin<Dim>(random, 2);
        bodies.push_back(std::move(body));
        ++movers;
    }
};

struct Allowed {
    int level = 1000;
    std::optional<std::uint64_t> tests;
};
constexpr Allowed all_allowed[] = {{0, {}},   {1, {}},    {1000, {}},
                                   {1000, 0}, {1000, 50}, {1000, 150}};

/// How many are outside after so many frames.
template <int Dim>
int outside(World<Dim> world, const Allowed& allowed, int frames) {
    lod::FrameStorage<Dim> storage;
    lod::FrameSettings settings;
    settings.time_step = 1.0 / 60;
    settings.deepest_level = allowed.level;
    const std::size_t first = world.bodies.size() - world.movers;
    for (int frame = 0; frame < frames; ++frame) {
        lod::Budget budget =
            allowed.tests ? lod::Budget::node_tests(*allowed.tests) : lod::Budget::unlimited();
        lod::advance<Dim>(world.bodies, settings, budget, storage);
    }
    int count = 0;
    for (std::size_t i = first; i < world.bodies.size(); ++i)
        count += world.bodies[i].position.cwiseAbs().maxCoeff() > world.half;
    return count;
}

/// Four walls with trees, 1 m thick, about a square of 6 m.
World<2> four_walls(Random& random, double speed) {
    static const Body<2> across = body_of("box:8,1");
    static const Body<2> along = body_of("box:1,8");
    static const Body<2> shapes[] = {body_of("gear:9"), body_of("star:5"), body_of("L")};
    World<2> world;
    world.half = 3.5;
    world.bodies = {standing<2>(across, {0, -3.5}), standing<2>(across, {0, 3.5}),
                    standing<2>(along, {-3.5, 0}), standing<2>(along, {3.5, 0})};
    for (int i = 0; i < 9; ++i)
        world.add(random, shapes[random.below(3)], {1.7 * (i % 3 - 1), 1.7 * (i / 3 - 1)}, speed);
    return world;
}

/// A ring, 1.2 m thick, about a hole of 5.6 m.
World<2> in_a_ring(Random& random, double speed) {
    static const Body<2> ring = body_of("ring:0.7", 8);
    static const Body<2> shapes[] = {body_of("gear:9"), body_of("star:5"), body_of("L")};
    World<2> world;
    world.half = 3.4;
    world.bodies = {standing<2>(ring, {0, 0})};
    for (int i = 0; i < 5; ++i)
        world.add(
            random, shapes[random.below(3)],
            {i == 4 ? 0 : 1.3 * (i % 2) * (i - 2), i == 4 ? 0 : 1.3 * ((i + 1) % 2) * (i - 1)},
            speed);
    return world;
}

/// A bowl with walls of 1 m, open above, and a lid.
World<2> in_a_bowl(Random& random, double speed) {
    static const Body<2> bowl = body_of("U:0.125", 8);
    static const Body<2> lid = body_of("box:10,1");
    static const Body<2> shapes[] = {body_of("gear:9"), body_of("star:5"), body_of("L")};
    World<2> world;
    const Body<2> standing_bowl = standing<2>(bowl, {0, 0});
    world.bodies = {standing_bowl, standing<2>(lid, {0, 5.5})};
    world.half = 5.5;
    for (int i = 0; i < 6; ++i)
        world.add(random, shapes[random.below(3)], {1.7 * (i % 3 - 1), 1.7 * (i / 3) + 0.5}, speed);
    return world;
}

/// A box of six plates, 1 m thick, about a cube of 3 m.
World<3> six_plates(Random& random, double speed) {
    static const Body<3> shapes[] = {solid_of("box:0.7,0.7,0.7"), solid_of("box:0.9,0.5,0.4")};
    static const Body<3> plates[] = {solid_of("box:1,5,5"), solid_of("box:5,1,5"),
                                     solid_of("box:5,5,1")};
    World<3> world;
    world.half = 2;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-2.0, 2.0})
            world.bodies.push_back(
                standing<3>(plates[axis], lod::Vector<3>(sign * lod::Vector<3>::Unit(axis))));
    for (int i = 0; i < 8; ++i)
        world.add(random, shapes[random.below(2)], {i % 2 - 0.5, i / 2 % 2 - 0.5, i / 4 - 0.5},
                  speed);
    return world;
}

/// A square of 6 m, or a cube of 3 m, between half-spaces.
template <int Dim>
World<Dim> between_half_spaces(std::span<const Body<Dim>> shapes, double half, int across,
                               Random& random, double speed) {
    World<Dim> world;
    world.half = half + 0.25;  // a fast one is seen there for a frame, on its way back
    for (int axis = 0; axis < Dim; ++axis)
        for (const double sign : {-half, half}) {
            Body<Dim> wall;
            wall.tree = std::make_shared<lod::SphereTree<Dim>>(
                lod::half_space<Dim>(lod::Vector<Dim>(-sign * lod::Vector<Dim>::Unit(axis))));
            world.bodies.push_back(
                standing<Dim>(wall, lod::Vector<Dim>(sign * lod::Vector<Dim>::Unit(axis))));
        }
    const int count = Dim == 2 ? across * across : across * across * across;
    for (int i = 0; i < count; ++i) {
        lod::Vector<Dim> position;
        for (int axis = 0, rest = i; axis < Dim; ++axis, rest /= across)
            position[axis] = 2 * half / across * (rest % across + 0.5) - half;
        const auto which = static_cast<std::size_t>(random.below(static_cast<int>(shapes.size())));
        world.add(random, shapes[which], position, speed);
    }
    return world;
}

World<2> square_of_half_spaces(Random& random, double speed) {
    static const Body<2> shapes[] = {body_of("gear:9"), body_of("star:5"), body_of("L")};
    return between_half_spaces<2>(shapes, 3, 3, random, speed);
}

World<3> cube_of_half_spaces(Random& random, double speed) {
    static const Body<3> shapes[] = {solid_of("box:0.7,0.7,0.7"), solid_of("L"), solid_of("ring")};
    return between_half_spaces<3>(shapes, 2, 2, random, speed);
}

}  // namespace

TEST_CASE("no gear leaves the box of gears_in_a_box, at any level and budget", "[containment]") {
    const auto scene = scenes::load_scene(scenes::scene_file("gears_in_a_box"));
    const auto setup = scenes::set_up<2>(scene);
    for (const Allowed& allowed : all_allowed) {
        scenes::RunOptions options;
        options.limits = scene.limits;
        options.limits.level = allowed.level;
        options.limits.node_tests = allowed.tests;
        options.settings = scenes::frame_settings(scene, options.limits);
        options.frames = scene.frames();
        const auto run = scenes::run(setup.bodies, options);
        int inside = 0;
        for (std::size_t i = 4; i < run.end.size(); ++i)
            inside += std::abs(run.end[i].position[0]) < 3 && std::abs(run.end[i].position[1]) < 2;
        INFO("level " << allowed.level << ", tests " << allowed.tests.value_or(999999));
        CHECK(inside == 12);
    }
}

namespace {

template <class MakeWorld>
void check_nobody_leaves(const MakeWorld& make, std::initializer_list<double> speeds, int frames) {
    for (int seed = 0; seed < (lodtest::sanitized ? 1 : 20); ++seed)
        for (const double speed : speeds)
            for (const Allowed& allowed : all_allowed) {
                Random random(static_cast<std::uint64_t>(600 + seed));
                INFO("seed " << seed << ", " << speed << " m/s, level " << allowed.level
                             << ", tests " << allowed.tests.value_or(999999));
                CHECK(outside(make(random, speed), allowed, frames) == 0);
            }
}

}  // namespace

TEST_CASE("nobody leaves a square of half-spaces", "[containment]") {
    check_nobody_leaves(square_of_half_spaces, {1.0, 8.0, 15.0}, 180);
}

TEST_CASE("nobody leaves a cube of half-spaces", "[containment]") {
    check_nobody_leaves(cube_of_half_spaces, {1.0, 6.0, 12.0}, 120);
}

TEST_CASE("nobody passes walls that have trees", "[containment]") {
    check_nobody_leaves(four_walls, {1.0, 8.0, 15.0}, 180);
}

TEST_CASE("nobody leaves a ring", "[containment]") {
    check_nobody_leaves(in_a_ring, {1.0, 8.0, 15.0}, 180);
}

TEST_CASE("nobody leaves a bowl with a lid", "[containment]") {
    check_nobody_leaves(in_a_bowl, {1.0, 8.0, 15.0}, 180);
}

TEST_CASE("nobody leaves a box of six plates", "[containment]") {
    check_nobody_leaves(six_plates, {1.0, 6.0, 12.0}, 120);
}
