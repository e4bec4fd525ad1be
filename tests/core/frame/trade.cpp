#include "lodlab/core/frame/schedule/trade.hpp"

#include "lodlab/core/frame/state_hash.hpp"

#include "tests/catch.hpp"
#include "tests/core/frame/heap.hpp"

using namespace lod;
using namespace lodtest;

namespace {

const std::vector<CandidatePair> pairs{{0, 1}, {0, 2}, {1, 2}, {3, 4}};

}  // namespace

TEST_CASE("a pair gives up a level for one that gains more with the same tests", "[trade]") {
    Trade trade;
    trade.held = {{{0, 1}, 3, 100, 50, 0.1, 0.01},   // gives .1 m for 100 tests
                  {{0, 2}, 2, 40, 90, 0.4, 0.3},     // takes .3 m for 90
                  {{1, 2}, 1, 10, 40, 0.5, 0.001}};  // its level is worth more than all
    std::vector<std::int32_t> targets;
    trade.plan(pairs, targets);
    CHECK(trade.trades() == 1);
    CHECK(targets == std::vector<std::int32_t>{2, 3, 1, -1});  // the last pair is new
}

TEST_CASE("several small levels pay for a large one, while that gains", "[trade]") {
    Trade trade;
    trade.held = {
        {{0, 1}, 3, 50, 0, 0.1, 0}, {{0, 2}, 3, 50, 0, 0.1, 0}, {{1, 2}, 1, 0, 90, 0, 0.3}};
    std::vector<std::int32_t> targets;
    trade.plan(pairs, targets);
    CHECK(targets == std::vector<std::int32_t>{2, 2, 2, -1});

    trade.held[2].next_fall = 0.19;  // less than the two lose
    trade.plan(pairs, targets);
    CHECK(targets == std::vector<std::int32_t>{3, 3, 1, -1});
    trade.held[2].next_fall = 0.3;
    trade.held[2].next_tests = 101;  // more than both free
    trade.plan(pairs, targets);
    CHECK(targets == std::vector<std::int32_t>{3, 3, 1, -1});
    CHECK(trade.trades() == 0);
}

TEST_CASE("no pair trades with itself, and pairs that are gone are forgotten", "[trade]") {
    Trade trade;
    trade.held = {{{0, 3}, 5, 10, 10, 0.1, 9}, {{3, 4}, 2, 10, 10, 0.1, 0.5}};
    std::vector<std::int32_t> targets;
    trade.plan(pairs, targets);
    CHECK(targets == std::vector<std::int32_t>{-1, -1, -1, 2});
    trade.plan({}, targets);
    CHECK(targets.empty());
}

TEMPLATE_TEST_CASE_SIG("a run that trades goes on from what it remembers", "[trade]",
                       ((int Dim), Dim), 2, 3) {
    const auto frames = [](std::vector<Body<Dim>>& bodies, FrameStorage<Dim>& storage, int count) {
        for (int frame = 0; frame < count; ++frame) {
            Budget budget = Budget::node_tests(400);
            advance<Dim>(bodies, {.priority = Priority::trade}, budget, storage);
        }
        return state_hash<Dim>(bodies);
    };
    auto bodies = heap<Dim>(311);
    FrameStorage<Dim> storage;
    frames(bodies, storage, 20);
    auto loaded = bodies;
    FrameStorage<Dim> fresh;
    fresh.scheduler.trade.held = storage.scheduler.trade.held;
    CHECK_FALSE(fresh.scheduler.trade.held.empty());
    CHECK(frames(loaded, fresh, 20) == frames(bodies, storage, 20));
}
