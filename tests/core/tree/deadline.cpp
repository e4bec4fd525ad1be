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

namespace {

constexpr Pace round_pace{.test = 4, .pair = 100, .entry = 1000, .response = 10, .motion = 10};

/// Worked by hand: 20 ns a body, 70 ns a pair that touches by its roots, a fiftieth more.
constexpr Aftermath crowd{.bodies = 100, .contacts = 0, .to_touch = 10};
constexpr auto what_must_be = 2754ns;

}  // namespace

TEST_CASE("as many pairs enter as there is time for beside what must follow", "[deadline]") {
    const auto entries = [](std::chrono::nanoseconds left) {
        const FakeClock clock;
        Budget budget = Budget::deadline(clock, what_must_be + left, 250ns);
        budget.expect(round_pace);
        const std::uint64_t most = budget.entries(crowd);
        CHECK(budget.goes_deeper() == !budget.cut().has_value());
        if (budget.cut()) CHECK(budget.cut()->entered == most);
        return most;
    };
    CHECK(entries(-2000ns) == 0);
    CHECK(entries(900ns) == 0);  // to weigh ten pairs takes 600 ns
    CHECK(entries(1650ns) == 1);
    CHECK(entries(5650ns) == 5);
    CHECK(entries(10'050ns) == 10);  // all, but no deeper level
    const FakeClock clock;
    Budget ample = Budget::deadline(clock, what_must_be + 20us, 250ns);
    ample.expect(round_pace);
    CHECK(ample.entries(crowd) == 10);
    CHECK(ample.goes_deeper());
    CHECK_FALSE(ample.cut());
}

TEST_CASE("without a clock, or where nothing is reserved, every pair enters", "[deadline]") {
    const FakeClock clock;
    for (Budget budget :
         {Budget::unlimited(), Budget::node_tests(0, 3), Budget::deadline(clock, 0ns)}) {
        CHECK_FALSE(budget.governs_entries());
        CHECK(budget.entries(crowd) == crowd.to_touch);
        CHECK(budget.goes_deeper());
    }
}

TEST_CASE("contacts end where what must follow would not fit any more", "[deadline]") {
    FakeClock clock;
    Budget budget = Budget::deadline(clock, 10us, 250ns);
    budget.expect(round_pace);
    clock.time = 10us - what_must_be - 1ns;
    CHECK_FALSE(budget.is_late(crowd));
    clock.time += 2ns;
    CHECK(budget.is_late(crowd));
}

TEST_CASE("a round of the response that would not fit beside the motion is not begun",
          "[deadline]") {
    FakeClock clock;
    Budget budget = Budget::deadline(clock, 10us, 250ns);
    budget.expect(round_pace);
    budget.contacts_done({}, {.bodies = 100, .contacts = 50, .to_touch = 0});
    clock.time = 4us;  // 50 pairs took 80 ns each, half of it to make rows
    CHECK(budget.goes_on(1, 50, 50));
    clock.time = 6us;  // 40 ns; 2040 ns for 50 more, and 1020 ns to move
    CHECK(budget.goes_on(2, 50, 50));
    clock.time = 8us;
    CHECK_FALSE(budget.goes_on(3, 50, 50));
    CHECK(budget.cut()->rounds == 3);
    Budget again = Budget::until(*budget.cut());
    CHECK(again.goes_on(2, 50, 50));
    CHECK_FALSE(again.goes_on(3, 50, 50));
    CHECK(again.cut() == budget.cut());
}

TEST_CASE("what follows the levels is learnt: more at once, less by a part, cut not at all",
          "[deadline]") {
    FakeClock clock;
    const auto next = [&](std::chrono::nanoseconds response, std::chrono::nanoseconds motion,
                          bool cut) {
        Deadline deadline(clock, 1ms, 100ns);
        deadline.expect(round_pace, {});
        deadline.levels_done({});
        deadline.contacts_done({.bodies = 100, .contacts = 25, .to_touch = 0});  // 200 shares
        clock.time += response;
        deadline.response_done(false, cut);
        clock.time += motion;
        return deadline.next_pace();
    };
    CHECK(next(3us, 1200ns, false).response == 15);
    CHECK(next(3us, 1200ns, false).motion == 12);
    CHECK(next(1200ns, 800ns, false).response == 9);
    CHECK(next(1200ns, 800ns, false).motion == 9.875);
    CHECK(next(1200ns, 1ms, true).response == 10);
    CHECK(next(1200ns, 1ms, true).motion == 20);  // no more than twice
}
