#include "lodlab/core/exact/time_of_impact.hpp"

#include <cmath>
#include <optional>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/frame/integrate.hpp"
#include "tests/catch.hpp"
#include "tests/core/exact/exact_bodies.hpp"
#include "tests/property.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// When two balls meet: the first root of |x + v t| = reach, where they approach.
template <int Dim>
std::optional<double> meeting(const Vector<Dim>& x, const Vector<Dim>& v, double reach) {
    const double half_b = x.dot(v);
    const double root2 = half_b * half_b - v.squaredNorm() * (x.squaredNorm() - reach * reach);
    if (half_b >= 0 || root2 <= 0) return {};
    return (x.squaredNorm() - reach * reach) / (-half_b + std::sqrt(root2));
}

template <int Dim>
Body<Dim> flying_ball(lodtest::Random& random) {
    auto body = exact_ball<Dim>(1, random.in(0.1, 1), {0, 0});
    body.position = random_vector<Dim>(random, 3);
    body.velocity = random_vector<Dim>(random, 4);
    body.spin = random_spin<Dim>(random, 5);
    return body;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("balls meet when the quadratic equation says so", "[impact]",
                       ((int Dim), Dim), 2, 3) {
    lodtest::Random random(71);
    int met = 0;
    for (int round = 0; round < 2000; ++round) {
        const auto a = flying_ball<Dim>(random);
        const auto b = flying_ball<Dim>(random);
        const double reach = a.exact->radius() + b.exact->radius();
        const Vector<Dim> x = b.position - a.position;
        const Vector<Dim> v = b.velocity - a.velocity;
        if (x.norm() <= reach) continue;
        const auto expected = meeting<Dim>(x, v, reach);
        const auto touch = time_of_impact(a, b);
        if (!expected || *expected > 1) {
            CHECK(touch.outcome == ImpactOutcome::never);
            CHECK(touch.time == 1);
            continue;
        }
        ++met;
        REQUIRE(touch.outcome == ImpactOutcome::touching);
        CHECK(touch.time <= *expected);
        // They touch at a gap within the tolerance, at the speed of the approach there.
        const Vector<Dim> n = (x + *expected * v).normalized();
        CHECK((*expected - touch.time) * -n.dot(v) <= 1.001e-9 + 1e-15 * v.norm());
        REQUIRE(touch.contacts.size() == 1);
        CHECK((touch.contacts[0].normal - n).norm() < 1e-4);
    }
    CHECK(met > 50);
}

TEMPLATE_TEST_CASE_SIG("a rod that turns strikes a wall when the sine of its angle says so",
                       "[impact]", ((int Dim), Dim), 2, 3) {
    // The far corner's radius is r, its angle phi; the wall begins at the height h.
    const double half = 1;
    const double thick = 0.05;
    for (const double w : {0.3, 2.0, 50.0, -4.0})
        for (const double h : {0.1, 0.5, 0.99}) {
            const auto rod =
                with_box<Dim>(planar_body<Dim>(1, 1, {0, 0}, {0, 0}, w), 2 * half, 2 * thick);
            const auto wall = static_box<Dim>(10, 1, {0, h + 0.5});
            const auto touch = time_of_impact<Dim>(rod, wall, {.horizon = 10});
            REQUIRE(touch.outcome == ImpactOutcome::touching);
            const double r = std::hypot(half, thick);
            const double expected = (std::asin(h / r) - std::atan2(thick, half)) / std::abs(w);
            const double speed = std::abs(w) * std::sqrt(r * r - h * h);
            CHECK(std::abs(touch.time - expected) * speed <= 1.01e-9);
            CHECK(touch.rounds < 40);
        }
}

TEMPLATE_TEST_CASE_SIG("a corner falls on a face when the height says so", "[impact]",
                       ((int Dim), Dim), 2, 3) {
    const double angle = 0.3;
    const auto box = with_box<Dim>(planar_body<Dim>(1, 1, {0.2, 3}, {5, -2}), 1, 1, angle);
    const auto floor = static_box<Dim>(100, 1, {0, -0.5});
    const auto touch = time_of_impact<Dim>(floor, box, {.horizon = 5});
    REQUIRE(touch.outcome == ImpactOutcome::touching);
    const double height = 3 - 0.5 * (std::sin(angle) + std::cos(angle));
    CHECK(std::abs(touch.time - height / 2) <= 1e-9);
    REQUIRE(touch.contacts.size() == (Dim == 2 ? 1 : 2));  // in space an edge falls
    const double x = 0.2 + 5 * height / 2 + 0.5 * (std::sin(angle) - std::cos(angle));
    for (const auto& contact : touch.contacts) {
        CHECK(std::abs(contact.point[0] - x) < 1e-8);
        CHECK((contact.normal - planar<Dim>(0, 1)).norm() < 1e-12);
    }
}

TEMPLATE_TEST_CASE_SIG("bodies that part, pass or slide along each other never collide", "[impact]",
                       ((int Dim), Dim), 2, 3) {
    const auto box = [](Planar x, Planar v, double w = 0) {
        return with_box<Dim>(planar_body<Dim>(1, 1, x, v, w), 1, 1);
    };
    const auto outcome = [](const Body<Dim>& a, const Body<Dim>& b) {
        return time_of_impact<Dim>(a, b, {.horizon = 100}).outcome;
    };
    CHECK(outcome(box({0, 0}, {0, 0}), box({2, 0}, {1, 0})) == ImpactOutcome::never);
    CHECK(outcome(box({0, 0}, {0, 0}), box({-5, 1.01}, {1, 0})) == ImpactOutcome::never);
    CHECK(outcome(box({0, 0}, {0, 0}), box({2, 0}, {0, 0})) == ImpactOutcome::never);
    // Within the tolerance of touching, but sliding or parting.
    CHECK(outcome(box({0, 0}, {0, 0}), box({0, 1 + 5e-10}, {1, 0})) == ImpactOutcome::never);
    CHECK(outcome(box({0, 0}, {0, 0}), box({0, 1 + 5e-10}, {0, 1})) == ImpactOutcome::never);
    CHECK(outcome(box({0, 0}, {0, 0}), box({0, 1 + 5e-10}, {3, 3}, 1)) == ImpactOutcome::never);
    // And a touch that closes is found at once.
    const auto touch =
        time_of_impact<Dim>(box({0, 0}, {0, 0}), box({0, 1 + 5e-10}, {0, -1}), {.horizon = 1});
    CHECK(touch.outcome == ImpactOutcome::touching);
    CHECK(touch.time == 0);
}

TEMPLATE_TEST_CASE_SIG("bodies that overlap at the beginning are said to", "[impact]",
                       ((int Dim), Dim), 2, 3) {
    const auto box = [](Planar x, double size) {
        return with_box<Dim>(planar_body<Dim>(1, 1, x), size, size);
    };
    const auto outcome = [](const Body<Dim>& a, const Body<Dim>& b) {
        return time_of_impact<Dim>(a, b).outcome;
    };
    CHECK(outcome(box({0, 0}, 1), box({0.9, 0}, 1)) == ImpactOutcome::overlapping);
    CHECK(outcome(box({0, 0}, 1), box({1, 0}, 1)) == ImpactOutcome::overlapping);
    CHECK(outcome(box({0, 0}, 0.5), box({0, 0}, 4)) == ImpactOutcome::overlapping);
}

TEMPLATE_TEST_CASE_SIG("the search for an impact ends at its cap before the impact", "[impact]",
                       ((int Dim), Dim), 2, 3) {
    const auto rod = with_box<Dim>(planar_body<Dim>(1, 1, {0, 0}, {0, 0}, 1), 2, 0.1);
    const auto wall = static_box<Dim>(10, 1, {0, 1});
    const auto whole = time_of_impact<Dim>(rod, wall);
    REQUIRE(whole.outcome == ImpactOutcome::touching);
    double before = 0;
    for (int cap = 0; cap < whole.rounds; ++cap) {
        const auto cut = time_of_impact<Dim>(rod, wall, {.most_rounds = cap});
        CHECK(cut.outcome == ImpactOutcome::cap_reached);
        CHECK(cut.rounds == cap);
        CHECK(cut.time <= whole.time);
        CHECK(cut.time >= before);
        CHECK(cut.distance > 1e-9);
        before = cut.time;
    }
}

TEST_CASE("the time of impact refuses what it can't search", "[impact]") {
    const auto a = exact_ball<2>(1, 1, {0, 0});
    const auto b = exact_ball<2>(1, 1, {3, 0});
    CHECK_THROWS_AS(time_of_impact(a, disc<2>(1, 1, {3, 0})), Error);
    CHECK_THROWS_AS(time_of_impact(a, b, {.horizon = -1}), Error);
    CHECK_THROWS_AS(time_of_impact(a, b, {.tolerance = 0}), Error);
    CHECK_THROWS_AS(time_of_impact(a, b, {.longest_turn = 0}), Error);
    CHECK_THROWS_AS(time_of_impact(a, static_box<2>(1, 1, {3, 0})), Error);
}

TEMPLATE_TEST_CASE_SIG("exact motion is the motion of the frames", "[impact]", ((int Dim), Dim), 2,
                       3) {
    lodtest::Random random(5);
    for (int round = 0; round < 50; ++round) {
        const auto start = random_body<Dim>(random);
        const double h = 1.0 / 240;
        std::vector<Body<Dim>> stepped{start};
        for (int k = 0; k < 24; ++k) integrate<Dim>(stepped, h);
        const auto moved = moved_freely(start, 24 * h, h);
        CHECK((moved.position - stepped[0].position).norm() < 1e-12);
        CHECK(
            (Space<Dim>::rotation(moved.orientation) - Space<Dim>::rotation(stepped[0].orientation))
                .norm() < 1e-11);
        CHECK((moved.spin - stepped[0].spin).norm() < 1e-10 * start.spin.norm());
    }
}
