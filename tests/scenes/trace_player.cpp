#include "lodlab/scenes/trace/trace_player.hpp"

#include <set>

#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/setup.hpp"
#include "lodlab/scenes/trace/events.hpp"
#include "tests/scenes/trace_files.hpp"

namespace {

/// The state hash before frame k, k up to the number of frames.
std::uint64_t hash_at(const scenes::Run<2>& run, std::int64_t k, std::uint64_t at_start) {
    return k == 0 ? at_start : run.steps[static_cast<std::size_t>(k - 1)].state_hash;
}

}  // namespace

TEST_CASE("random seeks reach the frames of the run, each by one interval of frames at most") {
    scenes::Scene scene = scenes::load_scene(scenes::scene_file("gears_in_a_box"));
    for (scenes::BodySpec& body : scene.bodies) body.depth = 2;
    const auto setup = scenes::set_up<2>(scene);
    scenes::RunOptions options;
    options.settings = scenes::frame_settings(scene, {});
    options.limits.node_tests = 60;
    options.frames = 1000;
    const scenes::Run<2> run = scenes::run(setup.bodies, options);
    CHECK(scenes::summarise(run).interrupted_frames > 100);

    const TemporaryFolder folder;
    const std::int64_t interval = 25;
    scenes::write_trace<2>(folder / "t.json", scene.name, setup.bodies, run,
                           {.key_frames = interval});
    scenes::TracePlayer<2> player(scenes::read_trace(folder / "t.json"), setup.bodies);
    const std::uint64_t at_start = lod::state_hash<2>(setup.bodies);
    std::uint64_t state = 11;
    std::uint64_t before = 0;
    for (int seek = 0; seek < 100; ++seek) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        const auto frame = static_cast<std::int64_t>((state >> 33) % 1001);
        CAPTURE(frame);
        player.seek(frame);
        CHECK(player.frame() == frame);
        CHECK(player.state_hash() == hash_at(run, frame, at_start));
        CHECK(player.frames_run() - before <= static_cast<std::uint64_t>(interval));
        before = player.frames_run();
        if (frame == 1000) continue;
        const lod::FrameRecord<2>& record = player.step().record;
        const lod::FrameRecord<2>& of_the_run = run.steps[static_cast<std::size_t>(frame)].record;
        CHECK(record.impulses == of_the_run.impulses);
        CHECK(record.cut == of_the_run.cut);
        CHECK(record.tests == of_the_run.tests);
        CHECK(player.frame() == frame);
        before = player.frames_run();
    }
}

TEST_CASE("going back runs as many frames as going forward") {
    const scenes::Run<2> run = budgeted_run(500);
    const scenes::Trace trace = scenes::parse_trace(trace_text(run, {.key_frames = 50}), "t.json");
    const std::uint64_t at_start = lod::state_hash<2>(crossing());
    scenes::TracePlayer<2> player(trace, crossing());
    while (player.frame() < player.frames()) {
        CHECK(player.state_hash() == hash_at(run, player.frame(), at_start));
        player.forward();
    }
    CHECK(player.state_hash() == run.state_hash);
    CHECK(player.frames_run() == 500);
    while (player.frame() > 0) {
        player.back();
        CHECK(player.state_hash() == hash_at(run, player.frame(), at_start));
    }
    CHECK(player.frames_run() <= 1000);
}

TEST_CASE("a step that is asked for in any order is the one of the run") {
    const scenes::Run<2> run = budgeted_run(300);
    const scenes::Trace trace = scenes::parse_trace(trace_text(run, {.key_frames = 40}), "t.json");
    scenes::TracePlayer<2> player(trace, crossing());
    for (std::int64_t k = 0; k < 600; ++k) {
        const std::int64_t frame = k * 89 % 300;
        player.seek(frame);
        const auto& told = run.steps[static_cast<std::size_t>(frame)];
        CHECK(player.step().state_hash == told.state_hash);
        CHECK(&player.step() == &player.step());
        CHECK(player.step().record.impulses == told.record.impulses);
        CHECK(player.bodies()[2].position == told.before[2].position);
        if (k % 3 == 0) {
            CHECK(player.forward().state_hash == told.state_hash);
            CHECK(player.state_hash() == told.state_hash);
        }
    }
}

TEST_CASE("the events of a frame are its levels, its contacts and its impulses") {
    scenes::RunOptions options;
    options.settings.time_step = 1.0 / 240;
    options.frames = 400;
    const scenes::Run<2> run = scenes::run(crossing(), options);
    std::size_t contacts = 0;
    std::set<scenes::EventKind> kinds;
    for (const scenes::Step<2>& step : run.steps) {
        std::uint64_t tests = 0;
        std::size_t pushed = 0;
        for (const scenes::Event<2>& event :
             scenes::events_of<2>(step, crossing(), options.settings)) {
            kinds.insert(event.kind);
            CHECK(event.a < event.b);
            tests += event.tests;
            contacts += event.kind == scenes::EventKind::contact ? 1 : 0;
            if (event.kind != scenes::EventKind::impulse) continue;
            ++pushed;
            CHECK(event.impulse > 0);
        }
        CHECK(tests == step.record.tests);  // no frame is cut
        CHECK(pushed <= step.record.impacts.size());
    }
    CHECK(contacts == scenes::summarise(run).contacts);
    CHECK(kinds == std::set{scenes::EventKind::level, scenes::EventKind::contact,
                            scenes::EventKind::impulse});
}

TEST_CASE("two balls that meet have the two levels, the contact and the impulse worked by hand") {
    // Mass 1 kg, radius 1 m, closing at 2 m/s, 1.5 + 1.5 - 2.9 m deep at their roots.
    scenes::Step<2> step;
    std::vector<lod::Body<2>> bodies{four_leaved({0, 0}, {1, 0}), four_leaved({2.9, 0}, {-1, 0})};
    scenes::RunOptions options;
    options.settings.deepest_level = 0;
    options.settings.contact_model = lod::ContactModel::centre_line;
    scenes::Runner<2> runner(bodies, options);
    const auto events = scenes::events_of<2>(runner.next(), bodies, options.settings);
    REQUIRE(events.size() == 3);
    CHECK(events[0].kind == scenes::EventKind::level);
    CHECK(events[0].level == 0);
    CHECK(events[0].tests == 1);
    CHECK(events[0].overlapping == 1);
    CHECK(events[1].kind == scenes::EventKind::contact);
    CHECK(events[1].contact.depth == Approx(0.1));
    CHECK(events[1].contact.point.isApprox(lod::Vector<2>(1.45, 0)));
    CHECK(events[2].kind == scenes::EventKind::impulse);
    CHECK(events[2].impulse == Approx(2));  // each leaves as the other came
    CHECK(events[2].contact.normal.isApprox(lod::Vector<2>(1, 0)));
}
