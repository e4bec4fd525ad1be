#include "lodlab/measure/collisions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/measure/plane_bodies.hpp"
#include "lodlab/scenes/setup.hpp"
#include "tests/catch.hpp"
#include "tests/measure/collision.hpp"
#include "tests/random.hpp"

using namespace measure;
using measuretest::collision_at;
using measuretest::GivenShapes;
using measuretest::unit_body;

namespace {

using Bodies = std::vector<lod::Body<2>>;
using Collisions = std::vector<Collision<2>>;

Collisions at_times(const std::vector<double>& times) {
    Collisions collisions;
    for (const double time : times) collisions.push_back(collision_at(time));
    return collisions;
}

double cost_of(const Matching& matching, const Collisions& reference, const Collisions& seen,
               double window) {
    double cost = window / 2 * static_cast<double>(matching.missing.size() + matching.extra.size());
    for (const auto& [r, s] : matching.pairs)
        cost += std::abs(reference[static_cast<std::size_t>(r)].time -
                         seen[static_cast<std::size_t>(s)].time);
    return cost;
}

/// The least cost of all pairings that keep the order, by trying them all.
double least_cost(const std::vector<double>& r, const std::vector<double>& s, std::size_t i,
                  std::size_t j, double window) {
    if (i == r.size() || j == s.size())
        return window / 2 * static_cast<double>(r.size() - i + s.size() - j);
    return std::min({std::abs(r[i] - s[j]) + least_cost(r, s, i + 1, j + 1, window),
                     window / 2 + least_cost(r, s, i + 1, j, window),
                     window / 2 + least_cost(r, s, i, j + 1, window)});
}

}  // namespace

TEST_CASE("a push looks at one collision, however many there are", "[measure]") {
    for (const int count : {100, 200, 400}) {
        const GivenShapes shapes;
        CollisionLog<2> log(shapes, 0.05);
        const Bodies bodies(static_cast<std::size_t>(count) + 1, unit_body({0, 0}));
        for (const double time : {1.0, 1.02, 2.0})  // each of a chain pushes the next
            for (int k = 0; k < count; ++k) log.add(time, k, k + 1, bodies, bodies);
        CHECK(log.collisions().size() == static_cast<std::size_t>(2 * count));
        CHECK(log.steps() == static_cast<std::uint64_t>(2 * count));
    }
}

TEST_CASE("pushes that follow each other closely are one collision", "[measure]") {
    GivenShapes shapes;
    CollisionLog<2> log(shapes, 0.05);
    const Bodies start{unit_body({1, 0}), unit_body({0, 0}), unit_body({-1, 0})};
    const Bodies middle{unit_body({0.6, 0}), unit_body({0.4, 0}), unit_body({-1, 0})};
    const Bodies end{unit_body({0, 0}), unit_body({1, 0}), unit_body({-1, 0})};
    shapes.apart = 0.02;
    log.add(1.00, 0, 1, start, middle);
    shapes.apart = -0.01;
    log.add(1.02, 2, 0, middle, middle);  // others between do not part them
    log.add(1.04, 1, 0, middle, end);
    shapes.apart = -0.03;
    log.add(1.10, 0, 1, end, start);  // 0.06 s later: another one
    const auto& collisions = log.collisions();
    REQUIRE(collisions.size() == 3);
    CHECK(collisions[0].a == 0);
    CHECK(collisions[0].b == 1);
    CHECK(collisions[0].time == 1.00);
    CHECK(collisions[0].until == 1.04);
    CHECK(collisions[0].gap == 0.02);
    CHECK(collisions[0].penetration == 0.01);
    CHECK(collisions[0].before[0].velocity.x() == 1);
    CHECK(collisions[0].after[0].velocity.x() == 0);
    CHECK(collisions[0].after[1].velocity.x() == 1);
    CHECK(collisions[1].a == 0);
    CHECK(collisions[1].b == 2);
    CHECK(collisions[1].before[1].velocity.x() == -1);
    CHECK(collisions[1].gap == 0);
    CHECK(collisions[2].time == 1.10);
    CHECK(collisions[2].penetration == 0.03);
}

TEST_CASE("two boxes are apart by their gap, or as deep as a corner lies in the other",
          "[measure]") {
    const lod2d::Shape box = lod2d::generate("box:1,1");
    const lod2d::Shape* const boxes[] = {&box, &box};
    const PlaneBodies shapes(boxes);
    CHECK(shapes.size(0) == Approx(std::sqrt(2)));
    lod::Body<2> a = unit_body({0, 0});
    lod::Body<2> b = a;
    b.position = {1.25, 0.3};
    CHECK(shapes.separation(0, a, 1, b) == Approx(0.25));
    b.position = {0.9, 0.3};
    CHECK(shapes.separation(0, a, 1, b) == Approx(-0.1));
    b.position = {0, 1};
    CHECK(shapes.separation(0, a, 1, b) == 0);
}

