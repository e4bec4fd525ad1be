#include "lodlab/scenes/trace/events.hpp"

#include "tests/scenes/trace_files.hpp"

namespace {

using scenes::EventKind;

const std::vector<std::string> letters{"A", "B", "C", "D"};

/// Two bodies of two levels, so far apart from centre to centre.
std::vector<lod::Body<2>> couple(double apart) {
    return {four_leaved({0, 0}, {1, 0}), four_leaved({apart, 0}, {-1, 0})};
}

scenes::RunOptions by_centre_lines() {
    scenes::RunOptions options;
    options.settings.contact_model = lod::ContactModel::centre_line;
    return options;
}

std::vector<scenes::Event<2>> events_of(const std::vector<lod::Body<2>>& bodies,
                                        const scenes::RunOptions& options,
                                        const std::optional<lod::Cut>& cut = {}) {
    scenes::Runner<2> runner(bodies, options);
    const scenes::Step<2>& step = cut ? runner.next(cut) : runner.next();
    return scenes::events_of<2>(step, bodies, options.settings);
}

std::string told(const scenes::Event<2>& event) {
    return scenes::sentence<2>(event, letters);
}

/// "AB0 CD0 AB1": the pairs and levels of all levels that were finished.
std::string order_of(const std::vector<scenes::Event<2>>& events) {
    std::string text;
    for (const scenes::Event<2>& event : events)
        if (event.kind == EventKind::level)
            text += (text.empty() ? "" : " ") + letters[lod::at(event.a)] +
                    letters[lod::at(event.b)] + std::to_string(event.level);
    return text;
}

}  // namespace

TEST_CASE("a level that does not fit into the budget is told, with the tests that it takes") {
    // The roots take 1 test, four leaves against four 16.
    scenes::RunOptions options = by_centre_lines();
    options.limits.node_tests = 16;
    auto events = events_of(couple(1.9), options);
    REQUIRE(events.size() >= 2);
    CHECK(events[1].kind == EventKind::skipped);
    CHECK(events[1].level == 1);
    CHECK(events[1].tests == 0);
    CHECK(events[1].needed == 16);
    CHECK(told(events[1]) ==
          "level 1 of A and B: not begun, for 16 node tests do not fit into the budget");
    options.limits.node_tests = 17;
    events = events_of(couple(1.9), options);
    CHECK(events[1].kind == EventKind::level);
    CHECK(told(events[1]) == "level 1 of A and B: 16 node tests, 2 node pairs overlap");
}

TEST_CASE("a level whose node pairs cannot be paid for is dropped with all its tests") {
    // 1.9 m apart two pairs of leaves meet: (1 + 16) tests and 2 x 2 tests reserved are 21.
    const std::vector<lod::Body<2>> bodies = couple(1.9);
    const lod::FrameSettings settings = by_centre_lines().settings;
    for (const int quota : {20, 21}) {
        std::vector<lod::Body<2>> moved = bodies;
        lod::FrameStorage<2> storage;
        lod::Budget budget = lod::Budget::node_tests(static_cast<std::uint64_t>(quota), 2);
        scenes::Step<2> step;
        step.before = scenes::states_of<2>(bodies);
        step.record = lod::advance<2>(moved, settings, budget, storage);
        const auto events = scenes::events_of<2>(step, bodies, settings);
        const bool is_dropped = quota == 20;
        CHECK((events[1].kind == EventKind::dropped) == is_dropped);
        CHECK(events[1].tests == 16);
        if (!is_dropped) continue;
        CHECK(told(events[1]) ==
              "level 1 of A and B: 16 node tests are thrown away: too much to answer");
    }
}

TEST_CASE("a level that was cut short is told with the tests that were done") {
    for (const std::uint64_t tests : {1, 5}) {
        lod::Cut cut;
        cut.pair = 0;
        cut.level = 1;
        cut.tests = tests;
        const auto events = events_of(couple(1.9), by_centre_lines(), cut);
        CHECK(events[1].kind == EventKind::dropped);
        CHECK(events[1].tests == tests);
        CHECK(told(events[1]) == "level 1 of A and B: " + std::to_string(tests) +
                                     " of 16 node tests " + (tests == 1 ? "is" : "are") +
                                     " thrown away: the budget ended");
        // The roots' contact is what the frame goes by.
        CHECK(events[2].kind == EventKind::contact);
        CHECK(events[2].contact.depth == Approx(1.1));
    }
}

TEST_CASE("levels come pair by pair without a limit, and by turns under one") {
    std::vector<lod::Body<2>> bodies = couple(1.9);
    bodies.push_back(four_leaved({20, 0}, {3, 0}));
    bodies.push_back(four_leaved({21.9, 0}, {-3, 0}));
    scenes::RunOptions options = by_centre_lines();
    CHECK(order_of(events_of(bodies, options)) == "AB0 AB1 CD0 CD1");
    options.limits.node_tests = 1000;
    CHECK(order_of(events_of(bodies, options)) == "AB0 CD0 CD1 AB1");  // the fastest first
    options.settings.priority = lod::Priority::first_come;
    CHECK(order_of(events_of(bodies, options)) == "AB0 CD0 AB1 CD1");
    options.limits.node_tests = 18;  // for one level of one pair
    const auto events = events_of(bodies, options);
    CHECK(order_of(events) == "AB0 CD0 AB1");
    CHECK(events[3].kind == EventKind::skipped);
    CHECK(events[3].a == 2);
}

