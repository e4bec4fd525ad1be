#include "lodlab/core/frame/integrate.hpp"

#include <cmath>
#include <numbers>

#include "lodlab/core/math/eigen.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
Vector<Dim> turned_axis(const Body<Dim>& body, int axis) {
    return Space<Dim>::rotation(body.orientation).col(axis);
}

Body<3> tumbling(const Vector<3>& moments, const Vector<3>& spin) {
    Body<3> body;
    set_mass<3>(body, 2, moments.asDiagonal());
    body.spin = spin;
    body.velocity = {0.3, -0.2, 0.1};
    return body;
}

struct Drift {
    double energy = 0;
    double angular = 0;
};

Drift drift_over(Body<3> body, int steps, double h) {
    std::vector<Body<3>> bodies{std::move(body)};
    const double energy_before = energy(bodies);
    const Spin<3> angular_before = angular_momentum<3>(bodies);
    Drift worst;
    for (int step = 0; step < steps; ++step) {
        integrate<3>(bodies, h);
        worst.energy = std::max(worst.energy, std::abs(energy(bodies) / energy_before - 1));
        worst.angular =
            std::max(worst.angular,
                     (angular_momentum<3>(bodies) - angular_before).norm() / angular_before.norm());
    }
    return worst;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a free body moves in a straight line and turns evenly in its plane",
                       "[integrate]", ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies{planar_body<Dim>(2, 0.7, {1, 2}, {3, -1}, 1.5)};
    for (int step = 0; step < 1000; ++step) integrate<Dim>(bodies, 0.01);
    // A thousand roundings of numbers below 40: 1000 * 2^-53 * 40.
    CHECK((bodies[0].position - planar<Dim>(31, -8)).norm() < 5e-12);
    CHECK((turned_axis(bodies[0], 0) - planar<Dim>(std::cos(15.0), std::sin(15.0))).norm() < 1e-12);
    CHECK(planar_spin(bodies[0]) == Approx(1.5).epsilon(1e-13));
}

TEMPLATE_TEST_CASE_SIG("a static body does not move, whatever its velocity says", "[integrate]",
                       ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies{immovable<Dim>()};
    bodies[0].velocity = planar<Dim>(1, 1);
    integrate<Dim>(bodies, 1);
    CHECK(bodies[0].position.isZero(0));
}

TEST_CASE("planar motion in space is the motion in the plane", "[integrate]") {
    Random random(51);
    for (int trial = 0; trial < 20; ++trial) {
        const double inertia = random.in(0.1, 2);
        const Planar x{random.in(-1, 1), random.in(-1, 1)};
        const Planar v{random.in(-1, 1), random.in(-1, 1)};
        const double w = random.in(-5, 5);
        std::vector<Body<2>> flat{planar_body<2>(1, inertia, x, v, w)};
        std::vector<Body<3>> deep{planar_body<3>(1, inertia, x, v, w)};
        for (int step = 0; step < 500; ++step) {
            integrate<2>(flat, 1.0 / 120);
            integrate<3>(deep, 1.0 / 120);
        }
        CHECK((in_plane(deep[0].position) - flat[0].position).norm() < 1e-12);
        CHECK((in_plane(turned_axis(deep[0], 0)) - turned_axis(flat[0], 0)).norm() < 1e-12);
        CHECK(std::abs(deep[0].position.z()) == 0);
        CHECK(std::abs(planar_spin(deep[0]) - w) < 1e-12);
    }
}

TEST_CASE("a tumbling body keeps energy and angular momentum over 10,000 steps", "[integrate]") {
    // Asymmetric, started near the unstable middle axis, so that it flips over and over.
    const Drift drift = drift_over(tumbling({1, 2, 3}, {0.01, 4, 0.02}), 10000, 1.0 / 120);
    // The method keeps both but for rounding: 10,000 steps of some 50 roundings of 1.1e-16 each.
    CHECK(drift.energy < 6e-11);
    CHECK(drift.angular < 6e-11);
}

TEST_CASE("a needle and a long step keep energy and angular momentum too", "[integrate]") {
    // Where the implicit step would not settle unless it were split.
    const Drift needle = drift_over(tumbling({0.002, 1, 1.001}, {20, 5, 3}), 2000, 1.0 / 60);
    // Some 100 parts a step: the same bound for 200,000 steps.
    CHECK(needle.energy < 1.2e-9);
    CHECK(needle.angular < 1.2e-9);
    const Drift leap = drift_over(tumbling({1, 2, 3}, {3, 4, 5}), 200, 0.5);
    CHECK(leap.energy < 1e-10);
    CHECK(leap.angular < 1e-10);
}

TEST_CASE("a spinning top precesses at the rate that Euler found", "[integrate]") {
    // Two equal moments: in the body frame the spin turns about the third axis at
    // (I3 - I1) / I1 * w3; in space the axis turns about the angular momentum at L / I1.
    const double I1 = 2;
    const double I3 = 3;
    const Vector<3> spin{0.6, 0, 2};
    const auto error_with = [&](int steps) {
        const double time = 5;
        std::vector<Body<3>> bodies{tumbling({I1, I1, I3}, spin)};
        for (int step = 0; step < steps; ++step) integrate<3>(bodies, time / steps);
        const Eigen::Vector3d L{I1 * spin.x(), 0, I3 * spin.z()};
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(L.norm() / I1 * time, L.normalized()).toRotationMatrix();
        return (to_eigen(turned_axis(bodies[0], 2)) - turn * Eigen::Vector3d::UnitZ()).norm();
    };
    const double coarse = error_with(500);
    const double fine = error_with(1000);
    CHECK(fine < 2e-4);
    CHECK(coarse / fine == Approx(4).epsilon(0.02));  // second order
}

TEST_CASE("the middle axis is unstable and the body flips", "[integrate]") {
    std::vector<Body<3>> bodies{tumbling({1, 2, 3}, {1e-3, 4, 0})};
    double lowest = 1;
    for (int step = 0; step < 1200; ++step) {
        integrate<3>(bodies, 1.0 / 120);
        lowest = std::min(lowest, turned_axis(bodies[0], 1).y());
    }
    CHECK(lowest < -0.99);
}
