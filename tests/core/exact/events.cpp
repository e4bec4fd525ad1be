// Galperin's billiard: a block of 100^k kg pushes a small one of 1 kg against a wall. Without
// friction the number of collisions is the first k + 1 digits of pi (Galperin, Playing pool with
// pi, 2003). A fixed step miscounts; the exact times of impact must not.

#include "tests/core/exact/advance_to_event.hpp"

#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"
#include "tests/core/exact/exact_bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
struct Count {
    int collisions = 0;
    std::vector<Body<Dim>> bodies;
};

template <int Dim>
Count<Dim> collisions_of(std::vector<Body<Dim>> bodies) {
    Count<Dim> count{0, std::move(bodies)};
    Resolver<Dim> resolver;
    std::vector<double> impulses;
    while (const auto event = advance_to_event<Dim>(count.bodies, {.horizon = 1e4})) {
        resolver.resolve(Response::net, event->impacts, count.bodies, impulses);
        ++count.collisions;
        if (count.collisions > 4000) break;
    }
    return count;
}

template <int Dim>
std::vector<Body<Dim>> blocks(double mass) {
    return {static_box<Dim>(1, 4, {-0.5, 0}), with_box<Dim>(planar_body<Dim>(1, 1, {10, 0}), 1, 1),
            with_box<Dim>(planar_body<Dim>(mass, mass, {20, 0}, {-1, 0}), 2, 2)};
}

template <int Dim>
std::vector<Body<Dim>> balls(double mass) {
    return {exact_ball<Dim>(1, 1, {-1, 0}), exact_ball<Dim>(1, 0.5, {10, 0}),
            exact_ball<Dim>(mass, 1, {20, 0}, {-1, 0})};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("blocks that meet at a wall count the digits of pi", "[events]",
                       ((int Dim), Dim), 2, 3) {
    double mass = 1;
    for (const int digits : {3, 31, 314, 3141}) {
        const auto count = collisions_of<Dim>(blocks<Dim>(mass));
        CHECK(count.collisions == digits);
        CHECK(std::abs(energy(count.bodies) / (0.5 * mass) - 1) < 1e-11);
        // Both leave, the large one not slower than the small one.
        CHECK(count.bodies[1].velocity[0] >= 0);
        CHECK(count.bodies[2].velocity[0] >= count.bodies[1].velocity[0]);
        CHECK(count.bodies[2].spin.norm() < 1e-9);
        mass *= 100;
        if (Dim == 3 && digits == 314) break;  // the balls go on; this takes a second
    }
}

TEMPLATE_TEST_CASE_SIG("so do balls", "[events]", ((int Dim), Dim), 2, 3) {
    double mass = 1;
    for (const int digits : {3, 31, 314, 3141}) {
        auto bodies = balls<Dim>(mass);
        make_static(bodies[0]);
        CHECK(collisions_of<Dim>(std::move(bodies)).collisions == digits);
        mass *= 100;
    }
}

TEMPLATE_TEST_CASE_SIG("events come in order and end at the horizon", "[events]", ((int Dim), Dim),
                       2, 3) {
    // The first ball reaches the second after 1 s, that one the third 2 s later.
    std::vector<Body<Dim>> bodies{exact_ball<Dim>(1, 0.5, {0, 0}, {1, 0}),
                                  exact_ball<Dim>(1, 0.5, {2, 0}), exact_ball<Dim>(1, 0.5, {5, 0})};
    Resolver<Dim> resolver;
    std::vector<double> impulses;
    for (const double expected : {1.0, 2.0}) {
        const auto event = advance_to_event<Dim>(bodies, {.horizon = 4});
        REQUIRE(event);
        CHECK(std::abs(event->time - expected) < 2e-9);
        REQUIRE(event->impacts.size() == 1);
        resolver.resolve(Response::net, event->impacts, bodies, impulses);
    }
    CHECK_FALSE(advance_to_event<Dim>(bodies, {.horizon = 4}));
    CHECK(std::abs(bodies[2].position[0] - 9) < 1e-8);
    bodies[1].position = bodies[0].position;
    CHECK_THROWS_AS(advance_to_event<Dim>(bodies), Error);
}
