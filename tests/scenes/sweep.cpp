// Fast bodies pass through nothing where they are swept.
#include "lodlab/core/frame/sweep.hpp"

#include <array>

#include "lodlab/core/frame/frame.hpp"
#include "lodlab/core/frame/integrate.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/shapes.hpp"
#include "tests/catch.hpp"

namespace {

constexpr double step = 1.0 / 240;

/// A body of a named shape and its tree, mass 1 kg.
template <int Dim>
lod::Body<Dim> made(const std::string& name, int depth, std::optional<double> size = {}) {
    using Shapes = scenes::Shapes<Dim>;
    const auto shape = Shapes::named(name, {.size = size});
    lod::Body<Dim> body;
    scenes::TreeChoice choice;
    choice.depth = depth;
    if (Dim == 3) choice.builder = "octree";
    body.tree = std::make_shared<const lod::SphereTree<Dim>>(
        scenes::tree_of<Dim>(shape, Shapes::settings(choice), {}));
    body.exact = Shapes::exact_of(shape);
    const double mass = Shapes::measure(shape);
    lod::set_mass<Dim>(body, 1, Shapes::second_moment(shape) / mass);
    return body;
}

/// A ball of 2 cm and a wall of 1 cm across its way, built once.
template <int Dim>
std::array<lod::Body<Dim>, 2> ball_and_wall() {
    static const std::array<lod::Body<Dim>, 2> bodies = [] {
        auto ball = made<Dim>(Dim == 2 ? "disc:32" : "ball", 2, 0.02);
        auto wall = made<Dim>(Dim == 2 ? "box:0.01,1" : "box:0.01,1,1", 3);
        lod::make_static(wall);
        return std::array{std::move(ball), std::move(wall)};
    }();
    return bodies;
}

/// How the ball leaves when it flies at the wall from a metre away: its speed away from it. `phase`
/// of 8 moves it back by that part of a frame's way.
template <int Dim>
double speed_after(double speed, int phase, const lod::FrameSettings& settings) {
    auto bodies = ball_and_wall<Dim>();
    bodies[0].velocity = speed * lod::Vector<Dim>::Unit(0);
    bodies[0].position = -(1 + speed * step * phase / 8) * lod::Vector<Dim>::Unit(0);
    lod::FrameStorage<Dim> storage;
    const int frames = static_cast<int>(std::ceil(1.2 / (speed * step))) + 2;
    for (int frame = 0; frame < frames; ++frame) {
        lod::Budget budget = lod::Budget::unlimited();
        lod::advance<Dim>(bodies, settings, budget, storage);
    }
    return -bodies[0].velocity[0];
}

/// At 1,000 m/s. Faces at x = -0.495 and 0.495, radius 0.01: 0.97 m from bounce to bounce.
std::array<lod::Body<2>, 3> ball_between_walls() {
    const auto [ball, wall] = ball_and_wall<2>();
    std::array<lod::Body<2>, 3> bodies{ball, wall, wall};
    bodies[1].position = {-0.5, 0};
    bodies[2].position = {0.5, 0};
    bodies[0].velocity = {1000, 0};
    return bodies;
}

lod::FrameSettings swept(int level) {
    lod::FrameSettings settings;
    settings.time_step = step;
    settings.deepest_level = level;
    settings.sweep.on = true;
    settings.sweep.deepest_level = level;
    return settings;
}

lod::FrameSettings swept_exactly() {
    lod::FrameSettings settings = swept(1000);
    settings.finest.level = lod::Finest::backtrack;
    settings.sweep.exact = true;
    return settings;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("no ball of 2 cm passes a wall of 1 cm, at any level, speed or phase", "",
                       ((int Dim), Dim), 2, 3) {
    for (const double speed : {1.0, 5.0, 8.0, 20.0, 60.0, 200.0, 1000.0})
        for (int phase = 0; phase < 8; ++phase) {
            CAPTURE(speed, phase);
            // A ball of corners and faces may take a little of it as spin.
            for (const int level : {0, 1, 2, 1000}) {
                CAPTURE(level);
                CHECK(speed_after<Dim>(speed, phase, swept(level)) > 0.8 * speed);
            }
            CHECK(speed_after<Dim>(speed, phase, swept_exactly()) > 0.8 * speed);
        }
}

TEST_CASE("without sweeping the same ball passes the wall") {
    lod::FrameSettings settings = swept(1000);
    settings.sweep.on = false;
    int passed = 0;
    for (int phase = 0; phase < 8; ++phase) passed += speed_after<2>(60, phase, settings) < 0;
    CHECK(passed >= 4);
}

TEST_CASE("slow bodies move to the bit as without sweeping") {
    auto swept_bodies = ball_and_wall<2>();
    swept_bodies[0].velocity = {2, 0.3};
    swept_bodies[0].spin[0] = 1;
    swept_bodies[0].position = {-0.1, 0};
    auto others = swept_bodies;
    std::vector<lod::SweptImpact<2>> found;
    lod::Sweeper<2> sweeper;
    sweeper.advance(swept_bodies, step, {.on = true}, {}, found);
    lod::integrate<2>(others, step);
    CHECK(found.empty());
    CHECK(swept_bodies[0].position == others[0].position);
    CHECK(swept_bodies[0].orientation == others[0].orientation);
}

TEST_CASE("a fast ball between two walls bounces as often as its way is long") {
    std::array<lod::Body<2>, 3> bodies = ball_between_walls();
    std::vector<lod::SweptImpact<2>> found;
    lod::Sweeper<2> sweeper;
    sweeper.advance(bodies, step, {.on = true, .exact = true}, {}, found);
    // 4.1667 m of way: 0.485 m to the first wall, then 3.796 rooms more.
    REQUIRE(found.size() == 4);
    CHECK(found[0].time == Approx(0.485e-3).epsilon(1e-4));
    CHECK(found[3].time == Approx((0.485 + 3 * 0.97) * 1e-3).epsilon(1e-4));
    const double left = 1000 * step - 0.485 - 3 * 0.97;
    CHECK(bodies[0].position.x() == Approx(-0.485 + left).epsilon(1e-6));
    CHECK(bodies[0].velocity.x() == Approx(1000));
}

TEST_CASE("a body with too many impacts for one frame waits, and is not lost") {
    std::array<lod::Body<2>, 3> bodies = ball_between_walls();
    std::vector<lod::SweptImpact<2>> found;
    lod::Sweeper<2> sweeper;
    for (int frame = 0; frame < 100; ++frame) {
        sweeper.advance(bodies, step, {.on = true, .exact = true, .most_impacts = 2}, {}, found);
        CHECK(found.size() <= 2);
        CHECK(std::abs(bodies[0].position.x()) < 0.486);
        CHECK(lod::kinetic_energy<2>(bodies) == Approx(0.5e6).epsilon(1e-9));
    }
}

TEST_CASE("two fast bodies that meet exchange their speeds where they meet") {
    const auto [ball, wall] = ball_and_wall<2>();
    std::array<lod::Body<2>, 2> bodies{ball, ball};
    bodies[0].position = {-1, 0};
    bodies[1].position = {1, 0};
    bodies[0].velocity = {300, 0};
    bodies[1].velocity = {-200, 0};
    std::vector<lod::SweptImpact<2>> found;
    lod::Sweeper<2> sweeper;
    sweeper.advance(bodies, step, {.on = true, .exact = true}, {}, found);
    sweeper.advance(bodies, step, {.on = true, .exact = true}, {}, found);
    CHECK(bodies[0].velocity.x() == Approx(-200).epsilon(1e-9));
    CHECK(bodies[1].velocity.x() == Approx(300).epsilon(1e-9));
    CHECK(bodies[0].position.x() < bodies[1].position.x());
}

TEST_CASE("a body is as thick as its hull, and one with a hollow as its wall") {
    CHECK(lod::thickness(*made<2>("box:0.4,3", 2).tree) == Approx(0.4).epsilon(1e-6));
    CHECK(lod::thickness(*made<2>("disc", 2).tree) == Approx(1).epsilon(0.03));
    CHECK(lod::thickness(*made<2>("ring", 4).tree) < 0.5);
    CHECK(std::isinf(lod::thickness(lod::half_space<2>({0, 1}))));
}

TEST_CASE("a body that is too fast to be seen is warned of by its name, with its speed limit") {
    scenes::Scene scene;
    scene.bodies.resize(2);
    scene.bodies[0].name = "pea";
    scene.bodies[1].name = "wall";
    auto bodies = ball_and_wall<2>();
    bodies[0].velocity = {8, 0};
    bodies[0].position = {-1, 0};
    scenes::RunOptions options;
    options.settings.time_step = step;
    const auto warnings = [&] {
        const std::vector<lod::Body<2>> both(bodies.begin(), bodies.end());
        return scenes::speed_warnings<2>(scene, both, scenes::run<2>(both, options));
    };
    REQUIRE(warnings().size() == 1);
    CHECK(warnings()[0].starts_with("body pea moves up to 0.0333 m a frame and is 0.0199 m thick"));
    CHECK(warnings()[0].ends_with("stay below 4.78 m/s"));
    options.settings.sweep.on = true;
    CHECK(warnings().empty());
    options.settings.sweep.on = false;
    bodies[0].velocity = {4, 0};
    CHECK(warnings().empty());
}

namespace {

/// One swept frame of a hundredth of a second; the impacts of it.
std::vector<lod::SweptImpact<2>> swept_frame(std::span<lod::Body<2>> bodies, bool exact) {
    std::vector<lod::SweptImpact<2>> found;
    lod::Sweeper<2> sweeper;
    sweeper.advance(bodies, 0.01, {.on = true, .exact = exact}, {}, found);
    return found;
}

}  // namespace

TEST_CASE("every fast body at one wall bounces, not the first alone") {
    const auto [ball, wall] = ball_and_wall<2>();
    for (const bool exact : {false, true}) {
        std::array<lod::Body<2>, 4> bodies{ball, wall, ball, ball};
        for (const std::size_t i : {0, 2, 3}) {
            bodies[i].position = {-3 - 0.1 * static_cast<double>(i), 0.1 * static_cast<double>(i)};
            bodies[i].velocity = {500, 0};
        }
        CHECK(swept_frame(bodies, exact).size() >= 3);
        for (const std::size_t i : {0, 2, 3}) {
            CHECK(bodies[i].position.x() < 0);
            CHECK(bodies[i].velocity.x() < 0);
        }
    }
}

TEST_CASE("a body that digs in with another corner while the first leaves does not pass") {
    const auto wall = ball_and_wall<2>()[1];
    const auto box = made<2>("box:0.1,0.1", 3);
    for (int turn = 0; turn < 36; ++turn)
        for (const double spin : {0.0, 100.0, -300.0})
            for (const bool exact : {false, true}) {
                CAPTURE(turn, spin, exact);
                std::array<lod::Body<2>, 2> bodies{box, wall};
                bodies[0].position = {-3.3, 0};
                bodies[0].velocity = {500, 0};
                bodies[0].spin[0] = spin;
                bodies[0].orientation = turn * 0.1745;
                swept_frame(bodies, exact);
                CHECK(bodies[0].position.x() < 0);
                CHECK(lod::kinetic_energy<2>(bodies) ==
                      Approx(125000 + spin * spin / 1200).epsilon(1e-9));
            }
}

TEST_CASE("what touches at the beginning passes on the blow and does not give way") {
    // Balls in a row up to a wall, all touching; another flies at them.
    const auto [ball, wall] = ball_and_wall<2>();
    for (const bool exact : {false, true}) {
        std::array<lod::Body<2>, 5> bodies{ball, ball, ball, wall, ball};
        const double radius = 0.01 * std::cos(3.14159265358979 / 32);  // to a face of the polygon
        bodies[3].position = {1, 0};
        for (const std::size_t i : {0, 1, 2})
            bodies[i].position = {0.995 - (5 - 2 * static_cast<double>(i)) * radius, 0};
        bodies[4].position = {-1, 0};
        bodies[4].velocity = {400, 0};
        swept_frame(bodies, exact);
        for (const std::size_t i : {0, 1, 2, 4}) CHECK(bodies[i].position.x() < 1);
    }
}

TEST_CASE("a body that a floor throws back meets the wall beyond it") {
    const auto [ball, wall] = ball_and_wall<2>();
    lod::Body<2> floor;
    floor.tree = std::make_shared<const lod::SphereTree<2>>(lod::half_space<2>({0, 1}));
    lod::make_static(floor);
    for (const bool exact : {false, true}) {
        std::array<lod::Body<2>, 3> bodies{ball, floor, wall};
        bodies[0].position = {-2, 0.1};
        bodies[0].velocity = {400, -40};
        swept_frame(bodies, exact);  // down at x = -1.1, up to the wall at y = 0.11
        CHECK(bodies[0].position.x() < 0);
        CHECK(bodies[0].position.y() > 0);
    }
}

TEST_CASE("a body that waits is met where it waits") {
    auto bodies = ball_between_walls();
    std::array<lod::Body<2>, 4> all{bodies[0], bodies[1], bodies[2], bodies[0]};
    all[3].position = {0.3, 0};
    all[3].velocity = {-900, 0};
    for (const std::size_t i : {0, 3}) all[i].orientation = 3.14159265358979 / 32;  // faces ahead
    std::vector<lod::SweptImpact<2>> found;
    lod::Sweeper<2> sweeper;
    for (const bool exact : {false, true}) {
        auto now = all;
        sweeper.advance(now, step, {.on = true, .exact = exact, .most_impacts = 3}, {}, found);
        CHECK(now[0].position.x() < now[3].position.x());
        CHECK(std::abs(now[0].position.x()) < 0.49);
        CHECK(std::abs(now[3].position.x()) < 0.49);
        std::vector<int> impacts(4, 0);
        for (const auto& met : found) {
            ++impacts[static_cast<std::size_t>(met.a)];
            ++impacts[static_cast<std::size_t>(met.b)];
        }
        CHECK(std::max(impacts[0], impacts[3]) >= 3);
    }
}
