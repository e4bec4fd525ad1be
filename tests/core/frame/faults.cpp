// Quotas, clocks, trees and crowds at the ends of what there is: each has a defined result.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "tests/catch.hpp"
#include "tests/core/frame/clock.hpp"
#include "tests/core/frame/heap.hpp"
#include "tests/core/frame/policies.hpp"

using namespace lod;
using namespace lodtest;
using namespace std::chrono_literals;

namespace {

template <int Dim>
std::uint64_t run(std::vector<Body<Dim>> bodies, const FrameSettings& settings,
                  const Budget& budget, FrameRecord<Dim>& record) {
    FrameStorage<Dim> storage;
    Budget of_frame = budget;
    record = advance<Dim>(bodies, settings, of_frame, storage);
    return state_hash<Dim>(bodies);
}

/// A chain of balls, each of one child: a tree of depth `depth`.
template <int Dim>
std::shared_ptr<const SphereTree<Dim>> chain(int depth) {
    std::vector<TreeNode<Dim>> nodes(static_cast<std::size_t>(depth) + 1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        nodes[i].sphere.radius = 1 - 0.02 * static_cast<double>(i);
        if (i + 1 < nodes.size()) nodes[i].children = {static_cast<int>(i + 1)};
    }
    return std::make_shared<SphereTree<Dim>>(lay_out<Dim>(std::span<const TreeNode<Dim>>(nodes)));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("with nothing to spend, by count or on a clock, level 0 is done and no more",
                       "[faults]", ((int Dim), Dim), 2, 3) {
    const auto bodies = heap<Dim>(321);
    FrameRecord<Dim> record;
    const std::uint64_t roots = run<Dim>(bodies, {.deepest_level = 0}, Budget::unlimited(), record);
    FakeClock clock;
    clock.step = 1ns;
    clock.time = 1h;
    for (const Priority priority : policies) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const Budget& budget :
             {Budget::node_tests(0), Budget::node_tests(1000, nan),
              Budget::node_tests(1000, std::numeric_limits<double>::infinity()),
              Budget::deadline(clock, 0ns), Budget::deadline(clock, -5ms),
              Budget::deadline(clock, 1ns), Budget::deadline(clock, 1ms, 1h)}) {
            CHECK(run<Dim>(bodies, {.priority = priority}, budget, record) == roots);
            CHECK(record.interrupted());
            CHECK(record.spending.levels.finished == 0);
            CHECK(record.spending.levels.skipped + record.spending.levels.dropped > 0);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("with more than enough, by count or on a clock, every level is done",
                       "[faults]", ((int Dim), Dim), 2, 3) {
    const auto bodies = heap<Dim>(322);
    FrameRecord<Dim> record;
    const std::uint64_t all = run<Dim>(bodies, {}, Budget::unlimited(), record);
    FakeClock slow;
    slow.step = 1us;
    const FakeClock stands_still;
    for (const Priority priority : policies) {
        const std::uint64_t most = (std::numeric_limits<std::uint64_t>::max)();
        for (const Budget& budget :
             {Budget::node_tests(most), Budget::node_tests(most, 1e6), Budget::deadline(slow, 1h),
              Budget::deadline(slow, (std::chrono::nanoseconds::max)(), 250ns),
              Budget::deadline(stands_still, 1ms)}) {
            CHECK(run<Dim>(bodies, {.priority = priority}, budget, record) == all);
            CHECK_FALSE(record.interrupted());
        }
    }
}

TEMPLATE_TEST_CASE_SIG(
    "a clock that jumps back or ahead within a frame leaves a frame that repeats", "[faults]",
    ((int Dim), Dim), 2, 3) {
    /// Jumps back and ahead by the second at every third look.
    struct Jumping final : Clock {
        mutable int looks = 0;
        int first;
        explicit Jumping(int first_jump) : first(first_jump) {}
        std::chrono::nanoseconds now() const override {
            ++looks;
            const auto steady = 10s + looks * 50ns;
            if (looks < first || looks % 3 != 0) return steady;
            return looks % 2 == 0 ? steady - 1s : steady + 1s;
        }
    };
    const auto bodies = heap<Dim>(323);
    FrameRecord<Dim> record;
    for (int first = 1; first < 40; ++first) {
        const Jumping clock(first);
        const std::uint64_t live = run<Dim>(bodies, {}, Budget::deadline(clock, 20us), record);
        const Budget again = record.cut ? Budget::until(*record.cut) : Budget::unlimited();
        CHECK(run<Dim>(bodies, {}, again, record) == live);
    }
}

TEMPLATE_TEST_CASE_SIG("many bodies at one place keep a quota beyond level 0 of every pair",
                       "[faults]", ((int Dim), Dim), 2, 3) {
    Random random(324);
    std::vector<Body<Dim>> bodies;
    const auto tree = random_tree<Dim>(random, 2, 4);
    for (int i = 0; i < 60; ++i) {
        bodies.push_back(random_body<Dim>(random));
        bodies.back().position = Vector<Dim>::Zero();
        bodies.back().tree = tree;
    }
    const std::uint64_t pairs = 60 * 59 / 2;
    FrameRecord<Dim> record;
    for (const Priority priority : policies)
        for (const std::uint64_t quota : {std::uint64_t{0}, pairs, pairs + 5000}) {
            run<Dim>(bodies, {.priority = priority}, Budget::node_tests(quota), record);
            CHECK(record.pairs.size() == pairs);
            CHECK(record.tests <= std::max(quota, pairs));
            CHECK(record.interrupted());
        }
}

TEMPLATE_TEST_CASE_SIG("trees of one node and of depth 30 meet under every policy", "[faults]",
                       ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies{disc<Dim>(1, 1, {0, 0}), disc<Dim>(1, 1, {0.5, 0}),
                                  disc<Dim>(1, 1, {0.2, 0.1})};
    bodies[2].tree = chain<Dim>(30);
    FrameRecord<Dim> record;
    const std::uint64_t all = run<Dim>(bodies, {}, Budget::unlimited(), record);
    for (const Priority priority : policies) {
        CHECK(run<Dim>(bodies, {.priority = priority}, Budget::node_tests(1000), record) == all);
        CHECK(record.pairs[0].level == 0);  // two single balls
        CHECK(record.pairs[1].level == 30);
        // One test a level: half of them are there after half of the tests.
        run<Dim>(bodies, {.priority = priority}, Budget::node_tests(3 + 30), record);
        CHECK(record.pairs[1].level + record.pairs[2].level == 30);
    }
}

TEMPLATE_TEST_CASE_SIG("more bodies at one place than a frame takes are refused in a line",
                       "[faults]", ((int Dim), Dim), 2, 3) {
    // 10,000 bodies make 50 million pairs; where half of them stand still, 37 million.
    for (const bool half_stands : {true, false}) {
        std::vector<Body<Dim>> bodies(10'000, disc<Dim>(1, 1, {3, 4}, {1, 0}));
        if (half_stands)
            for (std::size_t i = 1; i < bodies.size(); i += 2) make_static(bodies[i]);
        const std::uint64_t before = state_hash<Dim>(bodies);
        FrameStorage<Dim> storage;
        Budget none = Budget::node_tests(0);
        try {
            advance<Dim>(bodies, {}, none, storage);
            FAIL("were taken");
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::limit_exceeded);
            CHECK(std::string(error.what()) ==
                  "more than 4194304 pairs of bodies are near each other, more than a frame takes; "
                  "move the bodies apart, or take fewer");
        }
        CHECK(state_hash<Dim>(bodies) == before);
        // The storage serves on.
        bodies.resize(2);
        CHECK(advance<Dim>(bodies, {}, none, storage).pairs.size() == 1);
    }
}

TEMPLATE_TEST_CASE_SIG("bodies 1e9 m away meet as they do at the origin", "[faults]",
                       ((int Dim), Dim), 2, 3) {
    // Sixteenths are exact there, and so are all sums of this motion.
    const auto meet = [](double far, const Budget& budget) {
        std::vector<Body<Dim>> bodies{disc<Dim>(1, 1, {far, far}, {1, 0}),
                                      disc<Dim>(1, 1, {far + 1.5, far}, {-1, 0}),
                                      disc<Dim>(1, 1, {-3, 0})};
        FrameStorage<Dim> storage;
        Budget of_frame = budget;
        const auto& record = advance<Dim>(bodies, {.time_step = 1.0 / 16}, of_frame, storage);
        CHECK(record.pairs.size() == 1);
        CHECK(record.impacts.size() == 1);
        CHECK(bodies[0].velocity == planar<Dim>(-1, 0));
        CHECK(bodies[1].velocity == planar<Dim>(1, 0));
        CHECK(bodies[0].position == planar<Dim>(far - 1.0 / 16, far));
        CHECK(bodies[2].position == planar<Dim>(-3, 0));
    };
    for (const double far : {0.0, 1e9, -1e9})
        for (const Budget& budget : {Budget::unlimited(), Budget::node_tests(0)}) meet(far, budget);
}

TEMPLATE_TEST_CASE_SIG("trees that overlap 1e9 m away are not called apart", "[faults]",
                       ((int Dim), Dim), 2, 3) {
    auto bodies = heap<Dim>(325);
    FrameRecord<Dim> near;
    run<Dim>(bodies, {}, Budget::unlimited(), near);
    for (Body<Dim>& body : bodies) body.position += planar<Dim>(1e9, -1e9);
    FrameRecord<Dim> far;
    for (const Priority priority : policies) {
        run<Dim>(bodies, {.priority = priority}, Budget::node_tests(2000), far);
        for (const PairRecord& pair : near.pairs) {
            if (pair.verdict == Verdict::apart) continue;
            const auto found = std::find_if(far.pairs.begin(), far.pairs.end(),
                                            [&](const auto& p) { return p.bodies == pair.bodies; });
            REQUIRE(found != far.pairs.end());
            CHECK(found->verdict != Verdict::apart);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a frame of no time answers contacts and moves nothing", "[faults]",
                       ((int Dim), Dim), 2, 3) {
    const auto start = heap<Dim>(326);
    for (const Priority priority : policies)
        for (const Budget& budget : {Budget::unlimited(), Budget::node_tests(500)}) {
            auto bodies = start;
            FrameStorage<Dim> storage;
            Budget of_frame = budget;
            const FrameSettings settings{.time_step = 0, .priority = priority};
            const auto& record = advance<Dim>(bodies, settings, of_frame, storage);
            CHECK_FALSE(record.impacts.empty());
            CHECK(record.energy_after <= record.energy_before * (1 + 1e-12));
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                CHECK(bodies[i].position == start[i].position);
                CHECK(std::isfinite(bodies[i].velocity.norm()));
            }
        }
}

TEST_CASE("more node pairs than a frame takes are refused before there is room for them",
          "[faults]") {
    FrontList list;
    CHECK_THROWS_WITH(list.room_for(FrontList::most + 1),
                      contains("pairs of nodes overlap at once, more than a frame takes; give it a "
                               "quota or a level, or move the bodies apart"));
    CHECK(list.room_for(100) != nullptr);
}
