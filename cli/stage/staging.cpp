#include "cli/stage/staging.hpp"

#include <algorithm>

#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"

namespace cli {
namespace {

constexpr double most_frames = 100'000;  // at 240 a second, seven minutes

template <class Choice>
void override_choice(const std::string& name, Choice& choice) {
    choice = lod::named<Choice>(name).value_or(choice);
}

void override_limits(const Options& options, scenes::Limits& limits) {
    const int given =
        (options.level ? 1 : 0) + (options.budget ? 1 : 0) + (options.milliseconds ? 1 : 0);
    if (given > 1)
        throw lod::Error(lod::ErrorKind::usage,
                         "--level, --budget and --milliseconds exclude each other; give one");
    if (given == 1) limits = {options.level, options.budget, options.milliseconds};
}

const lod::Clock& steady_clock() {
    static const lod::SteadyClock clock;
    return clock;
}

}  // namespace

void check_frames(const scenes::Scene& scene, const Options& options) {
    const double most = most_frames * options.raise_limits;
    if (static_cast<double>(scene.frames()) > most)
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         std::to_string(scene.frames()) + " frames, the limit is " +
                             readable(most) +
                             "; shorten the duration, or raise the limit by --raise-limits");
}

scenes::RunOptions run_options(const scenes::Scene& scene) {
    scenes::RunOptions run;
    run.settings = scenes::frame_settings(scene, scene.limits);
    run.frames = scene.frames();
    run.limits = scene.limits;
    run.clock = &steady_clock();
    return run;
}

io::TreeCache cache_of(const Options& options) {
    return options.no_cache ? io::TreeCache() : io::TreeCache::of_user();
}

scenes::Scene scene_of(const Options& options) {
    scenes::Scene scene = scenes::named_scene(options.scene);
    override_limits(options, scene.limits);
    override_choice(options.response, scene.response);
    override_choice(options.contact_model, scene.contact_model);
    override_choice(options.point_model, scene.point_model);
    override_choice(options.finest, scene.finest.level);
    override_choice(options.policy, scene.priority);
    if (options.fixation) scene.viewer.fixation = *options.fixation;
    if (!options.sweep.empty()) scene.sweep = options.sweep == "on";
    if (options.duration) scene.duration = *options.duration;
    check_frames(scene, options);
    if (options.at) {
        scenes::Scene until = scene;
        until.duration = *options.at;
        check_frames(until, options);
    }
    return scene;
}

template <int Dim>
scenes::Setup<Dim> stage(const scenes::Scene& scene, const Options& options) {
    ProgressBar bar("Building the trees");
    scenes::SetupOptions how;
    how.raise_limits = options.raise_limits;
    how.cache = cache_of(options);
    how.progress = [&](double share) { bar.show(share); };
    scenes::Setup<Dim> setup = scenes::set_up<Dim>(scene, how);
    remark_all(setup.warnings);
    return setup;
}

template <int Dim>
scenes::Run<Dim> play(const scenes::Setup<Dim>& setup, const Options& options,
                      const std::string& label) {
    const scenes::Scene& scene = setup.scene;
    check_frames(scene, options);
    ProgressBar bar(label);
    scenes::RunOptions run = run_options(scene);
    run.progress = [&](double share) { bar.show(share); };
    scenes::Run<Dim> result = scenes::run(setup.bodies, run);
    remark_all(scenes::speed_warnings<Dim>(scene, setup.bodies, result));
    return result;
}

#define CLI_INSTANTIATE(Dim)                                                 \
    template scenes::Setup<Dim> stage(const scenes::Scene&, const Options&); \
    template scenes::Run<Dim> play(const scenes::Setup<Dim>&, const Options&, const std::string&);
CLI_INSTANTIATE(2)
CLI_INSTANTIATE(3)
#undef CLI_INSTANTIATE

}  // namespace cli