TEST_CASE("a run by lodlab and one by Box2D show the same collision of two boxes", "[measure]") {
    const auto setup = scenes::set_up<2>(scenes::parse_scene(R"(
        duration = 0.75
        depth = 3
        [[body]]
        shape = "box:1,1"
        velocity = [2, 0]
        mass = 1
        [[body]]
        shape = "box:1,1"
        position = [2, 0.4]
        mass = 1
    )",
                                                             "boxes.toml"));
    const lod2d::Shape* const outlines[] = {setup.shapes[0].get(), setup.shapes[1].get()};
    const PlaneBodies shapes(outlines);
    scenes::RunOptions options;
    options.settings = scenes::frame_settings(setup.scene, {});
    options.frames = setup.scene.frames();
    const auto run = scenes::run(setup.bodies, options);
    const auto box2d =
        lod2d::run_box2d(setup.bodies, outlines, options.frames, options.settings.time_step);

    const Collisions seen = collisions_of<2>(run, setup.bodies, shapes);
    const Collisions reference = collisions_of(box2d, shapes);
    REQUIRE(seen.size() == 1);
    REQUIRE(reference.size() == 1);
    // METHOD.md, case 6: each gets the spin 60/31 and what is left of 2 m/s is 2 - 50/31.
    CHECK(reference[0].after[0].velocity.x() == Approx(2 - 50.0 / 31).epsilon(1e-5));
    CHECK(reference[0].after[1].spin[0] == Approx(60.0 / 31).epsilon(1e-5));
    CHECK(reference[0].time == Approx(0.5).margin(0.001));
    CHECK(reference[0].gap < 0.02 / 16);
    CHECK(seen[0].before[0].velocity == lod::Vector<2>(2, 0));
    const auto total = seen[0].after[0].velocity + seen[0].after[1].velocity;
    CHECK(total.x() == Approx(2));
    CHECK(lod::kinetic_energy<2>(seen[0].after) == Approx(2));
    CHECK(seen[0].time <= 0.5 + options.settings.time_step);
    CHECK(seen[0].gap == Approx(std::max(0.0, 1 - 2 * seen[0].time)).margin(1e-12));

    const Matching matching = match<2>(reference, seen, 0.25);
    CHECK(matching.pairs.size() == 1);
}

TEST_CASE("collisions of two runs are matched by time, the rest is missing or extra", "[measure]") {
    const Collisions reference = at_times({1.0, 2.0, 3.0});
    const Collisions seen = at_times({0.9, 3.1, 3.9});
    const Matching matching = match<2>(reference, seen, 0.25);
    REQUIRE(matching.pairs.size() == 2);
    CHECK(matching.pairs[0].reference == 0);
    CHECK(matching.pairs[0].seen == 0);
    CHECK(matching.pairs[1].reference == 2);
    CHECK(matching.pairs[1].seen == 1);
    CHECK(matching.missing == std::vector<int>{1});
    CHECK(matching.extra == std::vector<int>{2});
}

TEST_CASE("collisions of other bodies are never the same event", "[measure]") {
    const Collisions reference{collision_at(1, 0, 1), collision_at(2, 1, 2)};
    const Collisions seen{collision_at(1, 0, 2), collision_at(2.1, 1, 2)};
    const Matching matching = match<2>(reference, seen, 0.25);
    REQUIRE(matching.pairs.size() == 1);
    CHECK(matching.pairs[0].reference == 1);
    CHECK(matching.missing == std::vector<int>{0});
    CHECK(matching.extra == std::vector<int>{0});
    CHECK(match<2>(Collisions{}, Collisions{}, 0.25).pairs.empty());
}

TEST_CASE("the matching costs as little as any that keeps the order", "[measure]") {
    lodtest::Random random(11);
    for (int round = 0; round < 300; ++round) {
        std::vector<double> times[2];
        for (auto& list : times) {
            for (int n = random.below(5); n > 0; --n) list.push_back(random.in(0, 1));
            std::sort(list.begin(), list.end());
        }
        const double window = random.in(0.05, 0.6);
        const Collisions reference = at_times(times[0]);
        const Collisions seen = at_times(times[1]);
        const Matching matching = match<2>(reference, seen, window);
        INFO("round " << round);
        CHECK(cost_of(matching, reference, seen, window) ==
              Approx(least_cost(times[0], times[1], 0, 0, window)).margin(1e-12));
        CHECK(matching.pairs.size() + matching.missing.size() == reference.size());
        CHECK(matching.pairs.size() + matching.extra.size() == seen.size());
        const Matching swapped = match<2>(seen, reference, window);
        CHECK(swapped.missing.size() == matching.extra.size());
    }
}
