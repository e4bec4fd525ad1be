#include "lodlab/measure/reference/box2d_reference.hpp"

#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "tests/catch.hpp"

using namespace lod2d;

namespace {

/// Single precision: some 30 roundings of 6e-8 between the pose and the velocity, no cancellation
/// beyond the size of the terms.
constexpr double single = 2e-6;

lod::Body<2> body_of(const Shape& shape, double mass, Point x, Point v, double angle = 0,
                     double spin = 0) {
    lod::Body<2> body;
    lod::set_mass<2>(body, mass,
                     lod::Inertia<2>::Constant(mass * shape.second_moment / shape.area));
    body.position = x;
    body.velocity = v;
    body.orientation = angle;
    body.spin[0] = spin;
    return body;
}

double energy(const std::vector<lod::Body<2>>& bodies) {
    return lod::kinetic_energy<2>(bodies);
}

double ring_area(std::span<const Point> ring) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const Point u = ring[i] - ring[0];
        const Point v = ring[i + 1] - ring[0];
        twice += u.x() * v.y() - u.y() * v.x();
    }
    return twice / 2;
}

}  // namespace

TEST_CASE("convex parts of at most 8 corners still make up the shape", "[box2d]") {
    for (const char* spec :
         {"box", "disc:100", "star:9", "gear:12", "ring:0.7", "spiral", "blob:3"}) {
        const Shape shape = generate(spec);
        for (const std::size_t most : {3u, 4u, 8u}) {
            const ConvexParts parts = with_at_most(convex_parts(shape.polygon), most);
            double area = 0;
            for (std::size_t i = 0; i < parts.count(); ++i) {
                const auto begin = static_cast<std::size_t>(parts.begin[i]);
                const auto count = static_cast<std::size_t>(parts.begin[i + 1]) - begin;
                CHECK(count >= 3);
                CHECK(count <= most);
                const double part = ring_area(std::span(parts.corners).subspan(begin, count));
                CHECK(part >= -1e-15);  // anticlockwise
                area += part;
            }
            INFO(spec << ", at most " << most);
            CHECK(area == Approx(shape.area).epsilon(1e-12));
        }
    }
}

TEST_CASE("Box2D agrees with the exact impact of two offset boxes", "[box2d]") {
    const Shape box = generate("box:1,1");
    const std::vector<lod::Body<2>> bodies{body_of(box, 1, {0, 0}, {2, 0}),
                                           body_of(box, 1, {1.1, 0.4}, {0, 0})};
    const Shape* const shapes[] = {&box, &box};
    const Box2dImpact impact = run_to_impact(bodies, shapes);
    REQUIRE(impact.happened);
    double j = 0;
    for (const Box2dContact& contact : impact.contacts) {
        CHECK((contact.normal - Point(1, 0)).norm() < 1e-6);
        j += contact.impulse;
    }
    CHECK(impact.contacts.size() == 2);  // the two ends of the faces' common part
    CHECK(j == Approx(50.0 / 31).epsilon(single));
    for (const auto& body : impact.after) CHECK(body.spin[0] == Approx(60.0 / 31).epsilon(single));
    CHECK(impact.after[0].velocity.x() == Approx(2 - 50.0 / 31).epsilon(single));
    CHECK(impact.after[1].velocity.x() == Approx(50.0 / 31).epsilon(single));
    CHECK(energy(impact.after) == Approx(2).epsilon(single));
    // A gap of 0.1 m at 2 m/s, less two skins of 0.01 units; at the next step's beginning.
    CHECK(impact.time > 0.05 - 0.02 / 16 / 2 - 1e-6);
    CHECK(impact.time < 0.05 - 0.02 / 16 / 2 + 2.0 / 960);
}

TEST_CASE("Box2D takes the smaller restitution and knows static bodies", "[box2d]") {
    const Shape box = generate("box:1,1");
    std::vector<lod::Body<2>> bodies{body_of(box, 1, {0, 0}, {0, 0}),
                                     body_of(box, 3, {0.2, 1.05}, {0, -1})};
    lod::make_static(bodies[0]);
    bodies[1].restitution = 0.25;
    const Shape* const shapes[] = {&box, &box};
    const Box2dImpact impact = run_to_impact(bodies, shapes);
    REQUIRE(impact.happened);
    CHECK(impact.after[0].velocity.isZero(0));
    // Flat on a face that reaches below the centre on both sides: it bounces without spin.
    CHECK(impact.after[1].velocity.y() == Approx(0.25).epsilon(1e-5));
    CHECK(std::abs(impact.after[1].spin[0]) < 1e-5);
}

