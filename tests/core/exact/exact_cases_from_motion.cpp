// The exact cases of METHOD.md, found from motion: two bodies fly, the time of impact and the
// contacts are found, and the response must give what the masses say. In space the bodies are
// prisms, so every contact of the plane is an edge or a face.

#include <cmath>

#include "tests/catch.hpp"
#include "tests/core/exact/exact_bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

constexpr double exact = 1e-8;  // the tolerance of touching, 1e-9, times the speeds' sensitivity

void check_near(double value, double expected) {
    CHECK(std::abs(value - expected) <= exact);
}

template <int Dim>
void check_velocity(const Body<Dim>& body, double x, double y, double w) {
    CHECK((body.velocity - planar<Dim>(x, y)).norm() <= exact);
    CHECK((body.spin - planar_spin<Dim>(w)).norm() <= exact);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a head-on flight ends as the masses say", "[exact][impact]",
                       ((int Dim), Dim), 2, 3) {
    auto a = with_box<Dim>(planar_body<Dim>(1, 1, {-2, 0.1}, {2, 0}), 1, 1);
    const auto b = with_box<Dim>(planar_body<Dim>(3, 1, {2, 0.1}, {-1, 0}), 1, 0.5);
    auto after = collide<Dim>(a, b);
    check_velocity(after[0], -2.5, 0, 0);
    check_velocity(after[1], 0.5, 0, 0);
    check_near(after[1].position[0] - after[0].position[0], 1);
    check_near(after[0].position[0], 0);  // they meet after 1 s

    a.restitution = 0.5;
    after = collide<Dim>(a, b);
    check_velocity(after[0], -1.375, 0, 0);
    check_velocity(after[1], 0.125, 0, 0);
}

TEMPLATE_TEST_CASE_SIG("two balls that meet at offset 1 part at a right angle", "[exact][impact]",
                       ((int Dim), Dim), 2, 3) {
    const auto after =
        collide<Dim>(exact_ball<Dim>(1, 1, {-5, 0}, {1, 0}), exact_ball<Dim>(1, 1, {0, 1}));
    check_velocity(after[0], 0.25, -std::sqrt(3.0) / 4, 0);
    check_velocity(after[1], 0.75, std::sqrt(3.0) / 4, 0);
    check_near(after[0].position[0], -std::sqrt(3.0));
}

TEMPLATE_TEST_CASE_SIG("a corner that flies into a rod sets it spinning", "[exact][impact]",
                       ((int Dim), Dim), 2, 3) {
    const double quarter = std::numbers::pi / 4;
    // The rod's mass and inertia are those of a thin one of 2 m; its box reaches a little further.
    const auto rod = [](double mass) {
        return with_box<Dim>(planar_body<Dim>(mass, mass * 2.0 * 2.0 / 12), 2.5, 0.1);
    };
    auto flying = with_box<Dim>(planar_body<Dim>(1, 1, {1, -3}, {0, 1}), 0.5, 0.5, quarter);
    auto after = collide<Dim>(flying, rod(1));
    check_velocity(after[0], 0, 0.6, 0);
    check_velocity(after[1], 0, 0.4, 1.2);

    flying.position[0] = 1 / std::sqrt(3.0);
    after = collide<Dim>(flying, rod(2));
    check_velocity(after[0], 0, 0, 0);
    check_velocity(after[1], 0, 0.5, std::sqrt(3.0) / 2);
}

TEMPLATE_TEST_CASE_SIG("a square that falls on a corner turns fall into spin", "[exact][impact]",
                       ((int Dim), Dim), 2, 3) {
    const double half_diagonal = std::sqrt(0.5);
    const auto floor = static_box<Dim>(10, 1, {0, -0.5});
    const auto fall = [&](double r_x) {
        // The lowest corner stands r_x beside the centre: at 45 degrees it stands below it.
        const double angle = std::numbers::pi / 4 + std::asin(r_x / half_diagonal);
        return with_box<Dim>(planar_body<Dim>(1, 1.0 / 6, {0, 2}, {0, -1}), 1, 1, angle);
    };
    auto after = collide<Dim>(floor, fall(0.25));
    check_velocity(after[1], 0, 5.0 / 11, 24.0 / 11);
    after = collide<Dim>(floor, fall(1 / std::sqrt(6.0)));
    check_velocity(after[1], 0, 0, std::sqrt(6.0));

    // At r_x = 0.5 the square falls flat; the tip of a post stands under its corner.
    const auto post = static_box<Dim>(1, 1, {0.5, 0}, std::numbers::pi / 4);
    after = collide<Dim>(post, with_box<Dim>(planar_body<Dim>(1, 1.0 / 6, {0, 3}, {0, -1}), 1, 1));
    check_velocity(after[1], 0, -0.2, 2.4);
}

TEMPLATE_TEST_CASE_SIG("two spinning boxes that meet off their centres", "[exact][impact]",
                       ((int Dim), Dim), 2, 3) {
    // At the impact a's right face stands at x = 0.6 and a corner of b at (0.6, 0.3).
    const double before = 0.1;
    const Planar arm(-0.7, 0.2);
    const double side = arm.norm() * std::sqrt(2.0);
    const double angle_b = std::atan2(arm.y(), arm.x()) + std::numbers::pi / 4;
    const auto a =
        with_box<Dim>(planar_body<Dim>(1, 1.0 / 6, {-before, 0}, {1, 0}, 2), 1.2, 1.2, -2 * before);
    auto b =
        planar_body<Dim>(2, 1.0 / 3, {1.3 + 0.5 * before, 0.1 - 0.2 * before}, {-0.5, 0.2}, -1);
    b = with_box<Dim>(b, side, side, angle_b + before);
    const auto touch = time_of_impact<Dim>(a, b);
    REQUIRE(touch.outcome == ImpactOutcome::touching);
    check_near(touch.time, before);
    const auto after = collide<Dim>(a, b);
    check_velocity(after[0], 19.0 / 54, 0, 19.0 / 6);
    check_velocity(after[1], -19.0 / 108, 0.2, -25.0 / 18);
}

TEMPLATE_TEST_CASE_SIG("two offset boxes that meet set each other spinning", "[exact][impact]",
                       ((int Dim), Dim), 2, 3) {
    const auto a = with_box<Dim>(planar_body<Dim>(1, 1.0 / 6, {-3, 0}, {2, 0}), 1, 1);
    const auto b = with_box<Dim>(planar_body<Dim>(1, 1.0 / 6, {1, 0.4}), 1, 1);
    const auto touch = time_of_impact<Dim>(a, b, {.horizon = 3});
    REQUIRE(touch.outcome == ImpactOutcome::touching);
    check_near(touch.time, 1.5);
    CHECK(touch.contacts.size() == (Dim == 2 ? 2 : 4));  // the ends, the corners of what they share
    const auto after = collide<Dim>(a, b);
    check_velocity(after[0], 2 - 50.0 / 31, 0, 60.0 / 31);
    check_velocity(after[1], 50.0 / 31, 0, 60.0 / 31);
    check_near(energy(after), 2);
}
