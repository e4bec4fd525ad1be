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
    CHECK_FALSE(budget.ended());
    CHECK(budget.grant(1) == 0);
    CHECK(budget.ended());

    Budget cut = Budget::node_tests(10);
    CHECK(cut.grant(12) == 10);  // the part that fits
    CHECK(cut.ended());
    CHECK(cut.spent() == 10);
    CHECK(cut.grant(1) == 0);
}

TEST_CASE("tests that must be done count, but end nothing by themselves", "[budget]") {
    Budget budget = Budget::node_tests(5);
    budget.spend(9);
    CHECK(budget.spent() == 9);
    CHECK_FALSE(budget.ended());
    CHECK(budget.grant(1) == 0);
    CHECK(budget.ended());
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
    CHECK_FALSE(budget.ended());
    CHECK_FALSE(budget.keeps_level(3));
    CHECK(budget.ended());
    CHECK(budget.spent() == 60);
    CHECK(budget.grant(1) == 0);
}

TEST_CASE("node pairs of the level in the making shorten the quota as they are found", "[budget]") {
    Budget budget = Budget::node_tests(100, 10);
    budget.reserve(2);
    CHECK(budget.grant(50, 0) == 50);
    CHECK(budget.grant(20, 2) == 10);  // 40 reserved: 60 in all
    CHECK(budget.ended());
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
}

TEST_CASE("the clock is read once in 64 tests", "[budget]") {
    FakeClock clock;
    Budget budget = Budget::deadline(clock, 1000ns);
    const int before = clock.readings;
    for (int i = 0; i < 64; ++i) CHECK(budget.grant(1) == 1);
    CHECK(clock.readings == before + 1);
    CHECK(budget.grant(1) == 1);
    CHECK(clock.readings == before + 2);
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
    CHECK_FALSE(kept.keeps_level(24));  // 34 * 30 > 1000
}

TEST_CASE("a budget says where it ended, and another ends there again", "[budget]") {
    const auto play = [](Budget& budget) {
        std::vector<std::uint64_t> granted;
        for (std::int32_t level = 1; level < 4; ++level)
            for (std::int32_t pair = 0; pair < 3; ++pair) {
                if (budget.ended()) continue;
                budget.reserve(2);
                budget.begin(pair, level);
                granted.push_back(budget.grant(5));
                granted.push_back(budget.grant(5, 1));
                granted.push_back(budget.keeps_level(4) ? 1 : 0);
            }
        return granted;
    };
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

TEST_CASE("a cut names the pair, the level and its tests, where worked by hand", "[budget]") {
    Budget budget = Budget::node_tests(25);
    budget.spend(3);
    budget.begin(7, 1);
    CHECK(budget.grant(16) == 16);
    budget.begin(2, 1);
    CHECK(budget.grant(16) == 6);
    CHECK(budget.cut() == Cut{2, 1, 6});
}