TEST_CASE("Box2D and lodlab agree on a box whose corner falls on a half-space", "[box2d]") {
    // Case 4 of METHOD.md: a unit square comes down on a corner at 0.25 from its middle.
    const Shape box = generate("box:1,1");
    const double turn = std::atan2(1.0, 1.0) - std::asin(0.25 / std::sqrt(0.5));
    lod::Body<2> floor;
    lod::make_static(floor);
    floor.tree = std::make_shared<lod::SphereTree<2>>(lod::half_space<2>({0, 1}));
    for (const double down : {0.0, 0.7}) {  // and the same on a wall turned by it
        lod::Body<2> border = floor;
        border.orientation = down;
        const lod::Matrix<2> R = lod::Space<2>::rotation(down);
        lod::Body<2> square = body_of(box, 1, R * Point(0.3, 0.9), R * Point(0, -1), turn + down);
        square.tree = std::make_shared<lod::SphereTree<2>>(build_tree(box));
        const std::vector<lod::Body<2>> bodies{square, border};
        const Shape* const shapes[] = {&box, &box};
        const Box2dImpact impact = run_to_impact(bodies, shapes);
        REQUIRE(impact.happened);
        const Point velocity = R.transpose() * impact.after[0].velocity;
        CHECK(std::abs(velocity.y() - 0.454545454545) <= 1e-3);
        CHECK(std::abs(std::abs(impact.after[0].spin[0]) - 2.181818181818) <= 1e-3);
        std::vector<lod::Body<2>> ours = bodies;
        lod::FrameStorage<2> storage;
        for (int frame = 0; frame < 2000 && ours[0].spin[0] == 0; ++frame) {
            lod::Budget budget = lod::Budget::unlimited();
            lod::advance<2>(ours, {.time_step = 1.0 / 3840}, budget, storage);
        }
        CHECK(std::abs((R.transpose() * ours[0].velocity).y() - velocity.y()) <= 1e-3);
        CHECK(std::abs(ours[0].spin[0] - impact.after[0].spin[0]) <= 1e-3);
    }
}

TEST_CASE("bodies that miss each other run to the last step", "[box2d]") {
    const Shape star = generate("star:5");
    const std::vector<lod::Body<2>> bodies{body_of(star, 1, {0, 0}, {1, 0}),
                                           body_of(star, 1, {0, 3}, {-1, 0})};
    const Shape* const shapes[] = {&star, &star};
    Box2dSettings settings;
    settings.most_steps = 500;
    const Box2dImpact impact = run_to_impact(bodies, shapes, settings);
    CHECK_FALSE(impact.happened);
    CHECK(impact.contacts.empty());
    CHECK(impact.after[0].velocity.x() == Approx(1).epsilon(single));
}

TEST_CASE("a shape too fine for Box2D is refused with the mend", "[box2d]") {
    const Shape comb = generate("comb:500");  // prongs of 1 mm
    const std::vector<lod::Body<2>> bodies{body_of(comb, 1, {0, 0}, {1, 0}),
                                           body_of(comb, 1, {3, 0}, {0, 0})};
    const Shape* const shapes[] = {&comb, &comb};
    Box2dSettings coarse;
    coarse.units_per_metre = 1;
    CHECK_THROWS_AS(run_to_impact(bodies, shapes, coarse), lod::Error);
    CHECK_NOTHROW(run_to_impact(bodies, shapes));
}

TEST_CASE("from Box2D's own contact lodlab finds the same velocities", "[box2d]") {
    // Concave shapes, corner on edge: one contact, no freedom left in how impulses are shared.
    struct Scene {
        const char* a;
        const char* b;
        double angle;
    };
    int compared = 0;
    for (const Scene& scene : {Scene{"gear:9", "star:5", 0.3},
                               {"L", "star:7", 1.2},
                               {"star:5", "cross", 0.4},
                               {"arrow", "blob:3", 2.1}}) {
        const Shape a = generate(scene.a);
        const Shape b = generate(scene.b);
        const std::vector<lod::Body<2>> bodies{body_of(a, 1, {-1, 0}, {1.5, 0.2}, scene.angle, 0.8),
                                               body_of(b, 2, {0.6, 0.15}, {-1, 0}, 0.2, -1.1)};
        const Shape* const shapes[] = {&a, &b};
        const Box2dImpact impact = run_to_impact(bodies, shapes);
        REQUIRE(impact.happened);
        INFO(scene.a << " and " << scene.b << ": " << impact.contacts.size() << " contacts");
        CHECK(energy(impact.after) == Approx(energy(impact.before)).epsilon(1e-5));
        if (impact.contacts.size() != 1) continue;
        ++compared;
        const Box2dContact& touch = impact.contacts[0];
        auto after = impact.before;
        const lod::Contact<2> contact{touch.point, touch.normal, 0};
        const double j = lod::single_impulse(after[0], after[1], contact);
        lod::apply_impulse(after[0], after[1], contact, j);
        // Box2D puts the point midway between the skins, to a slop; positions of 16 units are
        // rounded to 1e-6 units, arms of 8 units by as much: relative 1e-6, and 10 such terms.
        CHECK(touch.impulse == Approx(j).epsilon(1e-5));
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK((after[i].velocity - impact.after[i].velocity).norm() < 3e-5);
            CHECK(std::abs(after[i].spin[0] - impact.after[i].spin[0]) < 1e-4);
        }
    }
    CHECK(compared >= 2);
}

