#include "lodlab/measure/perceived.hpp"

#include <cmath>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/measure/collision.hpp"

using namespace measure;
using measuretest::collision_at;
using measuretest::GivenShapes;
using measuretest::unit_body;

namespace {

using Collisions = std::vector<Collision<2>>;

/// A leaves at such an angle to the x axis along which it came, B stays at rest.
Collision<2> deflected(double degrees, double speed = 1) {
    Collision<2> collision = collision_at(1);
    const double angle = degrees * std::numbers::pi / 180;
    collision.after[0].velocity = {speed * std::cos(angle), speed * std::sin(angle)};
    return collision;
}

Perceived judged(const Collision<2>& reference, const Collision<2>& seen) {
    return perceived<2>(reference, seen, GivenShapes{});
}

}  // namespace

TEST_CASE("a run that is its own reference has no perceived error", "[measure]") {
    const Collisions run{collision_at(1), collision_at(2)};
    const PerceivedError error = perceived_error<2>(run, run, GivenShapes{});
    CHECK(error.total == 0);
    CHECK(error.collisions.size() == 2);
    CHECK(error.missing.empty());
    CHECK(error.extra.empty());
    CHECK(error.collisions[0].first);
    CHECK_FALSE(error.collisions[1].first);
}

TEST_CASE("two runs without a collision look the same", "[measure]") {
    CHECK(perceived_error<2>(Collisions{}, Collisions{}, GivenShapes{}).total == 0);
}

TEST_CASE("gap and overlap are shares of the smaller body, beyond the reference's", "[measure]") {
    GivenShapes shapes;
    shapes.sizes = {0.5, 3};
    Collision<2> reference = collision_at(1);
    Collision<2> seen = collision_at(1);
    reference.gap = 0.01;
    seen.gap = 0.06;
    seen.penetration = 0.02;
    const Perceived error = perceived<2>(reference, seen, shapes);
    CHECK(error.gap == Approx(0.1));
    CHECK(error.penetration == Approx(0.04));
    const PerceivedCost cost = cost_of(error, {});
    CHECK(cost.gap == Approx(2));            // 0.1 / 0.05
    CHECK(cost.penetration == Approx(0.4));  // 0.04 / 0.1
    CHECK(cost.sum() == Approx(2.4));
    CHECK(perceived<2>(seen, reference, shapes).gap == 0);  // a smaller gap is no error
}

TEST_CASE("a delay counts twice as much as the same time too early", "[measure]") {
    const Perceived late = judged(collision_at(1), collision_at(1.1));
    const Perceived early = judged(collision_at(1), collision_at(0.9));
    CHECK(late.delay == Approx(0.1));
    CHECK(early.delay == Approx(-0.1));
    CHECK(cost_of(late, {}).delay == Approx(2));   // 0.1 / 0.05
    CHECK(cost_of(early, {}).delay == Approx(1));  // 0.1 / 0.1
}

TEST_CASE("an angle is expanded where the body is deflected further", "[measure]") {
    const double thirty = std::numbers::pi / 6;
    const Perceived expanded = judged(deflected(90), deflected(120));
    const Perceived contracted = judged(deflected(90), deflected(60));
    CHECK(expanded.angle == Approx(thirty));
    CHECK(contracted.angle == Approx(-thirty));
    CHECK(cost_of(expanded, {}).angle == Approx(thirty / 0.4));
    CHECK(cost_of(contracted, {}).angle == Approx(thirty / 0.2));
    // As far, but to the other side: by the whole angle between the two ways.
    CHECK(std::abs(judged(deflected(45), deflected(-45)).angle) == Approx(3 * thirty));
    CHECK(judged(deflected(90), deflected(90)).angle == 0);
    // Without speed there is no direction.
    CHECK(judged(deflected(90), deflected(180, 0.01)).angle == 0);
}

TEST_CASE("speeds are shares of the pace, the body that shows most of it counts", "[measure]") {
    const Collision<2> reference = deflected(90);
    CHECK(judged(reference, deflected(90, 1.3)).speed == Approx(0.3));
    CHECK(judged(reference, deflected(90, 0.7)).speed == Approx(-0.3));
    CHECK(cost_of(judged(reference, deflected(90, 1.3)), {}).speed == Approx(0.75));
    CHECK(cost_of(judged(reference, deflected(90, 0.7)), {}).speed == Approx(1.5));
    // A raised by 0.3 costs 0.75; B lowered by 0.2 costs 1.
    Collision<2> both = reference;
    both.after[1].velocity = {0.5, 0};
    Collision<2> seen = deflected(90, 1.3);
    seen.after[1].velocity = {0.3, 0};
    CHECK(judged(both, seen).speed == Approx(-0.2));
}

