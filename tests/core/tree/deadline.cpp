#include "lodlab/core/tree/deadline.hpp"

#include "lodlab/core/tree/budget.hpp"
#include "tests/catch.hpp"
#include "tests/core/frame/clock.hpp"

using namespace lod;
using namespace std::chrono_literals;
using lodtest::FakeClock;

TEST_CASE("a level whose predicted time does not fit is not begun", "[deadline]") {
    FakeClock clock;
    Budget budget = Budget::deadline(clock, 10'000ns);
    budget.expect({5, 0});  // 2000 tests fit, a level being 32 of them
    budget.begin(0, 1);
    CHECK_FALSE(budget.fits(1969));
    CHECK_FALSE(budget.ended());
    budget.begin(1, 1);
    CHECK(budget.fits(1968));
    CHECK(budget.cut() == Cut{-1, 0, 0, Counted{0, 2000, 0, Budget::tests_of_a_level}});
}

TEST_CASE("the prediction reserves what node pairs cost", "[deadline]") {
    FakeClock clock;
    Budget budget = Budget::deadline(clock, 10'000ns, 100ns);
    budget.expect({5, 0});
    budget.reserve(50);  // half of it
    budget.begin(0, 1);
    CHECK_FALSE(budget.fits(969));
    CHECK(budget.fits(968));
    CHECK(budget.cut()->counted->pair_cost == 20);
}

TEST_CASE("what a test took in this frame corrects the prediction", "[deadline]") {
    FakeClock clock;
    Deadline deadline(clock, 100'000ns, 0ns);
    deadline.expect({1, 0}, {});
    CHECK(deadline.fits(90'000, {}));
    clock.time = 10'000ns;  // 1000 tests took 10 ns each
    CHECK(deadline.fits(9000, {1000, 0}));
    CHECK_FALSE(deadline.fits(9001, {1000, 0}));
    CHECK(deadline.next_pace().test ==
          1.25);  // no frame more than doubles it, and a quarter counts
}

TEST_CASE("what followed the levels in the last frames is the reserve of the next", "[deadline]") {
    FakeClock clock;
    Pace pace;
    const auto frame = [&](std::chrono::nanoseconds after_levels) {
        Deadline deadline(clock, 1ms, 100ns);
        deadline.expect(pace, {});
        deadline.levels_done({1000, 50});
        clock.time += after_levels;
        pace = deadline.next_pace();
    };
    frame(7500ns);
    CHECK(pace.pair == 150);  // longer than the first guess: at once
    frame(100'000ns);
    CHECK(pace.pair == 300);  // but no more than twice
    frame(11'000ns);
    CHECK(pace.pair == 295);  // 220 ns: a sixteenth of the way
    Deadline next(clock, 29'500ns, 100ns);
    next.expect(pace, {});
    CHECK_FALSE(next.passed({0, 99}));
    CHECK(Deadline(clock, 29'500ns, 295ns).passed({0, 100}));
}

TEST_CASE("where nothing is reserved, nothing is learnt of it", "[deadline]") {
    FakeClock clock;
    Deadline deadline(clock, 1ms, 0ns);
    deadline.expect({4, 300}, {});
    deadline.levels_done({1000, 50});
    clock.time += 10us;
    CHECK(deadline.next_pace().pair == 300);
    CHECK_FALSE(deadline.passed({1000, 1'000'000}));
}

TEST_CASE("a clock that stands still, jumps back or far ahead has a defined result", "[deadline]") {
    FakeClock clock;
    clock.time = 5s;
    Deadline deadline(clock, 1000ns, 0ns);
    deadline.expect({0, 0}, {});
    for (std::uint64_t tests = 0; tests < 100'000; tests += 100)
        CHECK_FALSE(deadline.passed({tests, 0}));  // stands still: never over
    CHECK(deadline.next_pace().test == Deadline::least_pace);
    clock.time = 1s;  // back: taken to stand still
    CHECK_FALSE(deadline.passed({200'000, 0}));
    clock.time = 100h;
    CHECK(deadline.passed({300'000, 0}));
}

TEST_CASE("quotas from below nothing to beyond all time are kept", "[deadline]") {
    FakeClock clock;
    clock.time = 1h;
    for (const auto quota : {std::chrono::nanoseconds::min() / 2, -1ns, 0ns})
        CHECK(Deadline(clock, quota, 0ns).passed({}));
    CHECK_FALSE(Deadline(clock, 1ns, 0ns).passed({}));
    for (const std::chrono::nanoseconds quota :
         {std::chrono::nanoseconds(1h), (std::chrono::nanoseconds::max)()}) {
        Deadline deadline(clock, quota, 250ns);
        CHECK_FALSE(deadline.passed({}));
        CHECK(deadline.fits(1'000'000'000, {}));
        CHECK(deadline.left() > 0ns);
    }
}

TEST_CASE("the clock is looked at seldom while the deadline is far, and often when it is near",
          "[deadline]") {
    FakeClock clock;
    Deadline deadline(clock, 1'000'000ns, 0ns);
    deadline.expect({1, 0}, {});
    const auto looks = [&](std::uint64_t from, std::uint64_t to) {
        const int before = clock.readings;
        for (std::uint64_t tests = from; tests < to; ++tests) {
            clock.time = std::chrono::nanoseconds(tests);
            (void)deadline.passed({tests, 0});
        }
        return clock.readings - before;
    };
    CHECK(looks(0, 800'000) == 98);  // once in 8192 tests
    const int near = looks(999'800, 1'000'000);
    CHECK(near >= 3);  // once in 64
    CHECK(near <= 5);
    clock.time = 1'000'000ns;
    CHECK(deadline.passed({1'000'064, 0}));
}
