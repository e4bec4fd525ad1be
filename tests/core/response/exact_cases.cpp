// The cases that elementary mechanics answer in closed form. Every number is worked
// out by hand from the masses; space repeats the plane with the inertia about z.

#include <cmath>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

constexpr double exact = 1e-12;

void check_near(double value, double expected) {
    CHECK(std::abs(value - expected) <= exact * std::max(1.0, std::abs(expected)));
}

template <int Dim>
void check_velocity(const Body<Dim>& body, double x, double y) {
    check_near(body.velocity[0], x);
    check_near(body.velocity[1], y);
    if (body.velocity.size() > 2) CHECK(body.velocity[body.velocity.size() - 1] == 0);
}

/// Two bodies, one contact.
template <int Dim>
std::vector<Body<Dim>> impact(Body<Dim> a, Body<Dim> b, Contact<Dim> contact, Response response,
                              double* impulse = nullptr) {
    std::vector<Body<Dim>> bodies{std::move(a), std::move(b)};
    const auto impulses = resolve<Dim>(response, {{0, 1, 0, contact}}, bodies);
    if (impulse) *impulse = impulses[0];
    return bodies;
}

const Response every_response[] = {Response::net, Response::sum, Response::mean};

}  // namespace

TEMPLATE_TEST_CASE_SIG("a head-on impact exchanges what the masses say", "[exact]",
                       ((int Dim), Dim), 2, 3) {
    for (const Response response : every_response) {
        Body<Dim> a = planar_body<Dim>(1, 1, {-1, 0}, {2, 0});
        const Body<Dim> b = planar_body<Dim>(3, 1, {1, 0}, {-1, 0});
        double j = 0;
        auto after = impact<Dim>(a, b, planar_contact<Dim>({0, 0}, {1, 0}), response, &j);
        check_velocity(after[0], -2.5, 0);
        check_velocity(after[1], 0.5, 0);
        check_near(j, 4.5);

        a.restitution = 0.5;  // the smaller of the two counts
        after = impact<Dim>(a, b, planar_contact<Dim>({0, 0}, {1, 0}), response, &j);
        check_velocity(after[0], -1.375, 0);
        check_velocity(after[1], 0.125, 0);
        check_near(j, 3.375);
    }
}

TEMPLATE_TEST_CASE_SIG("two equal discs at offset 1 part at a right angle", "[exact]",
                       ((int Dim), Dim), 2, 3) {
    const double across = std::sqrt(3.0);
    std::vector<Body<Dim>> bodies{disc<Dim>(1, 1, {0, 0}, {1, 0}), disc<Dim>(1, 1, {across, 1})};
    FrameStorage<Dim> storage;
    Budget budget = Budget::unlimited();
    const auto& record = advance<Dim>(bodies, {}, budget, storage);
    REQUIRE(record.impacts.size() == 1);
    CHECK(record.pairs[0].verdict == Verdict::true_collision);
    check_velocity(bodies[0], 0.25, -across / 4);
    check_velocity(bodies[1], 0.75, across / 4);
    CHECK(planar_spin(bodies[0]) == Approx(0).margin(exact));
}

TEMPLATE_TEST_CASE_SIG("a disc on the end of a rod sets it spinning", "[exact]", ((int Dim), Dim),
                       2, 3) {
    for (const Response response : every_response) {
        const Body<Dim> flying = planar_body<Dim>(1, 1, {1, -0.5}, {0, 1});
        const Body<Dim> rod = planar_body<Dim>(1, 1 * 2.0 * 2.0 / 12);
        const auto after = impact<Dim>(flying, rod, planar_contact<Dim>({1, 0}, {0, 1}), response);
        check_velocity(after[0], 0, 0.6);
        check_velocity(after[1], 0, 0.4);
        check_near(planar_spin(after[1]), 1.2);
    }
}

TEMPLATE_TEST_CASE_SIG("a disc stops dead where the rod weighs as much as it does", "[exact]",
                       ((int Dim), Dim), 2, 3) {
    const double offset = 1 / std::sqrt(3.0);
    const Body<Dim> flying = planar_body<Dim>(1, 1, {offset, -0.5}, {0, 1});
    const Body<Dim> rod = planar_body<Dim>(2, 2 * 2.0 * 2.0 / 12);
    const auto after =
        impact<Dim>(flying, rod, planar_contact<Dim>({offset, 0}, {0, 1}), Response::net);
    check_velocity(after[0], 0, 0);
    check_velocity(after[1], 0, 0.5);
    check_near(planar_spin(after[1]), std::sqrt(3.0) / 2);
}