TEST_CASE("spin is judged by the speed of the rim", "[measure]") {
    Collision<2> seen = collision_at(1);
    seen.after[0].spin[0] = 0.5;  // at a rim of 0.5 m: 0.25 m/s of the 1 m/s that A came with
    CHECK(judged(collision_at(1), seen).spin == Approx(0.25));
    seen.after[0].spin[0] = -0.5;
    CHECK(judged(collision_at(1), seen).spin == Approx(0.25));
    CHECK(cost_of(judged(collision_at(1), seen), {}).spin == Approx(0.5));
}

TEST_CASE("energy lost counts twice as much as energy gained", "[measure]") {
    // 0.5 J before and, in the reference, after. Speed 1.2: 0.72 J, 44 % more; 0.8: 36 % less.
    const Perceived gained = judged(deflected(90), deflected(90, 1.2));
    const Perceived lost = judged(deflected(90), deflected(90, 0.8));
    CHECK(gained.energy == Approx(0.44));
    CHECK(lost.energy == Approx(-0.36));
    CHECK(cost_of(gained, {}).energy == Approx(1.1));
    CHECK(cost_of(lost, {}).energy == Approx(1.8));
}

TEST_CASE("walls do not count, however they are hit", "[measure]") {
    Collision<2> reference = collision_at(1);
    lod::make_static(reference.before[1]);
    lod::make_static(reference.after[1]);
    Collision<2> seen = reference;
    seen.after[1].spin[0] = 5;  // could not be
    CHECK(judged(reference, seen).spin == 0);
    // Every bounce of another body off a wall is a first one.
    Collision<2> other = reference;
    other.a = 2;
    other.time = other.until = 1.5;
    const Collisions run{reference, other};
    const PerceivedError error = perceived_error<2>(run, run, GivenShapes{});
    CHECK(error.collisions[1].first);
}

TEST_CASE("the same scene in larger units is judged alike", "[measure]") {
    Collision<2> reference = deflected(80);
    Collision<2> seen = deflected(100, 0.9);
    seen.gap = 0.03;
    seen.penetration = 0.05;
    seen.after[0].spin[0] = 0.4;
    const Perceived small = judged(reference, seen);
    for (Collision<2>* collision : {&reference, &seen}) {
        collision->gap *= 10;
        collision->penetration *= 10;
        for (auto* bodies : {&collision->before, &collision->after})
            for (lod::Body<2>& body : *bodies) {
                body.velocity *= 10;
                lod::set_mass<2>(body, 1, lod::Inertia<2>::Constant(100));
            }
    }
    GivenShapes large;
    large.sizes = {10, 10};
    const Perceived judged_large = perceived<2>(reference, seen, large);
    CHECK(judged_large.gap == Approx(small.gap));
    CHECK(judged_large.penetration == Approx(small.penetration));
    CHECK(judged_large.angle == Approx(small.angle));
    CHECK(judged_large.speed == Approx(small.speed));
    CHECK(judged_large.spin == Approx(small.spin));
    CHECK(judged_large.energy == Approx(small.energy));
}

TEST_CASE("the total is the mean of the parts, missing and extra collisions included",
          "[measure]") {
    Collision<2> with_gap = collision_at(1);
    with_gap.gap = 0.05;  // costs 1
    const Collisions reference{collision_at(1), collision_at(2)};
    const Collisions seen{with_gap, collision_at(3), collision_at(4)};
    const PerceivedError error = perceived_error<2>(reference, seen, GivenShapes{});
    CHECK(error.missing == std::vector<int>{1});
    CHECK(error.extra == std::vector<int>{1, 2});
    // Four events: 1 for the gap, 6 for the missing one, 4 for each that should not be.
    CHECK(error.cost.gap == Approx(0.25));
    CHECK(error.missing_cost == Approx(1.5));
    CHECK(error.extra_cost == Approx(2));
    CHECK(error.total == Approx(3.75));
}
