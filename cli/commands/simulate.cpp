#include <nlohmann/json.hpp>

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/command.hpp"
#include "cli/stage/moment.hpp"
#include "cli/stage/run_pictures.hpp"
#include "cli/stage/simulation.hpp"
#include "cli/stage/staging.hpp"
#include "cli/terminal/dimension.hpp"
#include "cli/terminal/numbers.hpp"
#include "cli/terminal/output.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/scenes/trace/trace.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(int level) {
    return level < 0 ? Json() : Json(level);
}

template <int Dim>
Json result_of(const Simulation<Dim>& simulation, int threads) {
    const scenes::Run<Dim>& run = simulation.run;
    const scenes::Summary& summary = simulation.summary;
    return {
        {"dim", Dim},
        {"first_frame", simulation.first_frame},
        {"frames", simulation.frames},
        {"threads", threads},
        {"state_hash", scenes::hexadecimal(run.state_hash)},
        {"energy", {{"start", run.energy_start}, {"end", run.energy_end}}},
        {"momentum", {{"start", list_of(run.momentum_start)}, {"end", list_of(run.momentum_end)}}},
        {"tests", summary.tests},
        {"contacts", summary.contacts},
        {"interrupted_frames", summary.interrupted_frames},
        {"exact_pairs", summary.exact_pairs},
        {"backtracked_pairs", summary.backtracked_pairs},
        {"swept_contacts", summary.swept_contacts},
        {"level_reached",
         {{"min", or_null(summary.level_min)},
          {"median", or_null(summary.level_median)},
          {"max", or_null(summary.level_max)}}},
        {"frame_ms",
         {{"median", summary.frame_ms_median},
          {"p99", summary.frame_ms_p99},
          {"max", summary.frame_ms_max}}}};
}

template <int Dim>
std::string report_of(const scenes::Scene& scene, const Simulation<Dim>& simulation) {
    const scenes::Run<Dim>& run = simulation.run;
    const scenes::Summary& summary = simulation.summary;
    std::string text = scene.name + ": " + std::to_string(simulation.frames) + " frames of " +
                       readable(run.settings.time_step * 1000) + " ms" +
                       (simulation.first_frame > 0
                            ? ", from frame " + std::to_string(simulation.first_frame) + " on\n"
                            : "\n");
    text += "  node tests " + std::to_string(summary.tests) + ", contacts " +
            std::to_string(summary.contacts) + ", interrupted frames " +
            std::to_string(summary.interrupted_frames) + "\n";
    if (summary.level_max >= 0)
        text += "  level reached by colliding pairs: " + std::to_string(summary.level_min) +
                " to " + std::to_string(summary.level_max) + ", median " +
                std::to_string(summary.level_median) + "\n";
    if (summary.exact_pairs > 0)
        text += "  exact contact for " + std::to_string(summary.exact_pairs) + " pairs, " +
                std::to_string(summary.backtracked_pairs) + " of them backtracked\n";
    if (summary.swept_contacts > 0)
        text +=
            "  contacts between frames, of fast bodies: " + std::to_string(summary.swept_contacts) +
            "\n";
    text += "  kinetic energy " + readable(run.energy_start) + " J -> " + readable(run.energy_end) +
            " J\n";
    text += "  momentum " + in_brackets(run.momentum_start) + " -> " +
            in_brackets(run.momentum_end) + " kg m/s\n";
    text += "  collision handling of a frame: median " + readable(summary.frame_ms_median) +
            " ms, worst " + readable(summary.frame_ms_max) + " ms\n";
    text += "  state hash " + scenes::hexadecimal(run.state_hash) + "\n";
    return text;
}

template <int Dim>
void simulate(const scenes::Scene& scene, const Options& options) {
    const std::string& earlier = options.replay.empty() ? options.continued : options.replay;
    std::optional<scenes::Trace> trace;  // read before the trees are built
    if (!earlier.empty()) trace = scenes::read_trace(earlier);
    check_quota(options, trace ? trace->head().limits : scene.limits);
    const scenes::Setup<Dim> setup = stage<Dim>(scene, options);
    if (!options.seek.empty()) return show_moment(setup, options, *trace);
    const Simulation<Dim> simulation = simulated(setup, options, trace);
    write_outputs(options, drawing_of(setup, simulation.run, options));
    if (options.json)
        print(result_of(simulation, options.threads));
    else
        print(report_of(setup.scene, simulation));
}

}  // namespace

void run_simulate(const Options& options) {
    const scenes::Scene scene = scene_of(options);
    check_outputs(options, {.video = options.seek.empty()});
    in_dimension(scene.dim, [&](auto dim) { simulate<dim()>(scene, options); });
}

}  // namespace cli
