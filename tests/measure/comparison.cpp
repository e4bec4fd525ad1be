#include "lodlab/measure/comparison.hpp"

#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/outline.hpp"
#include "tests/catch.hpp"

using namespace measure;

namespace {

/// Bodies of one kind.
struct Scene {
    explicit Scene(const char* spec, int depth = 3) : shape(lod2d::generate(spec)) {
        lod2d::TreeSettings settings;
        settings.depth = depth;
        tree = std::make_shared<lod::SphereTree<2>>(lod2d::build_tree(shape, settings));
        outline = std::make_shared<lod2d::ExactOutline>(shape);
        options.settings.time_step = 1.0 / 240;
        options.settings.contact_model = lod::ContactModel::node_normal;
        options.frames = 240;
    }

    void add(lod::Vector<2> position, lod::Vector<2> velocity) {
        lod::Body<2> body;
        lod::set_mass<2>(body, 1, lod::Inertia<2>::Constant(shape.second_moment / shape.area));
        body.position = position;
        body.velocity = velocity;
        body.tree = tree;
        body.exact = outline;
        bodies.push_back(body);
        shapes.push_back(&shape);
    }

    lod2d::Shape shape;
    std::shared_ptr<const lod::SphereTree<2>> tree;
    std::shared_ptr<const lod2d::ExactOutline> outline;
    std::vector<lod::Body<2>> bodies;
    std::vector<const lod2d::Shape*> shapes;
    ComparisonOptions options;
};

}  // namespace

TEST_CASE("a comparison holds every level against the exact impact and Box2D", "[measure]") {
    Scene scene("box:1,1");
    scene.add({-1, 0}, {2, 0});
    scene.add({1, 0.4}, {0, 0});
    double last = 0;
    scene.options.progress = [&](double share) {
        CHECK(share >= last);
        last = share;
    };
    const Comparison comparison = compare(scene.bodies, scene.shapes, scene.options);
    CHECK(last == Approx(1));
    REQUIRE(comparison.levels.size() == 4);
    REQUIRE(comparison.first_impacts.size() == 1);
    const FirstImpact& impact = comparison.first_impacts[0];
    REQUIRE(impact.exact);
    REQUIRE(impact.box2d);
    // METHOD.md, case 6.
    CHECK(impact.exact->after[1].spin[0] == Approx(60.0 / 31).epsilon(1e-6));
    CHECK(impact_error(*impact.exact, *impact.box2d).impulse < 1e-5);
    double gap = 2;
    for (const auto& level : impact.levels) {
        REQUIRE(level);
        CHECK(level->gap < gap);  // every level comes nearer
        gap = level->gap;
    }
    // The exact run differs from Box2D's by a skin and the motion of a frame; the roots do not.
    CHECK(comparison.exact.perceived.collisions.size() == 1);
    CHECK(comparison.exact.perceived.total < 0.2);
    CHECK(comparison.levels[0].perceived.total > 5);
    CHECK(comparison.exact.collisions[0].time == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("what only coarse levels take for a collision comes out of nothing", "[measure]") {
    Scene scene("box:1,1", 4);
    scene.add({-1, 0}, {2, 0});
    scene.add({1, 1.2}, {0, 0});  // passes 0.2 m below; the roots' circles overlap
    const Comparison comparison = compare(scene.bodies, scene.shapes, scene.options);
    CHECK(comparison.box2d_collisions.empty());
    REQUIRE(comparison.first_impacts.size() == 1);
    const FirstImpact& impact = comparison.first_impacts[0];
    CHECK_FALSE(impact.exact);
    CHECK_FALSE(impact.box2d);
    CHECK(impact.levels.front());
    CHECK_FALSE(impact.levels.back());
    CHECK(comparison.levels.front().perceived.extra.size() == 1);
    CHECK(comparison.levels.back().perceived.total == 0);
    CHECK(comparison.exact.perceived.total == 0);
}

TEST_CASE("two bodies count as meeting first only before they met others", "[measure]") {
    Scene scene("box:1,1", 1);
    scene.add({-2, 0}, {2, 0});
    scene.add({0, 0}, {0, 0});
    scene.add({1.5, 0}, {0, 0});  // pushed by the second one a quarter of a second later
    const Comparison comparison = compare(scene.bodies, scene.shapes, scene.options);
    CHECK(comparison.box2d_collisions.size() == 2);
    REQUIRE(comparison.first_impacts.size() == 1);
    CHECK(comparison.first_impacts[0].a == 0);
    CHECK(comparison.first_impacts[0].b == 1);
    CHECK(comparison.exact.perceived.collisions.size() == 2);
    CHECK(comparison.exact.perceived.missing.empty());
}

TEST_CASE("the scale of Box2D is raised until it holds the shapes", "[measure]") {
    Scene scene("comb:120", 0);
    scene.add({0, 0}, {1, 0});
    scene.options.frames = 2;
    scene.options.box2d.units_per_metre = 0.125;
    const Comparison comparison = compare(scene.bodies, scene.shapes, scene.options);
    CHECK(comparison.box2d_settings.units_per_metre > 0.125);
    CHECK(comparison.first_impacts.empty());
}

TEST_CASE("the step of Box2D is shortened until it holds the speeds", "[measure]") {
    Scene scene("box:1,1", 0);
    scene.add({0, 0}, {400, 0});  // 6.7 units in 1/960 s, and Box2D moves 2
    scene.options.frames = 2;
    const Comparison comparison = compare(scene.bodies, scene.shapes, scene.options);
    CHECK(comparison.box2d_settings.time_step == 1.0 / 3840);
    CHECK(comparison.box2d.frames.back()[0].position.x() == Approx(2 * 400 / 240.0).epsilon(1e-5));
}
