#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/viz/draw/draw_contacts.hpp"
#include "lodlab/viz/draw/draw_projection.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"
#include "lodlab/viz/draw/draw_tree.hpp"
#include "lodlab/viz/draw/draw_turntable.hpp"
#include "lodlab/viz/draw/motion/draw_motion.hpp"
#include "lodlab/viz/figure/check.hpp"
#include "tests/catch.hpp"

using namespace viz;
using Vector3 = lod::Vector<3>;

namespace {

/// A cube of side 1 with the density 1; octrees are quick to build.
Actor<3> cube(double x, int depth) {
    static const lod3d::Solid solid = lod3d::generate("box:1,1,1");
    Actor<3> actor{visual_of(solid), {}};
    lod::set_mass<3>(actor.body, solid.volume, solid.second_moment);
    actor.body.tree = std::make_shared<const lod::SphereTree<3>>(
        lod3d::build_tree(solid, {.builder = lod3d::Builder::octree, .depth = depth}));
    actor.body.position = {x, 0, 0};
    return actor;
}

/// Two balls of one node each, meeting head-on (m 1, v 2 meets m 3, v -1: j = 4.5).
Run<3> head_on_in_space(int frames) {
    const auto body = [](double mass, double x, double speed) {
        lod::Body<3> ball;
        lod::set_mass<3>(ball, mass, lod::Inertia<3>::Identity());
        ball.tree =
            std::make_shared<lod::SphereTree<3>>(lod::single_sphere<3>({Vector3::Zero(), 0.5}));
        ball.position = {x, 0, 0};
        ball.velocity = {speed, 0, 0};
        return ball;
    };
    Run<3> run;
    run.name = "exact";
    run.time_step = 1.0 / 64;
    run.visuals = {{"A", {}}, {"B", {}}};
    std::vector<lod::Body<3>> bodies{body(1, -1, 2), body(3, 1, -1)};
    lod::FrameSettings settings;
    settings.time_step = run.time_step;
    lod::FrameStorage<3> storage;
    for (int i = 0; i < frames; ++i) {
        const std::vector<lod::Body<3>> before = bodies;
        lod::Budget budget = lod::Budget::unlimited();
        add_instant<3>(run, before, lod::advance<3>(bodies, settings, budget, storage));
    }
    add_instant<3>(run, bodies, {});
    return run;
}

int balls_of(const Panel& panel, Role role) {
    REQUIRE(panel.space);
    return static_cast<int>(std::count_if(panel.space->balls.begin(), panel.space->balls.end(),
                                          [&](const Ball& b) { return b.style.role == role; }));
}

template <class Kind>
const Kind* first_of(const Panel& panel, Role role) {
    for (const Mark& mark : panel.marks)
        if (const auto* held = std::get_if<Kind>(&mark))
            if (held->style.role == role) return held;
    return nullptr;
}

}  // namespace

TEST_CASE("a sphere tree's montage holds each level's spheres and the mesh", "[space][drawings]") {
    const Actor<3> actor = cube(0, 2);
    const Figure figure = tree_levels(actor);
    REQUIRE(figure.panels.size() == 3);
    for (int level = 0; level < 3; ++level) {
        const Panel& panel = figure.panels[static_cast<std::size_t>(level)];
        CHECK(balls_of(panel, Role::level_node) ==
              static_cast<int>(actor.body.tree->level_nodes(level).size()));
        REQUIRE(panel.space->facets.size() == 1);
        CHECK(panel.space->facets[0].surface == actor.visual.outline);  // shared, not copied
        CHECK(panel.space->camera.eye == figure.panels[0].space->camera.eye);
    }
    CHECK_THAT(figure.title, lodtest::contains("spheres"));
    CHECK_THAT(figure.alt, lodtest::contains("Level 1: 8 spheres"));
    CHECK_NOTHROW(check_figure(figure));
}