namespace {

/// A unit box between two walls with 1 m to go on either side, at 2 m/s.
struct Corridor {
    Shape box = generate("box:1,1");
    Shape wall = generate("box:1,3");
    std::vector<lod::Body<2>> bodies{body_of(box, 1, {0, 0}, {2, 0}),
                                     body_of(wall, 1, {-2, 0}, {0, 0}),
                                     body_of(wall, 1, {2, 0}, {0, 0})};
    const Shape* shapes[3] = {&box, &wall, &wall};

    Corridor() {
        lod::make_static(bodies[1]);
        lod::make_static(bodies[2]);
    }
};

}  // namespace

TEST_CASE("a run in Box2D passes its frames at their times and lists every impact", "[box2d]") {
    const Corridor corridor;
    const Box2dRun run = run_box2d(corridor.bodies, corridor.shapes, 960, 1.0 / 240);
    REQUIRE(run.frames.size() == 961);
    // Skins of 0.01 units a metre/16 each shorten the way; a step is 2/960 m long and may start
    // an impact by that much late.
    const double skins = 0.02 / 16;
    const double step = 2.0 / 960;
    REQUIRE(run.impacts.size() == 4);  // after 1 m, then every 2 m
    for (std::size_t k = 0; k < run.impacts.size(); ++k) {
        const Box2dImpact& impact = run.impacts[k];
        const double sign = k % 2 == 0 ? 1 : -1;
        const double way = 1 + 2 * static_cast<double>(k);
        INFO("impact " << k << " at " << impact.time << " s");
        CHECK(2 * impact.time <= way + (step - skins) * static_cast<double>(k + 1) + 1e-5);
        CHECK(2 * impact.time >= way - 2 * (skins + step) * static_cast<double>(k + 1));
        CHECK(impact.before[0].velocity.x() == Approx(2 * sign).epsilon(single));
        CHECK(impact.after[0].velocity.x() == Approx(-2 * sign).epsilon(single));
        CHECK(impact.after[0].position == impact.before[0].position);
        for (const Box2dContact& contact : impact.contacts) {
            CHECK(contact.a == 0);
            CHECK(contact.b == (k % 2 == 0 ? 2 : 1));
            CHECK(contact.normal.x() == Approx(sign).epsilon(single));
        }
    }
    // Before the first impact the box is where free motion brings it.
    CHECK(run.frames[0][0].position.x() == 0);
    CHECK(run.frames[40][0].position.x() == Approx(2 * 40 / 240.0).epsilon(1e-5));
    CHECK(run.frames.back()[1].position == corridor.bodies[1].position);
}

TEST_CASE("frames longer than a step of Box2D are cut into equal steps", "[box2d]") {
    const Corridor corridor;
    Box2dSettings settings;
    settings.time_step = 1.0 / 500;  // 0.01 s are 5 of them, 0.011 s are 6 shorter ones
    for (const double frame : {0.01, 0.011}) {
        const Box2dRun run = run_box2d(corridor.bodies, corridor.shapes, 30, frame, settings);
        CHECK(run.frame_step == frame);
        CHECK(run.frames[20][0].position.x() == Approx(2 * 20 * frame).epsilon(1e-5));
    }
}

TEST_CASE("a body too fast for a step of Box2D is refused with the mend", "[box2d]") {
    Corridor corridor;
    corridor.bodies[0].velocity = {200, 0};  // 3.3 units a step; Box2D would move 2
    CHECK_THROWS_WITH(run_box2d(corridor.bodies, corridor.shapes, 1, 1.0 / 240),
                      lodtest::contains("shorten its time step"));
    corridor.bodies[0].velocity = {0, 0};
    corridor.bodies[0].spin[0] = 2000;
    CHECK_THROWS_AS(run_box2d(corridor.bodies, corridor.shapes, 1, 1.0 / 240), lod::Error);
}

TEST_CASE("a corner that two convex pieces share touches once", "[box2d]") {
    // The tip of the star points at the box; its convex pieces meet along lines through tips.
    const Shape star = generate("star:5");
    const Shape wall = generate("box:1,3");
    for (const double angle : {0.0, 0.3, 0.7, 1.1}) {
        std::vector<lod::Body<2>> bodies{body_of(star, 1, {0, 0.1}, {1, 0}, angle, 0.1),
                                         body_of(wall, 1, {2, 0}, {0, 0})};
        const Shape* const shapes[] = {&star, &wall};
        const Box2dImpact impact = run_to_impact(bodies, shapes);
        REQUIRE(impact.happened);
        CHECK(impact.contacts.size() == 1);
    }
}