TEST_CASE("the tests of all levels, dropped ones too, are the tests of the frame") {
    scenes::RunOptions options = budgeted(500);
    options.settings.finest = {};
    options.limits.node_tests = 40;
    const scenes::Run<2> run = scenes::run(crossing(), options);
    CHECK(scenes::summarise(run).interrupted_frames > 10);
    for (const scenes::Step<2>& step : run.steps) {
        std::uint64_t tests = 0;
        bool is_left_out = false;
        for (const auto& event : scenes::events_of<2>(step, crossing(), options.settings)) {
            tests += event.tests;
            is_left_out |= event.kind == EventKind::dropped || event.kind == EventKind::skipped;
        }
        CHECK(tests == step.record.tests);
        CHECK(is_left_out == step.record.interrupted());
    }
}

TEST_CASE("in a row of three the push goes on in the second round") {
    // 1 kg each, restitution 1: A stops at B with 1 N s, then B at C.
    const std::vector<lod::Body<2>> row{four_leaved({0, 0}, {1, 0}), four_leaved({2.9, 0}, {0, 0}),
                                        four_leaved({5.8, 0}, {0, 0})};
    scenes::RunOptions options = by_centre_lines();
    options.settings.deepest_level = 0;
    const auto events = events_of(row, options);
    std::vector<scenes::Event<2>> rounds;
    for (const auto& event : events)
        if (event.kind == EventKind::round) rounds.push_back(event);
    REQUIRE(rounds.size() == 2);
    CHECK(told(rounds[0]) == "round 1 of 2 of the response: A pushes B by 1 N s");
    CHECK(told(rounds[1]) == "round 2 of 2 of the response: B pushes C by 1 N s");
    CHECK(rounds[0].pushes == std::vector<double>{1, 0});
    CHECK(scenes::kinds_text<2>(events) == "2 levels, 2 contacts, 2 rounds and 2 impulses");
}

TEST_CASE("the pushes of all rounds are the impulses, and a single round is not told") {
    scenes::RunOptions options;
    options.settings.time_step = 1.0 / 240;
    options.frames = 400;
    const scenes::Run<2> run = scenes::run(crossing(), options);
    for (const scenes::Step<2>& step : run.steps) {
        std::vector<double> sum(step.record.impulses.size());
        int rounds = 0;
        for (const auto& event : scenes::events_of<2>(step, crossing(), options.settings)) {
            if (event.kind != EventKind::round) continue;
            CHECK(event.round == ++rounds);
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += event.pushes[i];
        }
        CHECK(rounds != 1);
        for (std::size_t i = 0; i < sum.size() && rounds > 0; ++i)
            CHECK(sum[i] == Approx(step.record.impulses[i]));
    }
}

TEST_CASE("a frame of a trace has the events of the run, where the budget ended it") {
    scenes::RunOptions options = budgeted(500);
    const scenes::Run<2> run = scenes::run(crossing(), options);
    scenes::TracePlayer<2> player(scenes::parse_trace(trace_text(run, {.key_frames = 50}), "t"),
                                  crossing());
    int cut = 0;
    for (std::int64_t frame = 0; frame < 500; ++frame) {
        const scenes::Step<2>& step = run.steps[static_cast<std::size_t>(frame)];
        if (!step.record.cut) continue;
        ++cut;
        player.seek(frame);
        const auto of_run = scenes::events_of<2>(step, crossing(), options.settings);
        const auto again = scenes::events_of<2>(player.step(), crossing(), options.settings);
        REQUIRE(of_run.size() == again.size());
        for (std::size_t i = 0; i < again.size(); ++i) {
            CHECK(scenes::event_name(of_run[i]) == scenes::event_name(again[i]));
            CHECK(told(of_run[i]) == told(again[i]));
        }
    }
    CHECK(cut > 10);
}

TEST_CASE("events of a kind are numbered from 1, and where they are may be left out") {
    const auto events = events_of(couple(1.9), by_centre_lines());
    CHECK(scenes::event_name(events[0]) == "level:1");
    CHECK(scenes::event_name(events[1]) == "level:2");
    CHECK(scenes::event_name(events[2]) == "contact:1");
    CHECK(scenes::event_name(events[3]) == "contact:2");
    CHECK_THAT(told(events[2]), Catch::StartsWith("A and B touch at (0.95, ") &&
                                    Catch::EndsWith(" m along (1, 0), 0.1 m deep"));
    CHECK(scenes::sentence<2>(events[2], letters, scenes::Places::left_out) ==
          "A and B touch, 0.1 m deep");
    CHECK(scenes::kinds_text<2>(std::span<const scenes::Event<2>>()) == "no event");
}