TEST_CASE("a traversal in space shows the fronts' nodes and the verdict", "[space][drawings]") {
    const Actor<3> a = cube(0, 2);
    const Actor<3> b = cube(1.2, 2);
    const auto fronts = lod::traverse_levels(a.body, b.body);
    const Figure figure = traversal(a, b, fronts);
    const TestedNodes tested = tested_nodes(a.body, b.body, fronts, 1);
    CHECK(balls_of(figure.panels[1], Role::node) ==
          static_cast<int>(tested.a.size() + tested.b.size()));
    CHECK(balls_of(figure.panels[0], Role::meeting_node) == 2);
    CHECK_THAT(figure.alt, lodtest::contains("The sphere trees of box:1,1,1 A and box:1,1,1 B"));
    CHECK_THAT(figure.alt, lodtest::contains("At level 0: 1 node test, 1 overlapping pair"));
}

TEST_CASE("contacts of two cubes stand where they touch on the panel", "[space][drawings]") {
    const Actor<3> a = cube(0, 1);
    const Actor<3> b = cube(1, 1);
    const auto fronts = lod::traverse_levels(a.body, b.body);
    const Figure figure = contacts_by_level(a, b, fronts);
    const auto contacts =
        lod::contacts_of_front<3>(a.body, b.body, fronts[0], {lod::ContactModel::centre_line});
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].point.isApprox(Vector3(0.5, 0, 0)));
    const Dot* dot = first_of<Dot>(figure.panels[0], Role::contact);
    REQUIRE(dot);
    const Camera& camera = figure.panels[0].space->camera;
    CHECK(dot->at == project(camera, contacts[0].point));
    CHECK(dot->depth == depth_of(camera, contacts[0].point));
    const Arrow* normal = first_of<Arrow>(figure.panels[0], Role::normal);
    REQUIRE(normal);
    CHECK(normal->tip.x > normal->tail.x);  // A stands on the left of B
}

TEST_CASE("the strip of a collision in space tells impulse, times and ends", "[space][drawings]") {
    const Run<3> run = head_on_in_space(64);
    const Figure figure = strips<3>({run});
    REQUIRE(figure.panels.size() == 3);
    CHECK(balls_of(figure.panels[1], Role::true_collision) == 2);
    const Arrow* impulse = first_of<Arrow>(figure.panels[1], Role::impulse);
    REQUIRE(impulse);
    CHECK(impulse->label == "*j* = 4.5\u00A0N s");
    CHECK_THAT(figure.caption, lodtest::contains("Bold spheres"));
    CHECK_THAT(figure.alt, lodtest::contains("with 1 contact"));
    for (const Panel& panel : figure.panels) CHECK(panel.view.low == figure.panels[0].view.low);
    CHECK_THROWS_AS(strips<3>({Run<3>{}}), lod::Error);
}

TEST_CASE("bodies turn the shorter way between two instants", "[space][drawings]") {
    Run<3> run = head_on_in_space(2);
    const auto about_z = [](double angle) {
        return lod::Space<3>::turned(lod::Quaternion::Identity(), angle * Vector3::UnitZ());
    };
    run.instants[0].bodies[0].orientation = about_z(0.1);
    run.instants[1].bodies[0].orientation =
        lod::Quaternion::of_coeffs(-about_z(0.3).coeffs());  // the same turn
    const auto middle = bodies_at(run, 0.5 * run.time_step)[0].orientation;
    CHECK(std::abs(middle.dot(about_z(0.2))) > 1 - 1e-15);
}

TEST_CASE("the film of a simulation in space plots momentum along three axes",
          "[space][drawings]") {
    const Run<3> run = head_on_in_space(32);
    const Figure figure = simulation_picture(run, 0.25);
    REQUIRE(figure.panels.size() == 3);
    int curves = 0;
    for (const Mark& mark : figure.panels[2].marks)
        if (const auto* line = std::get_if<Polyline>(&mark))
            curves += line->style.role == Role::curve ? 1 : 0;
    CHECK(curves == 3);
    CHECK(frame_count(impact_motion<3>({run})) > 30);
}