TEMPLATE_TEST_CASE_SIG("a square that lands on one corner turns fall into spin", "[exact]",
                       ((int Dim), Dim), 2, 3) {
    struct Landing {
        double r_x, v_y, w;
    };
    const double root6 = std::sqrt(6.0);
    for (const Landing& landing :
         {Landing{0.25, 5.0 / 11, 24.0 / 11}, {1 / root6, 0, root6}, {0.5, -0.2, 2.4}}) {
        const Body<Dim> square = planar_body<Dim>(1, 1.0 / 6, {0, 0.5}, {0, -1});
        const auto after = impact<Dim>(
            immovable<Dim>(), square, planar_contact<Dim>({landing.r_x, 0}, {0, 1}), Response::net);
        check_velocity(after[1], 0, landing.v_y);
        check_near(planar_spin(after[1]), landing.w);
        check_velocity(after[0], 0, 0);
        CHECK(after[0].spin.isZero(0));
    }
}

TEMPLATE_TEST_CASE_SIG("two spinning bodies meet off their centres", "[exact]", ((int Dim), Dim), 2,
                       3) {
    for (const Response response : every_response) {
        const Body<Dim> a = planar_body<Dim>(1, 1.0 / 6, {0, 0}, {1, 0}, 2);
        const Body<Dim> b = planar_body<Dim>(2, 1.0 / 3, {1.3, 0.1}, {-0.5, 0.2}, -1);
        const Contact<Dim> contact = planar_contact<Dim>({0.6, 0.3}, {1, 0});
        // r_a x n = -0.3, r_b x n = -0.2: K = 1 + 0.5 + 6 * 0.09 + 3 * 0.04 = 2.16; v_c = -0.7.
        check_near(closing_velocity(a, b, contact), -0.7);
        check_near(inverse_effective_mass(a, b, contact), 2.16);
        double j = 0;
        const auto after = impact<Dim>(a, b, contact, response, &j);
        check_near(j, 35.0 / 54);
        check_velocity(after[0], 19.0 / 54, 0);
        check_velocity(after[1], -19.0 / 108, 0.2);
        check_near(planar_spin(after[0]), 19.0 / 6);
        check_near(planar_spin(after[1]), -25.0 / 18);
    }
}

TEMPLATE_TEST_CASE_SIG("two offset boxes set each other spinning", "[exact]", ((int Dim), Dim), 2,
                       3) {
    for (const Response response : every_response) {
        const Body<Dim> a = planar_body<Dim>(1, 1.0 / 6, {0, 0}, {2, 0});
        const Body<Dim> b = planar_body<Dim>(1, 1.0 / 6, {1, 0.4}, {0, 0});
        double j = 0;
        const auto after = impact<Dim>(a, b, planar_contact<Dim>({0.5, 0.2}, {1, 0}), response, &j);
        check_near(j, 50.0 / 31);  // K = 2 + 2 * 6 * 0.2^2 = 2.48
        check_near(planar_spin(after[0]), 60.0 / 31);
        check_near(planar_spin(after[1]), 60.0 / 31);
        check_near(energy(after), 2);
    }
}

TEMPLATE_TEST_CASE_SIG("a ball that arrives at a row of three sends off the last", "[exact]",
                       ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies{disc<Dim>(1, 1, {0, 0}, {1, 0}), disc<Dim>(1, 1, {2, 0}),
                                  disc<Dim>(1, 1, {4, 0})};
    Budget budget = Budget::unlimited();
    FrameStorage<Dim> storage;
    advance<Dim>(bodies, {}, budget, storage);
    check_velocity(bodies[0], 0, 0);
    check_velocity(bodies[1], 0, 0);
    check_velocity(bodies[2], 1, 0);
}

TEMPLATE_TEST_CASE_SIG("a break of one onto two is symmetric and keeps its energy", "[exact]",
                       ((int Dim), Dim), 2, 3) {
    const double across = std::sqrt(3.0);
    // The two touch each other, too; they part from the first ball on.
    const std::vector<Body<Dim>> before{disc<Dim>(1, 1, {0, 0}, {1, 0}),
                                        disc<Dim>(1, 1, {across, 1}),
                                        disc<Dim>(1, 1, {across, -1})};
    const auto after = [&](Response response) {
        std::vector<Body<Dim>> bodies = before;
        FrameSettings settings;
        settings.response = response;
        Budget budget = Budget::unlimited();
        FrameStorage<Dim> storage;
        advance<Dim>(bodies, settings, budget, storage);
        return bodies;
    };
    const auto net = after(Response::net);
    check_velocity(net[0], -0.2, 0);
    check_velocity(net[1], 0.6, 0.6 / across);  // 0.346410
    check_velocity(net[2], 0.6, -0.6 / across);
    check_near(energy(net), 0.5);

    check_near(energy(after(Response::sum)) / energy(before), 1.75);
}
