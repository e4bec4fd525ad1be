#include "lodlab/core/tree/budget.hpp"

#include <vector>

#include "tests/catch.hpp"
#include "tests/core/frame/clock.hpp"

using namespace lod;
using namespace std::chrono_literals;
using lodtest::FakeClock;

TEST_CASE("an unlimited budget grants everything and never ends", "[budget]") {
    Budget budget = Budget::unlimited();
    budget.reserve(1000000);
    CHECK(budget.grant(1u << 30) == 1u << 30);
    CHECK(budget.keeps_level(1u << 30));
    CHECK_FALSE(budget.ended());
    CHECK(budget.spent() == 1u << 30);
}

TEST_CASE("a quota of node tests is granted to the last test and not beyond", "[budget]") {
    Budget budget = Budget::node_tests(10);
    CHECK(budget.grant(7) == 7);
    CHECK(budget.grant(3) == 3);
    CHECK_FALSE(budget.refused());
    CHECK(budget.grant(1) == 0);
    CHECK(budget.refused());

    Budget cut = Budget::node_tests(10);
    CHECK(cut.grant(12) == 10);  // the part that fits
    CHECK(cut.refused());
    CHECK(cut.spent() == 10);
    CHECK(cut.grant(1) == 0);
}

TEST_CASE("tests that must be done count, but end nothing by themselves", "[budget]") {
    Budget budget = Budget::node_tests(5);
    budget.spend(9);
    CHECK(budget.spent() == 9);
    CHECK_FALSE(budget.refused());
    CHECK(budget.grant(1) == 0);
    CHECK(budget.refused());
}

TEST_CASE("a level fits where its tests do, and a cheaper one may fit after a dear one",
          "[budget]") {
    Budget budget = Budget::node_tests(100, 2.0);
    budget.reserve(10);
    CHECK(budget.fits(80));
    CHECK(budget.grant(60) == 60);
    CHECK_FALSE(budget.refused());
    CHECK_FALSE(budget.fits(21));
    CHECK(budget.refused());
    CHECK_FALSE(budget.ended());
    CHECK(budget.fits_any(20));
    CHECK_FALSE(budget.fits_any(21));
    CHECK(budget.fits(20));
    CHECK(budget.grant(20) == 20);
    CHECK(budget.tests_left() == 0U);
    CHECK_FALSE(budget.fits_any(1));
}

TEST_CASE("reserved node pairs shorten the quota", "[budget]") {
    Budget budget = Budget::node_tests(100, 2.5);
    budget.reserve(10);  // 25 tests' worth
    CHECK(budget.grant(75) == 75);
    CHECK(budget.grant(1) == 0);

    Budget freed = Budget::node_tests(100, 2.5);
    freed.reserve(30);
    freed.reserve(3);  // rounded up: 8
    CHECK(freed.grant(100) == 92);

    Budget poor = Budget::node_tests(100, 2.5);
    poor.reserve(1000);
    CHECK(poor.grant(1) == 0);
}

TEST_CASE("a level is kept only when its node pairs can be paid", "[budget]") {
    Budget budget = Budget::node_tests(100, 10);
    budget.reserve(2);
    CHECK(budget.grant(60) == 60);
    CHECK(budget.keeps_level(2));  // 60 + 4 * 10 = 100
    CHECK_FALSE(budget.refused());
    CHECK_FALSE(budget.keeps_level(3));
    CHECK(budget.refused());
    CHECK(budget.spent() == 60);
    CHECK(budget.grant(20) == 20);  // for another pair
    CHECK(budget.grant(1) == 0);
}

TEST_CASE("node pairs of the level in the making shorten the quota as they are found", "[budget]") {
    Budget budget = Budget::node_tests(100, 10);
    budget.reserve(2);
    CHECK(budget.grant(50, 0) == 50);
    CHECK(budget.grant(20, 2) == 10);  // 40 reserved: 60 in all
    CHECK(budget.refused());
}

TEST_CASE("a deadline ends the budget on the injected clock", "[budget]") {
    FakeClock clock;
    Budget budget = Budget::deadline(clock, 1000ns);
    CHECK(budget.grant(64) == 64);
    clock.time += 999ns;
    CHECK(budget.grant(64) == 64);
    clock.time += 1ns;
    CHECK(budget.grant(64) == 0);
    CHECK(budget.ended());
    CHECK(budget.time_left() == 0ns);
}

TEST_CASE("a deadline reserves the time of what follows", "[budget]") {
    FakeClock clock;
    Budget budget = Budget::deadline(clock, 1000ns, 30ns);
    budget.reserve(10);
    clock.time += 699ns;
    CHECK(budget.grant(64) == 64);
    clock.time += 1ns;
    CHECK(budget.grant(64) == 0);

    Budget kept = Budget::deadline(clock, 1000ns, 30ns);
    kept.reserve(10);
    CHECK(kept.grant(64) == 64);
    CHECK(kept.keeps_level(23));
    // 34 * 30 > 1000, but by less than the tests between two looks at the clock take.
    CHECK(kept.keeps_level(24));
    CHECK_FALSE(kept.keeps_level(24 + 9));
}

