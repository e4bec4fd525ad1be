// Crowds whose time is over anywhere in a frame: in entry levels, contacts, rounds of the response.
#include "lodlab/core/frame/state_hash.hpp"
#include "tests/catch.hpp"
#include "tests/core/executors.hpp"
#include "tests/interrupted_crowds.hpp"

namespace {

using namespace std::chrono_literals;

/// A crowd of the plane in which many pairs touch.
std::vector<lod::Body<2>> dense(const char* spec) {
    scenes::Scene scene = scenes::crowd(spec);
    for (scenes::BodySpec& body : scene.bodies) {
        if (body.shape == scenes::half_space_name) continue;
        body.builder = "quadtree";
        body.depth = 2;
    }
    lodtest::Crowd<2> crowd(scene);
    crowd.run(5);
    return crowd.instant(0.8, false).bodies;
}

/// Frames by what their time did not suffice for.
struct Cuts {
    int frames = 0;
    int entered = 0;  ///< some pairs, not all
    int modelled = 0;
    int rounds = 0;

    void count(const lod::FrameRecord<2>& record) {
        ++frames;
        if (!record.cut) return;
        entered += record.cut->entered.value_or(0) > 0 && record.spending.levels.by_roots > 0;
        modelled += record.cut->modelled.has_value();
        rounds += record.cut->rounds.has_value();
    }
};

/// The record of a frame by a clock of one's own, and the bodies after it.
struct Framed {
    lod::FrameStorage<2> storage;
    std::vector<lod::Body<2>> bodies;

    const lod::FrameRecord<2>& run(lod::Budget budget, const lod::FrameSettings& settings,
                                   lod::Executor* executor = nullptr) {
        storage.executor = executor;
        return lod::advance<2>(bodies, settings, budget, storage);
    }
};

/// Calls visit with frames that the clock ended at every look, under several quotas and policies.
template <class Visit>
Cuts each_frame_on_clock(const std::vector<lod::Body<2>>& bodies, lod::Executor* executor,
                         const Visit& visit) {
    Cuts cuts;
    for (const lod::Priority priority : lod::choices<lod::Priority>())
        for (const auto quota : {1us, 20us, 60us, 100us, 1000us})
            for (int leap = 2; leap < 60; ++leap) {
                const lodtest::LeapingClock clock(leap);
                const lod::FrameSettings settings{.time_step = 1.0 / 60, .priority = priority};
                Framed framed{{}, bodies};
                const auto& record =
                    framed.run(lod::Budget::deadline(clock, quota, 250ns), settings, executor);
                cuts.count(record);
                visit(framed, record, settings);
                if (!clock.leapt()) break;
            }
    return cuts;
}

}  // namespace

TEST_CASE("a crowd's frame whose time is over anywhere plays again from its record",
          "[interruption]") {
    lodtest::ShuffledExecutor three(3);
    const auto bodies = dense("gas:90");
    for (lod::Executor* const executor :
         {static_cast<lod::Executor*>(nullptr), static_cast<lod::Executor*>(&three)}) {
        const Cuts cuts = each_frame_on_clock(
            bodies, executor,
            [&](const Framed& live, const lod::FrameRecord<2>& record, const auto& settings) {
                Framed again{{}, bodies};
                const auto& repeated = again.run(
                    record.cut ? lod::Budget::until(*record.cut) : lod::Budget::unlimited(),
                    settings);
                REQUIRE(repeated.cut == record.cut);
                REQUIRE(lod::state_hash<2>(again.bodies) == lod::state_hash<2>(live.bodies));
                REQUIRE(repeated.impacts.size() == record.impacts.size());
                REQUIRE(repeated.tests == record.tests);
            });
        CAPTURE(cuts.frames);
        CHECK(cuts.entered > 20);
        CHECK(cuts.modelled > 20);
        CHECK(cuts.rounds > 20);
    }
}

TEST_CASE("whatever there was no time for, no pair goes unanswered and no energy comes or goes",
          "[interruption]") {
    const auto bodies = dense("gas:60");
    each_frame_on_clock(
        bodies, nullptr, [&](const Framed& live, const lod::FrameRecord<2>& record, const auto&) {
            for (const lod::PairRecord& pair : record.pairs)
                REQUIRE((pair.verdict == lod::Verdict::apart) == (pair.nodes.count == 0));
            REQUIRE(record.spending.levels.by_roots <= live.storage.fronts.meeting);
            REQUIRE(std::abs(record.energy_after - record.energy_before) <=
                    1e-12 * record.energy_before);
        });
}

TEST_CASE("a pair that was not taken to its entry level touches as its root balls do",
          "[interruption]") {
    const auto bodies = dense("rain:60");
    const lodtest::LeapingClock clock(2);  // over at once
    Framed framed{{}, bodies};
    const auto& record = framed.run(lod::Budget::deadline(clock, 1ms, 250ns), {});
    REQUIRE(record.cut);
    CHECK(record.cut->entered == 0U);
    CHECK(record.spending.levels.by_roots == framed.storage.fronts.meeting);
    int touching = 0;
    for (const lod::PairRecord& pair : record.pairs) {
        CHECK(pair.level == 0);
        if (pair.verdict == lod::Verdict::apart) continue;
        ++touching;
        REQUIRE(pair.contact_count == 1);
        const auto& contact = record.impacts[lod::at(pair.first_contact)].contact;
        const lod::PosedTree<2>& a = framed.storage.world_S[lod::at(pair.bodies.a)];
        const lod::PosedTree<2>& b = framed.storage.world_S[lod::at(pair.bodies.b)];
        if (a.is_half_space() || b.is_half_space()) {
            const lod::PosedTree<2>& ball = a.is_half_space() ? b : a;
            const lod::PosedTree<2>& wall = a.is_half_space() ? a : b;
            CHECK(contact.depth == ball.root().radius - wall.half_space().side(ball.root().centre));
            continue;
        }
        const lod::Vector<2> line = b.root().centre - a.root().centre;
        CHECK(contact.depth == a.root().radius + b.root().radius - line.norm());
        CHECK((contact.normal - line / line.norm()).norm() < 1e-15);
    }
    CHECK(touching > 30);
}
