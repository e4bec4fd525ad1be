// What fast balls run into.
#include "lodlab/core/frame/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// Balls that do not overlap, in random motion.
template <int Dim>
std::vector<Body<Dim>> balls_in(Random& random, int count, double room, double speed) {
    std::vector<Body<Dim>> balls;
    while (static_cast<int>(balls.size()) < count) {
        auto ball = disc<Dim>(1, 0.1, {0, 0});
        ball.position = random_vector<Dim>(random, room);
        ball.velocity = random_vector<Dim>(random, random.below(3) == 0 ? 0.1 * speed : speed);
        if (std::ranges::none_of(balls, [&](const auto& other) {
                return (other.position - ball.position).norm() < 0.21;
            }))
            balls.push_back(ball);
    }
    return balls;
}

const SweepSettings swept{.on = true};

template <int Dim>
std::vector<SweptImpact<Dim>> sweep(Sweeper<Dim>& sweeper, std::vector<Body<Dim>>& bodies,
                                    double h) {
    std::vector<SweptImpact<Dim>> found;
    sweeper.advance(bodies, h, swept, {.contact_model = ContactModel::centre_line}, found);
    return found;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("sweeping a crowd costs each fast body and impact log n", "[sweep]",
                       ((int Dim), Dim), 2, 3) {
    int logarithm = 9;
    for (const int count : {512, 1024, 2048}) {
        Random random(62);
        auto balls = balls_in<Dim>(random, count, 0.35 * std::pow(count, 1.0 / Dim), 60);
        Sweeper<Dim> sweeper;
        const auto found = sweep(sweeper, balls, 0.01);
        CHECK(found.size() > static_cast<std::size_t>(count) / 20);
        // A way of 0.6 m and more comes near those of some ten others.
        CHECK(sweeper.steps() <=
              25 * static_cast<std::uint64_t>(logarithm) * (balls.size() + 2 * found.size()));
        ++logarithm;
    }
}

TEMPLATE_TEST_CASE_SIG("what hits a wall costs the others nothing", "[sweep]", ((int Dim), Dim), 2,
                       3) {
    for (const int count : {256, 512, 1024}) {
        std::vector<Body<Dim>> bodies;
        for (int i = 0; i < count; ++i) {
            bodies.push_back(disc<Dim>(1, 0.1, {static_cast<double>(i), 0.3}, {0, -60}));
        }
        bodies.push_back(immovable<Dim>());
        bodies.back().tree =
            std::make_shared<SphereTree<Dim>>(half_space<Dim>(Vector<Dim>(Vector<Dim>::Unit(1))));
        Sweeper<Dim> sweeper;
        const auto found = sweep(sweeper, bodies, 0.01);
        CHECK(found.size() == static_cast<std::size_t>(count));
        for (const auto& body : bodies)
            if (!body.is_static()) CHECK(body.velocity[1] == Approx(60));
        CHECK(sweeper.steps() <= 60 * bodies.size());
    }
}

TEST_CASE("where nothing is fast nothing is looked at", "[sweep]") {
    Random random(63);
    auto balls = balls_in<2>(random, 50, 3, 1);
    Sweeper<2> sweeper;
    CHECK(sweep(sweeper, balls, 0.01).empty());
    CHECK(sweeper.steps() == 0);
}