namespace {

/// Three levels of three pairs of 10 tests and 6 node pairs each, as a scheduler asks for them.
std::vector<std::uint64_t> play(Budget& budget) {
    std::vector<std::uint64_t> granted;
    for (std::int32_t level = 1; level < 4; ++level)
        for (std::int32_t pair = 0; pair < 3; ++pair) {
            if (budget.ended()) continue;
            budget.reserve(2);
            budget.begin(pair, level);
            if (!budget.fits(10)) {
                granted.push_back(100);
                continue;
            }
            granted.push_back(budget.grant(5));
            granted.push_back(budget.grant(5, 1));
            granted.push_back(budget.keeps_level(4) ? 1 : 0);
        }
    return granted;
}

}  // namespace

TEST_CASE("a budget says where it ended, and another ends there again", "[budget]") {
    for (std::uint64_t quota = 0; quota < 120; ++quota)
        for (const double pair_cost : {0.0, 3.0}) {
            Budget budget = Budget::node_tests(quota, pair_cost);
            const auto granted = play(budget);
            REQUIRE(budget.cut().has_value() == (quota < (pair_cost > 0 ? 108 : 90)));
            if (!budget.cut()) continue;
            Budget again = Budget::until(*budget.cut());
            CHECK(play(again) == granted);
            CHECK(again.cut() == budget.cut());
            CHECK(again.spent() == budget.spent());
        }
}

TEST_CASE("a budget on a clock is played again without one", "[budget]") {
    int counted = 0;
    int ended = 0;
    for (const auto pair_time : {0ns, 20ns})
        for (const auto step : {3ns, 40ns, 300ns})
            for (auto quota = -50ns; quota < 3000ns; quota += 11ns) {
                FakeClock clock;
                clock.step = step;
                Budget budget = Budget::deadline(clock, quota, pair_time);
                budget.expect({2, 0});
                const auto granted = play(budget);
                if (!budget.cut()) continue;
                Budget again = Budget::until(*budget.cut());
                CHECK(play(again).size() >= granted.size());
                CHECK(again.cut() == budget.cut());
                CHECK(again.spent() == budget.spent());
                counted += budget.cut()->counted ? 1 : 0;
                ended += budget.ended() ? 1 : 0;
            }
    CHECK(counted > 20);
    CHECK(ended > 20);
}

TEST_CASE("a cut of a quota of tests is its quota", "[budget]") {
    Budget budget = Budget::node_tests(25, 1.5);
    budget.spend(3);
    budget.begin(7, 1);
    CHECK(budget.fits(16));
    CHECK(budget.grant(16) == 16);
    CHECK_FALSE(budget.cut());
    budget.begin(2, 1);
    CHECK_FALSE(budget.fits(16));
    CHECK(budget.cut() == Cut{-1, 0, 0, Counted{0, 25, 1.5, 0}});
}

TEST_CASE("a cut by the clock names the pair, the level and its tests", "[budget]") {
    FakeClock clock;
    Budget budget = Budget::deadline(clock, 100'000ns);
    budget.begin(7, 1);
    CHECK(budget.fits(16));
    CHECK(budget.grant(16) == 16);
    budget.begin(2, 1);
    CHECK(budget.fits(16));
    CHECK(budget.grant(6) == 6);
    clock.time = 1s;
    while (budget.grant(1) == 1) continue;  // until it looks at the clock again
    CHECK(budget.cut()->pair == 2);
    CHECK(budget.cut()->level == 1);
    CHECK(budget.cut()->tests == budget.spent() - 16);
    CHECK_FALSE(budget.cut()->counted);
}

TEST_CASE("a cut from before levels could be left out ends where it says", "[budget]") {
    Budget budget = Budget::until({1, 2, 7, {}});
    const auto granted = play(budget);
    CHECK(budget.spent() == 4 * 10 + 7);
    CHECK(granted.size() == 4 * 3 + 3);
    CHECK(budget.cut() == Cut{1, 2, 7, {}});
}

TEST_CASE("a deadline tells what was left after the levels, and what of it was kept", "[budget]") {
    FakeClock clock;
    Budget budget = Budget::deadline(clock, 1000ns, 30ns);
    clock.time += 200ns;
    budget.expect({1, 0});
    clock.time += 300ns;
    budget.reserve(10);
    budget.levels_done();
    clock.time += 100ns;
    REQUIRE(budget.after_levels());
    CHECK(budget.after_levels()->left == 500ns);
    CHECK(budget.after_levels()->reserved == 300ns);
    CHECK(budget.time_left() == 400ns);
    CHECK_FALSE(Budget::node_tests(100, 30).after_levels());
    CHECK_FALSE(Budget::unlimited().after_levels());
}