TEST_CASE("a turntable passes every level and ends where it begins", "[space][drawings]") {
    const Actor<3> actor = cube(0, 2);
    const Animation film =
        turntable(actor, {}, {.frames_per_second = 10, .seconds_per_level = 2, .title = {}});
    REQUIRE(frame_count(film) == 60);
    const Figure first = film.shots.front().draw();
    const Figure last = film.shots.back().draw();
    CHECK(first.numbers[0].value == "0");
    CHECK(film.shots[30].draw().numbers[0].value == "1");
    CHECK(last.numbers[0].value == "0");  // the first level has all but appeared again
    // The eye is one step of the whole turn away from where it began.
    const Vector3 from = vector3(first.panels[0].space->camera.eye);
    const Vector3 to = vector3(last.panels[0].space->camera.eye);
    const Vector3 next = vector3(film.shots[1].draw().panels[0].space->camera.eye);
    CHECK((from - to).norm() == Approx((from - next).norm()).epsilon(1e-6));
    for (const Shot& shot : film.shots) {
        const Figure figure = shot.draw();
        CHECK(figure.panels[0].view.high.x == Approx(first.panels[0].view.high.x));
    }
    CHECK_THROWS_AS(turntable(actor, {}, {.seconds_per_level = 0, .title = {}}), lod::Error);
}

TEST_CASE("a collision is projected so that its normal lies in the picture", "[space][drawings]") {
    const Actor<3> a = cube(0, 1);
    Actor<3> b = cube(0, 1);
    b.body.position = {0.6, 0, 0.8};  // 1 m away, aslant
    lod::FrameStorage<3> storage;
    lod::FrameSettings settings;
    settings.contact_model = lod::ContactModel::centre_line;
    settings.deepest_level = 0;
    lod::Budget budget = lod::Budget::unlimited();
    const std::vector<lod::Body<3>> bodies{a.body, b.body};
    const lod::FrameRecord<3>& record = lod::detect<3>(bodies, settings, budget, storage);
    const ProjectionPlane plane = projection_plane(contacts_of(record));
    CHECK(plane.along.isApprox(Vector3(0.6, 0, 0.8)));
    CHECK(plane.up.isApprox(Vector3::UnitY()));

    const Figure figure = projected_collision(a, b, record, record.pairs[0]);
    CHECK_FALSE(figure.panels[0].space);
    std::vector<Disc> discs;
    for (const Mark& mark : figure.panels[0].marks)
        if (const auto* disc = std::get_if<Disc>(&mark)) discs.push_back(*disc);
    REQUIRE(discs.size() == 2);
    // Circles keep the spheres' radii, and their centres are a metre apart, along the normal.
    CHECK(discs[0].radius == Approx(a.body.tree->sphere(0).radius));
    CHECK(discs[1].centre.x - discs[0].centre.x == Approx(1));
    CHECK(discs[1].centre.y == Approx(discs[0].centre.y).margin(1e-12));
    const Arrow* normal = first_of<Arrow>(figure.panels[0], Role::normal);
    REQUIRE(normal);
    CHECK(normal->tip.y == Approx(normal->tail.y).margin(1e-12));
    CHECK_THAT(figure.alt, lodtest::contains("2 circles"));
    CHECK_THROWS_AS(projected_collision(a, b, record, {}), lod::Error);
}

TEST_CASE("the outline of a projected cube is the hexagon or square that it shows",
          "[space][drawings]") {
    const Actor<3> actor = cube(0, 0);
    const auto area_of = [](const std::vector<Ring>& rings) {
        double doubled = 0;
        for (const Ring& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point p = ring[i];
                const Point q = ring[(i + 1) % ring.size()];
                doubled += p.x * q.y - q.x * p.y;
            }
        return doubled / 2;
    };
    const ProjectionPlane front;
    CHECK(area_of(projected_outline(*actor.visual.outline, actor.body, front)) ==
          Approx(1).epsilon(1e-6));
    // Seen along a diagonal a unit cube shows a hexagon of area sqrt 3.
    const Vector3 diagonal = Vector3(1, 1, 1).normalized();
    const Vector3 along = Vector3(1, -1, 0).normalized();
    const ProjectionPlane slanted{along, diagonal.cross(along)};
    const std::vector<Ring> hexagon = projected_outline(*actor.visual.outline, actor.body, slanted);
    REQUIRE(hexagon.size() == 1);
    CHECK(hexagon[0].size() == 6);
    CHECK(area_of(hexagon) == Approx(std::sqrt(3.0)).epsilon(1e-6));
}
