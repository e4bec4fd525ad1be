#include "lodlab/scenes/run.hpp"

#include <cmath>
#include <limits>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/worlds.hpp"

namespace {

/// A clock that a test owns: every reading is one tick later.
class TickingClock final : public lod::Clock {
  public:
    explicit TickingClock(std::chrono::nanoseconds tick) : tick_(tick) {}
    [[nodiscard]] std::chrono::nanoseconds now() const override { return now_ += tick_; }

  private:
    std::chrono::nanoseconds tick_;
    mutable std::chrono::nanoseconds now_{};
};

/// A clock whose ticks are uneven, as those of a busy machine: some frames are cut, some not.
class UnevenClock final : public lod::Clock {
  public:
    [[nodiscard]] std::chrono::nanoseconds now() const override {
        ++readings_;
        return now_ += std::chrono::microseconds(readings_ * 7919 % 600);
    }

  private:
    mutable int readings_ = 0;
    mutable std::chrono::nanoseconds now_{};
};

scenes::RunOptions for_frames(int frames) {
    scenes::RunOptions options;
    options.frames = frames;
    options.settings.time_step = 1.0 / 240;
    return options;
}

}  // namespace

TEST_CASE("a run does what its frames do one by one") {
    const scenes::Run<2> run = scenes::run(crossing(), for_frames(400));

    std::vector<lod::Body<2>> bodies = crossing();
    lod::FrameStorage<2> storage;
    lod::FrameSettings settings;
    settings.time_step = 1.0 / 240;
    for (std::size_t frame = 0; frame < 400; ++frame) {
        CHECK(run.steps[frame].before[0].position == bodies[0].position);
        lod::Budget budget = lod::Budget::unlimited();
        const auto& record = lod::advance<2>(bodies, settings, budget, storage);
        CHECK(run.steps[frame].record.impulses == record.impulses);
        CHECK(run.steps[frame].state_hash == lod::state_hash<2>(bodies));
    }
    CHECK(run.end[3].velocity == bodies[3].velocity);
    CHECK(run.state_hash == lod::state_hash<2>(bodies));
}

TEST_CASE("a frame's bits follow from its bodies alone, whatever frames were run before") {
    scenes::RunOptions options = for_frames(400);
    options.limits.node_tests = GENERATE(2, 20, 1'000'000);
    const scenes::Run<2> run = scenes::run(crossing(), options);
    scenes::Runner<2> one_by_one(crossing(), options);
    scenes::Runner<2> anew(crossing(), options);
    for (std::size_t frame = 0; frame < 400; ++frame) {
        const std::size_t other = frame * 157 % 400;  // all of them, in another order
        anew.put(static_cast<std::int64_t>(other), run.steps[other].before);
        CHECK(anew.next().state_hash == run.steps[other].state_hash);
        CHECK(one_by_one.frame() == static_cast<std::int64_t>(frame));
        CHECK(one_by_one.next().record.impulses == run.steps[frame].record.impulses);
    }
    CHECK(one_by_one.bodies()[3].velocity == run.end[3].velocity);
}

TEST_CASE("a run that meets nothing keeps its energy and reaches no level") {
    const std::vector<lod::Body<2>> alone{four_leaved({0, 0}, {3, 4})};
    const scenes::Run<2> run = scenes::run(alone, for_frames(24));
    CHECK(run.energy_start == 12.5);
    CHECK(run.energy_end == 12.5);
    CHECK(run.momentum_end == lod::Vector<2>(3, 4));
    CHECK(run.end[0].position.isApprox(lod::Vector<2>(0.3, 0.4)));
    const scenes::Summary summary = scenes::summarise(run);
    CHECK(summary.level_max == -1);
    CHECK(summary.contacts == 0);
}

TEST_CASE("the summary counts what the records hold") {
    scenes::RunOptions options = for_frames(400);
    options.limits.node_tests = 3;
    const scenes::Run<2> run = scenes::run(crossing(), options);
    const scenes::Summary summary = scenes::summarise(run);
    std::uint64_t tests = 0;
    int interrupted = 0;
    for (const auto& step : run.steps) {
        tests += step.record.tests;
        interrupted += step.record.interrupted() ? 1 : 0;
    }
    CHECK(summary.tests == tests);
    CHECK(summary.interrupted_frames == interrupted);
    CHECK(interrupted > 0);
    CHECK(summary.level_min == 0);  // three tests do not finish a level of 16
    CHECK(summary.level_max == 0);
}

TEST_CASE("frame times come from the clock that is handed in") {
    const TickingClock clock(std::chrono::milliseconds(2));
    scenes::RunOptions options = for_frames(10);
    options.clock = &clock;
    const scenes::Summary summary = scenes::summarise(scenes::run(crossing(), options));
    CHECK(summary.frame_ms_median == Approx(2));
    CHECK(summary.frame_ms_p99 == Approx(2));
    CHECK(summary.frame_ms_max == Approx(2));
}

TEST_CASE("a run cut by the clock is played again to the same bits by its cuts") {
    const UnevenClock clock;
    scenes::RunOptions options = for_frames(500);
    options.clock = &clock;
    options.limits.milliseconds = GENERATE(0.1, 0.3, 0.5);
    const scenes::Run<2> timed = scenes::run(crossing(), options);

    std::vector<std::optional<lod::Cut>> cuts;
    for (const auto& step : timed.steps) cuts.push_back(step.record.cut);
    scenes::RunOptions again = for_frames(500);
    again.cuts = cuts;
    const scenes::Run<2> replayed = scenes::run(crossing(), again);
    CHECK(scenes::summarise(timed).interrupted_frames > 0);
    CHECK(replayed.state_hash == timed.state_hash);
    for (std::size_t k = 0; k < timed.steps.size(); ++k)
        CHECK(replayed.steps[k].state_hash == timed.steps[k].state_hash);
}

TEST_CASE("a quota that is no time leaves level 0, and one beyond all time leaves all") {
    const auto hash_with = [](std::optional<double> milliseconds, std::optional<int> level) {
        const TickingClock clock(std::chrono::nanoseconds(50));
        scenes::RunOptions options = for_frames(300);
        options.clock = &clock;
        options.limits.milliseconds = milliseconds;
        if (level) options.settings.deepest_level = *level;
        return scenes::run(crossing(), options).state_hash;
    };
    const auto coarse = hash_with({}, 0);
    const auto all = hash_with({}, {});
    CHECK(coarse != all);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double none : {0.0, -1.0, -infinity, std::nan(""), 1e-7})
        CHECK(hash_with(none, {}) == coarse);
    for (const double hour : {3.6e6, 1e300, infinity}) CHECK(hash_with(hour, {}) == all);
}

TEST_CASE("a run stops at a signal") {
    lod::stop_requested = true;
    CHECK_THROWS_AS(scenes::run(crossing(), for_frames(10)), lod::Interrupted);
    lod::stop_requested = false;
}

TEST_CASE("a body that leaves the range of numbers ends the run with the mend") {
    std::vector<lod::Body<2>> fast{four_leaved({0, 0}, {1e8, 0})};
    scenes::RunOptions options = for_frames(100);
    options.settings.time_step = 1;
    try {
        (void)scenes::run(fast, options);
        FAIL("ran on");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::limit_exceeded);
        CHECK(std::string(error.what()).starts_with("frame 9: body number 1"));
    }
}
