#include "cli/stage/simulation.hpp"

#include "cli/arguments/misused.hpp"
#include "cli/stage/staging.hpp"
#include "cli/stage/threads.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "lodlab/scenes/trace/trace_player.hpp"
#include "lodlab/scenes/trace/trace_writer.hpp"

namespace cli {
namespace {

/// Takes the frames of a run as they come.
template <int Dim>
class Taker {
  public:
    Taker(const scenes::Setup<Dim>& setup, const Options& options, const scenes::RunOptions& run)
        : options_(options), watch_(setup.bodies, run.settings) {
        result_.run.settings = run.settings;
        result_.run.limits = run.limits;
        if (options.trace.empty()) return;
        scenes::TraceSettings settings;
        settings.key_frames = options.key_frames.value_or(0);
        settings.records = options.records;
        writer_.emplace(
            options.trace,
            scenes::TraceOrigin<Dim>{setup.scene.name, setup.bodies, run.settings, run.limits},
            settings);
    }
    /// One that goes on where a trace ends.
    Taker(const scenes::Setup<Dim>& setup, const Options& options, const scenes::RunOptions& run,
          const scenes::Trace& earlier)
        : options_(options), watch_(setup.bodies, run.settings) {
        result_.run.settings = run.settings;
        result_.run.limits = run.limits;
        result_.first_frame = earlier.frames();
        if (!options.trace.empty()) writer_.emplace(options.trace, earlier);
    }

    void begin(std::span<const lod::Body<Dim>> bodies) {
        result_.run.energy_start = lod::kinetic_energy(bodies);
        result_.run.momentum_start = lod::momentum(bodies);
    }
    void take(const scenes::Step<Dim>& step, std::span<const lod::Body<Dim>> after) {
        tally_.add(step);
        watch_.add(step);
        if (writer_) writer_->add(step, scenes::states_of(after));
        if (!options_.out.empty()) result_.run.steps.push_back(step);
        result_.run.state_hash = step.state_hash;
    }
    [[nodiscard]] Simulation<Dim> end(std::span<const lod::Body<Dim>> bodies) {
        if (writer_) writer_->finish();
        result_.run.end = scenes::states_of(bodies);
        result_.run.energy_end = lod::kinetic_energy(bodies);
        result_.run.momentum_end = lod::momentum(bodies);
        result_.summary = tally_.summary();
        result_.frames = static_cast<std::int64_t>(tally_.steps());
        return std::move(result_);
    }
    void warn(const scenes::Scene& scene) const { remark_all(watch_.warnings(scene)); }

  private:
    const Options& options_;
    Simulation<Dim> result_;
    scenes::Tally tally_;
    scenes::SpeedWatch<Dim> watch_;
    std::optional<scenes::TraceWriter<Dim>> writer_;
};

template <int Dim>
Simulation<Dim> run_to_end(scenes::Runner<Dim>& runner, std::int64_t frames, Taker<Dim>& taker,
                           const scenes::Scene& scene) {
    taker.begin(runner.bodies());
    while (runner.frame() < frames) {
        const scenes::Step<Dim>& step = runner.next();
        taker.take(step, runner.bodies());
    }
    Simulation<Dim> done = taker.end(runner.bodies());
    taker.warn(scene);
    return done;
}

template <int Dim>
Simulation<Dim> played_again(const scenes::Setup<Dim>& setup, const Options& options,
                             const scenes::Trace& trace, lod::Executor* executor) {
    ProgressBar bar("Playing again");
    scenes::RunOptions run = run_options(setup.scene);
    run.settings = trace.head().settings;
    run.limits = trace.head().limits;
    run.executor = executor;
    run.progress = [&](double share) { bar.show(share); };
    scenes::TracePlayer<Dim> player(trace, setup.bodies, run);
    Taker<Dim> taker(setup, options, run);
    taker.begin(player.bodies());
    while (player.frame() < player.frames()) {
        const scenes::Step<Dim>& step = player.forward();
        taker.take(step, player.bodies());
    }
    return taker.end(player.bodies());
}

template <int Dim>
Simulation<Dim> continued(const scenes::Setup<Dim>& setup, const Options& options,
                          const scenes::Trace& trace, lod::Executor* executor) {
    scenes::Scene scene = setup.scene;
    scene.time_step = trace.head().settings.time_step;
    if (scene.frames() <= trace.frames())
        misused("the trace has " + std::to_string(trace.frames()) + " frames, " +
                readable(static_cast<double>(trace.frames()) * scene.time_step) +
                " s, already; let it go on to a later time by --duration");
    check_frames(scene, options);
    ProgressBar bar("Going on");
    scenes::RunOptions run = run_options(scene);
    run.settings = trace.head().settings;
    run.limits = trace.head().limits;
    run.executor = executor;
    run.progress = [&](double share) { bar.show(share); };
    scenes::Runner<Dim> runner(scenes::bodies_at_end(trace, setup.bodies), run, trace.frames());
    Taker<Dim> taker(setup, options, run, trace);
    return run_to_end(runner, run.frames, taker, scene);
}

}  // namespace

template <int Dim>
Simulation<Dim> simulated(const scenes::Setup<Dim>& setup, const Options& options,
                          const std::optional<scenes::Trace>& earlier) {
    const Threads threads(options);
    lod::Executor* const executor = threads.executor();
    if (earlier && !options.replay.empty()) return played_again(setup, options, *earlier, executor);
    if (earlier) return continued(setup, options, *earlier, executor);
    ProgressBar bar("Simulating");
    scenes::RunOptions run = run_options(setup.scene);
    run.executor = executor;
    run.progress = [&](double share) { bar.show(share); };
    scenes::Runner<Dim> runner(setup.bodies, run);
    Taker<Dim> taker(setup, options, run);
    return run_to_end(runner, run.frames, taker, setup.scene);
}

template Simulation<2> simulated(const scenes::Setup<2>&, const Options&,
                                 const std::optional<scenes::Trace>&);
template Simulation<3> simulated(const scenes::Setup<3>&, const Options&,
                                 const std::optional<scenes::Trace>&);

}  // namespace cli
