#include "lodlab/measure/first_impact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/outline.hpp"
#include "lodlab/measure/plane_bodies.hpp"
#include "tests/catch.hpp"
#include "tests/measure/collision.hpp"
#include "tests/random.hpp"

using namespace measure;
using measuretest::collision_at;

namespace {

struct Kind {
    explicit Kind(const char* spec)
        : shape(lod2d::generate(spec)), outline(std::make_shared<lod2d::ExactOutline>(shape)) {}

    [[nodiscard]] lod::Body<2> body(double mass, lod::Vector<2> position,
                                    lod::Vector<2> velocity) const {
        lod::Body<2> made;
        lod::set_mass<2>(made, mass,
                         lod::Inertia<2>::Constant(mass * shape.second_moment / shape.area));
        made.position = position;
        made.velocity = velocity;
        made.exact = outline;
        return made;
    }

    lod2d::Shape shape;
    std::shared_ptr<const lod2d::ExactOutline> outline;
};

}  // namespace

TEST_CASE("the errors of an impact are those of its impulse, ways and spins", "[measure]") {
    // A comes at 1 m/s along x and leaves along y: the impulse on it is (-1, 1).
    const Collision<2> reference = collision_at(1);
    CHECK(impulse_of(reference).isApprox(lod::Vector<2>(0, 0)));  // B did not take it: not physical
    Collision<2> right = reference;
    right.after[1].velocity = {1, -1};
    Collision<2> seen = right;
    seen.after[0].velocity = {0, 1.5};
    seen.after[1].velocity = {1, -1.5};
    seen.after[1].spin[0] = -0.25;
    const ImpactError error = impact_error(right, seen);
    CHECK(error.impulse == Approx(0.5 / std::sqrt(2)));  // (1, -1.5) instead of (1, -1)
    // B leaves at atan 1.5 instead of 45 degrees below the x axis.
    CHECK(error.angle == Approx(std::atan(1.5) - std::numbers::pi / 4));
    CHECK(error.spin == Approx(0.25));
    CHECK(impact_error(right, right).impulse == 0);
    lod::make_static(right.before[1]);
    CHECK(impulse_of(right).isApprox(lod::Vector<2>(1, -1)));  // by A: minus what A takes
}

TEST_CASE("the exact collision of two boxes is case 6 of the method", "[measure]") {
    const Kind box("box:1,1");
    const auto collision = exact_collision(box.body(1, {0, 0}, {2, 0}),
                                           box.body(1, {2, 0.4}, {0, 0}), lod::Response::net, 1);
    REQUIRE(collision);
    CHECK(collision->time == Approx(0.5).epsilon(1e-8));
    CHECK(collision->after[0].velocity.x() == Approx(2 - 50.0 / 31).epsilon(1e-6));
    CHECK(collision->after[1].spin[0] == Approx(60.0 / 31).epsilon(1e-6));
    const auto too_late = exact_collision(box.body(1, {0, 0}, {2, 0}),
                                          box.body(1, {2, 0.4}, {0, 0}), lod::Response::net, 0.4);
    CHECK_FALSE(too_late);
}

TEST_CASE("the collision of frames ends when the pushes end", "[measure]") {
    const Kind box("box:1,1");
    std::vector<lod::Body<2>> bodies{box.body(1, {0, 0}, {2, 0}), box.body(1, {2, 0.4}, {0, 0})};
    for (auto& body : bodies)
        body.tree = std::make_shared<lod::SphereTree<2>>(lod2d::build_tree(box.shape));
    const lod2d::Shape* const shapes[] = {&box.shape, &box.shape};
    const PlaneBodies planar(shapes);
    lod::FrameSettings settings;
    settings.time_step = 1.0 / 240;
    settings.deepest_level = 0;
    settings.contact_model = lod::ContactModel::centre_line;
    const auto collision = framed_collision<2>(bodies[0], bodies[1], settings, planar, {1});
    REQUIRE(collision);
    // The roots, of radius 1/sqrt 2 at least, meet while the faces are still apart.
    CHECK(collision->gap > 0.1);
    CHECK(collision->time < 0.45);
    CHECK(collision->gap == Approx(1 - 2 * collision->time).margin(1e-12));
    CHECK(collision->after[0].velocity.x() + collision->after[1].velocity.x() == Approx(2));
    CHECK_FALSE(framed_collision<2>(bodies[0], bodies[1], settings, planar, {0.1}));
}

TEST_CASE("exact impacts of random pairs agree with Box2D's to a step of its motion",
          "[measure][box2d]") {
    std::vector<Kind> kinds;
    for (const char* spec : {"box", "L", "star:5", "star:9", "triangle", "T", "cross", "gear:9",
                             "arrow", "U", "polygon:7"})
        kinds.emplace_back(spec);
    lodtest::Random random(7);
    std::vector<double> differences;
    int same = 0;
    while (differences.size() < 1000) {
        const Kind& a = kinds[static_cast<std::size_t>(random.below(11))];
        const Kind& b = kinds[static_cast<std::size_t>(random.below(11))];
        std::vector<lod::Body<2>> bodies{
            a.body(1, {-1.5, random.in(-0.3, 0.3)}, {random.in(0.5, 1.5), random.in(-0.2, 0.2)}),
            b.body(2, {0, random.in(-0.3, 0.3)}, {random.in(-1, 0), random.in(-0.2, 0.2)})};
        for (auto& body : bodies) {
            body.orientation = random.in(-3, 3);
            body.spin[0] = random.in(-2, 2);
        }
        const auto exact = exact_collision(bodies[0], bodies[1], lod::Response::net, 1);
        const lod2d::Shape* const shapes[] = {&a.shape, &b.shape};
        lod2d::Box2dSettings settings;
        settings.most_steps = 960;
        const auto box2d = lod2d::run_to_impact(bodies, shapes, settings);
        if (!exact || !box2d.happened) continue;
        double squared = 0;
        for (std::size_t i = 0; i < 2; ++i)
            squared += (box2d.after[i].velocity - exact->after[i].velocity).squaredNorm();
        differences.push_back(std::sqrt(squared));
        // A corner's arm, of at most 1 m, is wrong by a step's motion of at most 5 m/s / 960 and
        // two skins of 0.6 mm; its normal by the turn of a step. At some 3 m/s: 0.03 m/s.
        if (box2d.contacts.size() == 1 && differences.back() < 0.03) ++same;
    }
    std::sort(differences.begin(), differences.end());
    CHECK(differences[500] < 1e-3);
    CHECK(same >= 960);  // the others: a face on a face, a corner on a corner, skins that graze
}
