// What fast balls run into, against their motion worked out by formulas.
#include "lodlab/core/frame/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/property.hpp"

using namespace lod;
using namespace lodtest;

namespace {

struct Met {
    std::int32_t a = 0;
    std::int32_t b = 0;
    double time = 0;
};

/// When two balls touch that move on lines, at once where they overlap; never: infinity.
template <int Dim>
double touch(const Body<Dim>& a, const Body<Dim>& b) {
    const double never = std::numeric_limits<double>::infinity();
    const Vector<Dim> x = b.position - a.position;
    const Vector<Dim> v = b.velocity - a.velocity;
    const double reach = a.tree->radius[0] + b.tree->radius[0];
    const double p = x.dot(v) / v.squaredNorm();
    const double q = (x.squaredNorm() - reach * reach) / v.squaredNorm();
    if (!(x.dot(v) < 0) || p * p < q) return never;
    return std::max(0.0, -p - std::sqrt(p * p - q));
}

/// All impacts of balls of one mass in h seconds, e = 1, by asking all pairs after each of which
/// one moves further in h seconds than it is thick.
template <int Dim>
std::vector<Met> all_impacts(std::vector<Body<Dim>> balls, double h) {
    std::vector<Met> met;
    const auto is_fast = [&](const Body<Dim>& ball) {
        return h * ball.velocity.norm() > 2 * ball.tree->radius[0];
    };
    for (double now = 0;;) {
        Met next{0, 0, h - now};
        for (std::size_t a = 0; a < balls.size(); ++a)
            for (std::size_t b = a + 1; b < balls.size(); ++b)
                if (!is_fast(balls[a]) && !is_fast(balls[b]))
                    continue;
                else if (const double time = touch(balls[a], balls[b]); time < next.time)
                    next = {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), time};
        for (auto& ball : balls) ball.position += next.time * ball.velocity;
        now += next.time;
        if (next.b == 0) return met;
        met.push_back({next.a, next.b, now});
        Body<Dim>& a = balls[static_cast<std::size_t>(next.a)];
        Body<Dim>& b = balls[static_cast<std::size_t>(next.b)];
        const Vector<Dim> n = (b.position - a.position).normalized();
        const Vector<Dim> swap = n.dot(b.velocity - a.velocity) * n;
        a.velocity += swap;
        b.velocity -= swap;
    }
}

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

TEMPLATE_TEST_CASE_SIG("fast balls run into each other as their formulas say", "[sweep]",
                       ((int Dim), Dim), 2, 3) {
    check_property(61, 200, [](std::uint64_t seed) {
        Random random(seed);
        auto balls = balls_in<Dim>(random, 25, 1.2, 60);
        const auto expected = all_impacts<Dim>(balls, 0.01);
        Sweeper<Dim> sweeper;
        const auto found = sweep(sweeper, balls, 0.01);
        const std::size_t told = std::min(expected.size(), found.size());
        // Later ones depend on those before ever more: the first ten are to be the same.
        RC_ASSERT(expected.size() == found.size() || told >= 10u);
        for (std::size_t i = 0; i < std::min<std::size_t>(told, 10); ++i) {
            RC_ASSERT(found[i].a == expected[i].a);
            RC_ASSERT(found[i].b == expected[i].b);
            RC_ASSERT(std::abs(found[i].time - expected[i].time) < 1e-9);
        }
    });
}

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
