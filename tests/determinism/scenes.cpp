// Every scene that comes with lodlab, from its file to its end; frames cut at every test; exact
// contact and backtracking; traces.

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"
#include "lodlab/scenes/trace/trace_writer.hpp"
#include "tests/determinism/report.hpp"

namespace {

/// A shipped scene with shallow trees: at -O0 they take a hundred times as long as in a release.
scenes::Scene shallow(const std::string& name) {
    scenes::Scene scene = scenes::load_scene(scenes::scene_file(name));
    for (scenes::BodySpec& body : scene.bodies) {
        body.depth = std::min(body.depth.value_or(2), 2);
        if (scene.dim == 3) body.builder = "octree";
    }
    return scene;
}

template <int Dim>
scenes::Run<Dim> run_of(const scenes::Scene& scene, const scenes::Setup<Dim>& setup,
                        lod::Finest finest = lod::Finest::leaves) {
    scenes::RunOptions options;
    options.settings = scenes::frame_settings(scene, scene.limits);
    if (finest != lod::Finest::leaves) options.settings.finest.level = finest;
    options.frames = scene.frames();
    options.limits = scene.limits;
    return scenes::run(setup.bodies, options);
}

template <int Dim>
void add_scene(const std::string& name, const scenes::Scene& scene, Report& report) {
    const auto setup = scenes::set_up<Dim>(scene);
    const auto run = run_of<Dim>(scene, setup);
    report.add("scene " + name, run.state_hash);
    // Several of these programs may run at once.
    const std::string own = std::to_string(std::random_device{}());
    const auto path = std::filesystem::temp_directory_path() / ("lodlab_" + own + name + ".json");
    scenes::write_trace<Dim>(path, name, setup.bodies, run, {.records = true});
    report.add_text("scene " + name + ", its trace",
                    lod::read_text_file(path, std::size_t{1} << 30));
    std::filesystem::remove(path);
}

template <int Dim>
void add_finest(const std::string& name, Report& report) {
    const scenes::Scene scene = shallow(name);
    const auto setup = scenes::set_up<Dim>(scene);
    for (const auto& [finest, what] :
         {std::pair{lod::Finest::exact, "exact"}, std::pair{lod::Finest::backtrack, "backtrack"}})
        report.add("scene " + name + ", " + what, run_of<Dim>(scene, setup, finest).state_hash);
}

/// The frame of most node tests, cut after every one of them.
template <int Dim>
void add_interruptions(const std::string& name, Report& report) {
    const scenes::Scene scene = shallow(name);
    const auto setup = scenes::set_up<Dim>(scene);
    const auto run = run_of<Dim>(scene, setup);
    const auto most = std::max_element(
        run.steps.begin(), run.steps.end(),
        [](const auto& a, const auto& b) { return a.record.tests < b.record.tests; });
    Combined all;
    for (std::uint64_t tests = 0; tests <= most->record.tests; ++tests) {
        std::vector<lod::Body<Dim>> bodies = setup.bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            scenes::put<Dim>(most->before[i], bodies[i]);
        lod::Budget budget = lod::Budget::node_tests(tests);
        lod::FrameStorage<Dim> storage;
        lod::advance<Dim>(bodies, scenes::frame_settings(scene, {}), budget, storage);
        all.add(lod::state_hash<Dim>(bodies));
    }
    report.add("a frame of " + name + ", cut after each of " + std::to_string(most->record.tests) +
                   " tests",
               all.value());
}

/// Leaves out what takes something that this machine or this build lacks.
template <class Add>
void add_or_leave_out(const std::string& what, Report& report, const Add& add) {
    try {
        add();
    } catch (const lod::Error& error) {
        report.leave_out(what, error.what());
    }
}

}  // namespace

void add_scenes(Report& report) {
    for (const std::string& name : scenes::names()) {
        add_or_leave_out("scene " + name, report, [&] {
            const scenes::Scene scene = shallow(name);
            if (scene.limits.milliseconds) return;  // not repeatable without its trace
            if (scene.dim == 3)
                add_scene<3>(name, scene, report);
            else
                add_scene<2>(name, scene, report);
        });
    }
    add_or_leave_out("scene figure9", report, [&] { add_finest<2>("figure9", report); });
    add_finest<2>("gears_in_a_box", report);
    add_finest<3>("knot_meets_ring", report);
    add_or_leave_out("a frame of figure9", report,
                     [&] { add_interruptions<2>("figure9", report); });
    add_interruptions<2>("gears_in_a_box", report);
    add_interruptions<3>("knot_meets_ring", report);
}
