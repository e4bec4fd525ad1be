#include "lodlab/core/frame/finest.hpp"

#include <cmath>
#include <limits>

#include "lodlab/core/frame/frame.hpp"
#include "tests/catch.hpp"
#include "tests/core/exact/exact_bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// A unit box with a tree of three levels and its exact shape.
template <int Dim>
Body<Dim> square(Planar x, Planar v = {0, 0}, double w = 0, double angle = 0) {
    auto body = with_box<Dim>(planar_body<Dim>(1, 1.0 / 6, x, v, w), 1, 1, angle);
    body.tree = box_tree<Dim>(1, 1, 3);
    return body;
}

template <int Dim>
Body<Dim> floor_box() {
    auto body = static_box<Dim>(8, 1, {0, -0.5});
    body.tree = box_tree<Dim>(8, 1, 5);
    return body;
}

FrameSettings settings_with(Finest level, double time_step = 1.0 / 60) {
    FrameSettings settings;
    settings.time_step = time_step;
    settings.finest.level = level;
    return settings;
}

/// Runs frames without a limit and returns the record of the last one that had contacts.
template <int Dim>
FrameRecord<Dim> run_frames(std::vector<Body<Dim>>& bodies, const FrameSettings& settings,
                            int frames) {
    FrameStorage<Dim> storage;
    FrameRecord<Dim> last;
    for (int k = 0; k < frames; ++k) {
        Budget budget = Budget::unlimited();
        const auto& record = advance<Dim>(bodies, settings, budget, storage);
        if (!record.impacts.empty()) last = record;
    }
    return last;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("exact contact denies a collision that only the leaves see", "[finest]",
                       ((int Dim), Dim), 2, 3) {
    // The balls of the deepest level stand 0.026 m out of the boxes.
    const std::vector<Body<Dim>> start{square<Dim>({0, 0}, {1, 0}), square<Dim>({1.03, 0})};
    auto bodies = start;
    auto record = run_frames<Dim>(bodies, settings_with(Finest::leaves), 1);
    CHECK(bodies[1].velocity[0] > 0.5);
    for (const Finest level : {Finest::exact, Finest::backtrack}) {
        bodies = start;
        FrameStorage<Dim> storage;
        Budget budget = Budget::unlimited();
        record = advance<Dim>(bodies, settings_with(level), budget, storage);
        REQUIRE(record.pairs.size() == 1);
        CHECK(record.pairs[0].verdict == Verdict::apart);
        CHECK(record.pairs[0].finest == Finest::exact);
        CHECK(record.impacts.empty());
        CHECK(bodies[0].velocity == start[0].velocity);
    }
}

TEMPLATE_TEST_CASE_SIG("a backtracked body bounces as though time had no steps", "[finest]",
                       ((int Dim), Dim), 2, 3) {
    // A flat fall from 0.3 m over the floor at 2 m/s: 0.15 s down, then up.
    for (const double step : {1.0 / 30, 1.0 / 60, 1.0 / 97}) {
        std::vector<Body<Dim>> bodies{floor_box<Dim>(), square<Dim>({0.3, 0.8}, {0.5, -2})};
        const int frames = static_cast<int>(std::lround(0.4 / step));
        const auto record = run_frames<Dim>(bodies, settings_with(Finest::backtrack, step), frames);
        REQUIRE(record.pairs.size() == 1);
        CHECK(record.pairs[0].finest == Finest::backtrack);
        CHECK(record.pairs[0].impact_time <= 0);
        CHECK(record.pairs[0].impact_time > -step);
        CHECK(record.impacts.size() == (Dim == 2 ? 2 : 4));
        const double seconds = frames * step;
        const Vector<Dim> there = planar<Dim>(0.3 + 0.5 * seconds, 0.5 + 2 * (seconds - 0.15));
        CHECK((bodies[1].position - there).norm() < 1e-8);
        CHECK((bodies[1].velocity - planar<Dim>(0.5, 2)).norm() < 1e-12);
        CHECK(bodies[1].spin.norm() < 1e-12);
    }
}

TEMPLATE_TEST_CASE_SIG("a backtracked corner turns as the exact case says, at any step", "[finest]",
                       ((int Dim), Dim), 2, 3) {
    const double angle = std::numbers::pi / 4 + std::asin(0.25 / std::sqrt(0.5));
    const auto thrown = square<Dim>({0, 1.2}, {0, -1}, 0, angle);
    const auto touch = time_of_impact<Dim>(floor_box<Dim>(), thrown);
    REQUIRE(touch.outcome == ImpactOutcome::touching);
    for (const double step : {1.0 / 10, 1.0 / 60}) {
        std::vector<Body<Dim>> bodies{floor_box<Dim>(), thrown};
        const int frames = static_cast<int>(std::ceil(touch.time / step)) + 2;
        run_frames<Dim>(bodies, settings_with(Finest::backtrack, step), frames);
        CHECK(std::abs(bodies[1].velocity[1] - 5.0 / 11) < 1e-8);
        CHECK(std::abs(planar_spin(bodies[1]) - 24.0 / 11) < 1e-8);
        const double since = frames * step - touch.time;
        CHECK(std::abs(bodies[1].position[1] - (touch.b.position[1] + since * 5.0 / 11)) < 1e-8);
    }
}

TEMPLATE_TEST_CASE_SIG("without backtracking exact contacts stand where the bodies are now",
                       "[finest]", ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies{floor_box<Dim>(), square<Dim>({0.3, 0.495}, {0.5, -2})};
    FrameStorage<Dim> storage;
    Budget budget = Budget::unlimited();
    const auto& record = detect<Dim>(bodies, settings_with(Finest::exact), budget, storage);
    REQUIRE(record.pairs[0].finest == Finest::exact);
    CHECK(std::abs(record.pairs[0].impact_time + 0.0025) < 1e-9);
    REQUIRE(record.impacts.size() == (Dim == 2 ? 2 : 4));
    for (const auto& impact : record.impacts) {
        CHECK((impact.contact.normal - planar<Dim>(0, 1)).norm() < 1e-12);
        CHECK(std::abs(impact.contact.depth - 0.005) < 1e-9);
        CHECK(std::abs(impact.contact.point[1] + 0.0025) < 1e-9);
    }
    for (const Range& nodes : record.contact_nodes) CHECK(nodes.count == 0);
}

TEMPLATE_TEST_CASE_SIG("bodies that were pushed and still overlap part undisturbed", "[finest]",
                       ((int Dim), Dim), 2, 3) {
    for (const Finest level : {Finest::exact, Finest::backtrack}) {
        std::vector<Body<Dim>> bodies{floor_box<Dim>(), square<Dim>({0.3, 0.495}, {0.5, 2})};
        const auto record = run_frames<Dim>(bodies, settings_with(level), 1);
        CHECK(record.pairs[0].finest == Finest::exact);
        CHECK(record.pairs[0].impact_time > 0);
        CHECK((bodies[1].velocity - planar<Dim>(0.5, 2)).norm() == 0);
    }
}

TEMPLATE_TEST_CASE_SIG("bodies that have long overlapped keep their leaves' contacts", "[finest]",
                       ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies{square<Dim>({0, 0}, {0.01, 0}), square<Dim>({0.5, 0.1})};
    auto leaves = bodies;
    const auto record = run_frames<Dim>(bodies, settings_with(Finest::exact), 1);
    const auto expected = run_frames<Dim>(leaves, settings_with(Finest::leaves), 1);
    CHECK(record.pairs[0].finest == Finest::leaves);
    CHECK(record.node_pairs == expected.node_pairs);
    CHECK(bodies[0].velocity == leaves[0].velocity);
}

TEMPLATE_TEST_CASE_SIG("a body in two collisions is not backtracked", "[finest]", ((int Dim), Dim),
                       2, 3) {
    // It sinks into the floor and into a wall in the same frame.
    auto wall = static_box<Dim>(1, 8, {2.3, 4.1});
    wall.tree = box_tree<Dim>(1, 8, 5);
    std::vector<Body<Dim>> bodies{floor_box<Dim>(), square<Dim>({1.305, 0.495}, {1, -1}), wall};
    const auto record = run_frames<Dim>(bodies, settings_with(Finest::backtrack), 1);
    REQUIRE(record.pairs.size() == 2);
    for (const PairRecord& pair : record.pairs) CHECK(pair.finest == Finest::exact);
    CHECK(bodies[1].velocity[0] < 0);
    CHECK(bodies[1].velocity[1] > 0);
}

TEMPLATE_TEST_CASE_SIG("whether bodies collide elsewhere costs a look at each pair", "[finest]",
                       ((int Dim), Dim), 2, 3) {
    for (const std::size_t count : {8u, 16u, 32u}) {
        std::vector<Body<Dim>> bodies;  // towers of two that fall together, each on its own
        for (std::size_t k = 0; k < count; ++k) {
            bodies.push_back(square<Dim>({3.0 * static_cast<double>(k), 0}));
            bodies.push_back(square<Dim>({3.0 * static_cast<double>(k), 0.99}, {0, -2}));
        }
        FrameSettings settings = settings_with(Finest::backtrack);
        settings.finest.most_pairs = std::numeric_limits<int>::max();
        FrameStorage<Dim> storage;
        Budget budget = Budget::unlimited();
        const auto& record = detect<Dim>(bodies, settings, budget, storage);
        REQUIRE(record.pairs.size() == count);
        for (const PairRecord& pair : record.pairs) CHECK(pair.finest == Finest::backtrack);
        CHECK(storage.true_shapes.steps() == 3 * count);
    }
}

TEMPLATE_TEST_CASE_SIG("the finest detail goes to the highest priorities only", "[finest]",
                       ((int Dim), Dim), 2, 3) {
    // Five boxes sink into the floor, the last the fastest.
    std::vector<Body<Dim>> bodies{floor_box<Dim>()};
    for (int k = 0; k < 5; ++k)
        bodies.push_back(square<Dim>({-3.0 + 1.5 * k, 0.499}, {0, -std::pow(3.0, k)}));
    FrameSettings settings = settings_with(Finest::exact);
    FrameStorage<Dim> storage;
    for (int most = 0; most <= 6; ++most) {
        settings.finest.most_pairs = most;
        Budget budget = Budget::unlimited();
        const auto& record = detect<Dim>(bodies, settings, budget, storage);
        REQUIRE(record.pairs.size() == 5);
        for (std::size_t k = 0; k < 5; ++k) {
            const bool served = static_cast<int>(k) >= 5 - most;
            CHECK(record.pairs[k].finest == (served ? Finest::exact : Finest::leaves));
        }
    }
    // And to nobody where refinement must stop above the leaves.
    settings.deepest_level = 3;
    Budget budget = Budget::unlimited();
    for (const auto& pair : detect<Dim>(bodies, settings, budget, storage).pairs)
        CHECK(pair.finest == Finest::leaves);
}

TEMPLATE_TEST_CASE_SIG("a frame cut anywhere plays again from its cut", "[finest]",
                       ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> start{floor_box<Dim>()};
    for (int k = 0; k < 3; ++k)
        start.push_back(square<Dim>({-3.0 + 1.5 * k, 0.499}, {0.1 * k, -1.0 - k}, 0.01 * k));
    FrameSettings settings = settings_with(Finest::backtrack);
    settings.finest.cost = 50;
    const auto frame_of = [&](Budget budget, FrameRecord<Dim>& record, std::uint64_t& spent) {
        auto bodies = start;
        FrameStorage<Dim> storage;
        record = advance<Dim>(bodies, settings, budget, storage);
        spent = record.tests;
        return bodies;
    };
    FrameRecord<Dim> whole;
    std::uint64_t most = 0;
    frame_of(Budget::unlimited(), whole, most);
    CHECK_FALSE(whole.interrupted());
    int partly = 0;
    for (std::uint64_t quota = 3; quota <= most + 100; quota += 7)
        for (const double contact_cost : {0.0, 5.0}) {
            FrameRecord<Dim> cut;
            std::uint64_t spent = 0;
            const auto bodies = frame_of(Budget::node_tests(quota, contact_cost), cut, spent);
            FrameRecord<Dim> again;
            std::uint64_t spent_again = 0;
            const auto repeated = frame_of(cut.cut ? Budget::until(*cut.cut) : Budget::unlimited(),
                                           again, spent_again);
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                CHECK(bodies[i].position == repeated[i].position);
                CHECK(bodies[i].velocity == repeated[i].velocity);
            }
            CHECK(spent == spent_again);
            const auto served = std::ranges::count_if(
                cut.pairs, [](const PairRecord& pair) { return pair.finest != Finest::leaves; });
            partly += served > 0 && served < 3;
        }
    CHECK(partly > 0);
}

