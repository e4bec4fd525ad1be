// Section 4.2: "when an intersection occurs between sphere nodes of an object, we cannot imply that
// the actual objects themselves are even touching". Backtracking at such a level finds a time of
// contact of bodies that never touch (figure 5).

#include "lodlab/core/exact/level_impact.hpp"

#include <cmath>

#include "lodlab/core/response/impact.hpp"
#include "tests/catch.hpp"
#include "tests/core/exact/exact_bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// A bar, 2 m long and 0.2 m high, that flies along itself.
template <int Dim>
Body<Dim> bar(Planar x, double speed) {
    auto body = with_box<Dim>(planar_body<Dim>(1, 1, x, {speed, 0}), 2, 0.2);
    body.tree = box_tree<Dim>(2, 0.2, 6);
    return body;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("backtracking at coarse levels finds contacts of bodies that never touch",
                       "[backtracking]", ((int Dim), Dim), 2, 3) {
    // The bars pass each other 0.4 m apart, at 2 m/s, and are side by side after 2 s.
    const auto a = bar<Dim>({-2, 0}, 1);
    const auto b = bar<Dim>({2, 0.6}, -1);
    const ImpactSettings ahead{.horizon = 4};
    CHECK(time_of_impact(a, b, ahead).outcome == ImpactOutcome::never);
    const auto nearest = nearest_approach(a, b, ahead, 401);
    CHECK(std::abs(nearest.gap.distance - 0.4) < 1e-12);
    CHECK(std::abs(nearest.time - 2) <= 1.01);

    double before = 0;
    int inappropriate = 0;
    for (int level = 0; level <= 4; ++level) {
        const auto touch = level_impact(a, b, level, ahead);
        // The half height of a level's balls; those of the two bars touch while it is over 0.3.
        const double radius = 0.5 * std::hypot(2, 0.2) / std::exp2(level);
        const double centre = level == 0 ? 0 : 0.1 - 0.1 / std::exp2(level);
        if (radius + centre < 0.3) {
            CHECK(touch.outcome == ImpactOutcome::never);
            continue;
        }
        ++inappropriate;
        REQUIRE(touch.outcome == ImpactOutcome::touching);
        CHECK(touch.distance <= 1e-9);
        // The true shapes are far apart there, and yet the "contact" would make them bounce.
        CHECK(separation(touch.a, touch.b).distance > 0.39);
        REQUIRE_FALSE(touch.contacts.empty());
        CHECK(single_impulse(touch.a, touch.b, touch.contacts[0]) > 0.01);
        CHECK(touch.time > before);  // the finer the level, the later it is deceived
        before = touch.time;
    }
    CHECK(inappropriate >= 2);
    // Roots of radius r whose centres pass at height 0.6 touch where the quadratic equation says.
    const double r = std::hypot(2, 0.2);
    const double expected = (4 - std::sqrt(r * r - 0.36)) / 2;
    CHECK(std::abs(level_impact(a, b, 0, ahead).time - expected) < 1e-8);
}

TEMPLATE_TEST_CASE_SIG("where bodies do collide, finer levels find a time nearer to the true one",
                       "[backtracking]", ((int Dim), Dim), 2, 3) {
    const auto a = bar<Dim>({-3, 0}, 1);
    const auto b = bar<Dim>({3, 0.1}, -1);
    const auto exact = time_of_impact(a, b, {.horizon = 4});
    REQUIRE(exact.outcome == ImpactOutcome::touching);
    CHECK(std::abs(exact.time - 2) < 1e-8);
    double early = 1;
    for (int level = 0; level <= 4; ++level) {
        const auto touch = level_impact(a, b, level, {.horizon = 4});
        REQUIRE(touch.outcome == ImpactOutcome::touching);
        CHECK(touch.time <= exact.time);
        CHECK(exact.time - touch.time <= early);
        early = exact.time - touch.time;
    }
    CHECK(early < 0.02);
}
