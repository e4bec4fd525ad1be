#include "lodlab/scenes/trace/trace.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lodlab/core/exact/ball_union.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/scenes/trace/trace_json.hpp"
#include "tests/scenes/trace_files.hpp"

TEST_CASE("a trace plays again to the same bits") {
    const TemporaryFolder folder;
    const scenes::Run<2> run = budgeted_run();
    scenes::write_trace<2>(folder / "t.json", "crossing", crossing(), run);

    const scenes::Trace trace = scenes::read_trace(folder / "t.json");
    const scenes::TraceHead& head = trace.head();
    CHECK(head.scene == "crossing");
    CHECK(head.dim == 2);
    CHECK(head.settings.response == lod::Response::mean);
    CHECK(head.settings.contact_model == lod::ContactModel::node_normal);
    CHECK(head.settings.finest.level == lod::Finest::backtrack);
    CHECK(head.settings.finest.most_pairs == 5);
    CHECK(head.settings.finest.cost == 700);
    CHECK(head.settings.finest.tolerance == 1e-8);
    CHECK(head.settings.time_step == 1.0 / 240);
    CHECK(head.limits.node_tests == 20U);
    REQUIRE(trace.frames() == 500);
    const scenes::Run<2> again = scenes::replay<2>(trace, crossing());
    CHECK(again.state_hash == run.state_hash);
    CHECK(scenes::summarise(run).interrupted_frames > 0);
    for (std::size_t k = 0; k < run.steps.size(); ++k)
        CHECK(again.steps[k].record.impulses == run.steps[k].record.impulses);
}

TEST_CASE("a trace with records tells readers every body and contact") {
    const scenes::Run<2> run = budgeted_run();
    std::size_t contacts = 0;
    std::size_t frames = 0;
    for (const std::string& line : lines_of(trace_text(run, {.records = true}))) {
        const nlohmann::json frame = object_in(line);
        if (!frame.contains("frame")) continue;
        const scenes::Step<2>& step = run.steps[frames];
        CHECK(frame.at("frame") == frames++);
        const scenes::State<2>& first = step.before[0];
        CHECK(frame.at("bodies").at(0) ==
              nlohmann::json({first.position.x(), first.position.y(), first.orientation,
                              first.velocity.x(), first.velocity.y(), first.spin[0]}));
        CHECK(frame.at("tests") == step.record.tests);
        for (const auto& pair : frame.at("pairs")) contacts += pair.at("contacts").size();
    }
    CHECK(frames == run.steps.size());
    CHECK(contacts == scenes::summarise(run).contacts);
    CHECK(contacts > 0);
}

TEST_CASE("a trace is one JSON document, with its head, entries and end for any reader") {
    const scenes::Run<2> run = budgeted_run(250);
    const auto document = nlohmann::json::parse(trace_text(run, {.key_frames = 80}));
    CHECK(document.at("dim") == 2);
    CHECK(document.at("scene") == "crossing");
    CHECK(document.at("entries").size() == 250 + 4 + 1);  // frames, key frames, and null
    CHECK(document.at("entries").back().is_null());
    CHECK(document.at("end").at("key_frame") == 250);
    CHECK(document.at("end").at("bodies").at(0).at(0) == run.end[0].position.x());
    CHECK(document.at("index").at("places").size() == 5);
}

TEST_CASE("a trace without records tells the bodies of its key frames and of its end alone") {
    const scenes::Run<2> run = budgeted_run(250);
    std::vector<std::int64_t> told;
    for (const std::string& line : lines_of(trace_text(run, {.key_frames = 80})))
        if (const auto json = object_in(line); json.contains("bodies"))
            told.push_back(json.at("key_frame").get<std::int64_t>());
    CHECK(told == std::vector<std::int64_t>{0, 80, 160, 240, 250});
}

TEST_CASE("a trace is of one geometry: hulls and true shapes count") {
    auto bodies = crossing();
    const auto before = scenes::fingerprint<2>(bodies);
    auto tree = std::make_shared<lod::SphereTree<2>>(*bodies[0].tree);
    bodies[0].tree = tree;
    std::vector<std::uint64_t> all{before};
    for (int node = 0; node < tree->size(); ++node)
        tree->hulls.add(
            {{{-1, -1}, {1, -1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 0}}, {}, {}, false, false});
    tree->hulls.find_best(tree->parent);
    all.push_back(scenes::fingerprint<2>(bodies));
    ++tree->hulls.entry_level;
    all.push_back(scenes::fingerprint<2>(bodies));
    for (const double radius : {1.0, 1.0 + 1e-15}) {
        bodies[0].exact =
            std::make_shared<lod::BallUnion<2>>(std::vector<lod::Sphere<2>>{{{0, 0}, radius}});
        all.push_back(scenes::fingerprint<2>(bodies));
    }
    std::ranges::sort(all);
    CHECK(std::ranges::adjacent_find(all) == all.end());
}

TEST_CASE("a trace is written as the run goes, and stands there once it is complete") {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    const fs::path path = folder / "t.json";
    const auto part_size = [&] {
        for (const auto& entry : fs::directory_iterator(path.parent_path()))
            if (entry.path() != path) return entry.file_size();
        return std::uintmax_t{0};
    };
    {
        const scenes::RunOptions options = budgeted(40);
        scenes::Runner<2> runner(crossing(), options);
        scenes::TraceWriter<2> writer(
            path, {"crossing", runner.bodies(), options.settings, options.limits});
        std::uintmax_t written = part_size();
        CHECK(written > 0);
        for (int frame = 0; frame < 40; ++frame) {
            const scenes::Step<2>& step = runner.next();
            writer.add(step, scenes::states_of(runner.bodies()));
            CHECK(part_size() > written);  // nothing of the frame is kept back
            written = part_size();
        }
        CHECK_FALSE(fs::exists(path));
    }  // as where an error ends the run
    CHECK(fs::is_empty(path.parent_path()));
}