TEMPLATE_TEST_CASE_SIG("a box slides on over a row of tiles that it touches exactly", "[finest]",
                       ((int Dim), Dim), 2, 3) {
    for (const Finest level : {Finest::exact, Finest::backtrack})
        for (const double speed : {2.0, -2.0}) {
            std::vector<Body<Dim>> bodies{square<Dim>({0, 1}, {speed, 0})};
            for (int tile = -3; tile <= 3; ++tile) {
                bodies.push_back(static_box<Dim>(1, 1, {static_cast<double>(tile), 0}));
                bodies.back().tree = box_tree<Dim>(1, 1, 3);
            }
            // In space a query of what rests takes some ms: over one seam of tiles is enough.
            run_frames<Dim>(bodies, settings_with(level), Dim == 2 ? 60 : 16);
            CAPTURE(speed);
            CHECK((bodies[0].velocity - planar<Dim>(speed, 0)).norm() <= 1e-9);
            CHECK(std::abs(bodies[0].position[1] - 1) <= 1e-9);
        }
}

TEMPLATE_TEST_CASE_SIG("a box that slides into the corner of a floor and a wall is thrown back",
                       "[finest]", ((int Dim), Dim), 2, 3) {
    // It touches the floor exactly and meets the wall's foot: that is no corner to pass by.
    std::vector<Body<Dim>> bodies{square<Dim>({0, 0.5}, {2, 0}), floor_box<Dim>(),
                                  static_box<Dim>(1, 2, {1.5, 1})};
    bodies[2].tree = box_tree<Dim>(1, 2, 4);
    run_frames<Dim>(bodies, settings_with(Finest::backtrack), 60);
    CHECK(bodies[0].velocity[0] <= -1.9);
    CHECK(bodies[0].position[0] <= 0.5);
}