TEST_CASE(
    "a run that is saved, loaded and continued is the one that never stopped, in every byte") {
    const TemporaryFolder folder;
    const std::int64_t stop = GENERATE(1, 100, 137, 200);  // key frames are 100 apart
    const std::int64_t end = 300;
    scenes::write_trace<2>(folder / "whole.json", "crossing", crossing(), budgeted_run(end));
    scenes::write_trace<2>(folder / "first.json", "crossing", crossing(), budgeted_run(stop));

    const scenes::Trace first = scenes::read_trace(folder / "first.json");
    scenes::RunOptions options;
    options.settings = first.head().settings;
    options.limits = first.head().limits;
    options.frames = end;
    scenes::Runner<2> runner(scenes::bodies_at_end<2>(first, crossing()), options, first.frames());
    scenes::TraceWriter<2> writer(folder / "both.json", first);
    while (runner.frame() < end) {
        const scenes::Step<2>& step = runner.next();
        writer.add(step, scenes::states_of(runner.bodies()));
    }
    writer.finish();
    CHECK(lod::state_hash(runner.bodies()) == budgeted_run(end).state_hash);
    CHECK(text_of(folder / "both.json") == text_of(folder / "whole.json"));
}

TEST_CASE("key frames come more often where there are many bodies, or as they are asked for") {
    const TemporaryFolder folder;
    const auto key_frames = [&](std::size_t bodies, std::int64_t asked) {
        const std::vector<lod::Body<2>> all(bodies, four_leaved({0, 0}, {1, 0}));
        scenes::RunOptions options;
        scenes::Runner<2> runner({all[0]}, options);
        const scenes::Step<2>& step = runner.next();
        scenes::TraceWriter<2> writer(folder / "t.json", {"many", all, {}, {}},
                                      {.key_frames = asked});
        writer.add(step, step.before);
        writer.finish();
        return scenes::read_trace(folder / "t.json").head().key_frames;
    };
    CHECK(key_frames(1, 0) == 100);
    CHECK(key_frames(5000, 0) == 100);
    CHECK(key_frames(10'000, 0) == 50);
    CHECK(key_frames(100'000, 0) == 10);
    CHECK(key_frames(10'000, 7) == 7);
}

TEST_CASE("a trace says which levels were left out and who looked on") {
    const TemporaryFolder folder;
    scenes::RunOptions options = budgeted(500);
    options.settings.priority = lod::Priority::perceptual;
    options.settings.viewer.fixation = {1, 0.1, 0};
    options.settings.viewer.eye = lod::Viewer::Point{2, 3, 4};
    options.settings.viewer.distractor = 0.7;
    const scenes::Run<2> run = scenes::run(crossing(), options);
    scenes::write_trace<2>(folder / "t.json", "crossing", crossing(), run);
    const scenes::Trace trace = scenes::read_trace(folder / "t.json");
    const lod::FrameSettings& settings = trace.head().settings;
    CHECK(settings.viewer.fixation == lod::Viewer::Point{1, 0.1, 0});
    CHECK(settings.viewer.eye == lod::Viewer::Point{2, 3, 4});
    CHECK(settings.viewer.distractor == 0.7);
    int counted = 0;
    for (std::int64_t frame = 0; frame < 500; ++frame) {
        const auto interval = trace.interval(frame);
        const auto& told = interval.frames[static_cast<std::size_t>(frame - interval.first)];
        CHECK(told.cut == run.steps[static_cast<std::size_t>(frame)].record.cut);
        counted += told.cut && told.cut->counted ? 1 : 0;
    }
    CHECK(counted > 0);
    CHECK(scenes::replay<2>(trace, crossing()).state_hash == run.state_hash);
}

TEST_CASE(
    "a run under any policy and organisation is sought in and played again to the same bits") {
    for (const lod::Priority priority : lod::choices<lod::Priority>())
        for (const lod::Organisation organisation : lod::choices<lod::Organisation>()) {
            const TemporaryFolder folder;
            scenes::RunOptions options = budgeted(500);
            options.settings.priority = priority;
            options.settings.organisation = organisation;
            const scenes::Run<2> run = scenes::run(crossing(), options);
            scenes::write_trace<2>(folder / "t.json", "crossing", crossing(), run,
                                   {.key_frames = 40});
            const scenes::Trace trace = scenes::read_trace(folder / "t.json");
            CHECK(trace.head().settings.organisation == organisation);
            CHECK(scenes::replay<2>(trace, crossing()).state_hash == run.state_hash);
            scenes::TracePlayer<2> player(trace, crossing());
            for (const std::int64_t frame : {373, 30, 500, 281}) {
                player.seek(frame);
                CHECK(player.state_hash() ==
                      run.steps[static_cast<std::size_t>(frame - 1)].state_hash);
            }
            if (priority == lod::Priority::trade)
                CHECK_THROWS_AS(scenes::bodies_at_end<2>(trace, crossing()), lod::Error);
        }
}

TEST_CASE("what a clock cut stands in a trace, and an older one without it is read") {
    lod::Cut cut{3, 2, 17, lod::Counted{5, 600, 1.5, 32}, 70};
    cut.entered = 9;
    cut.modelled = 11;
    cut.rounds = 2;
    CHECK(scenes::cut_from(scenes::json_of(std::optional(cut))) == cut);
    const lod::Cut older{3, 2, 17};
    const scenes::Json json = scenes::json_of(std::optional(older));
    CHECK(json.size() == 3);
    CHECK(scenes::cut_from(json) == older);
    CHECK(scenes::cut_from(scenes::json_of(std::nullopt)) == std::nullopt);
}
