#include "cli/stage/instant.hpp"

#include <algorithm>
#include <cmath>

#include "cli/stage/staging.hpp"

namespace cli {
namespace {

template <int Dim>
bool leaves_meet(const scenes::Step<Dim>& step) {
    return std::any_of(step.record.pairs.begin(), step.record.pairs.end(), [](const auto& pair) {
        return pair.verdict == lod::Verdict::true_collision;
    });
}

template <int Dim>
std::size_t telling_frame(const scenes::Run<Dim>& run) {
    const auto meeting = std::find_if(run.steps.begin(), run.steps.end(), leaves_meet<Dim>);
    if (meeting != run.steps.end()) return static_cast<std::size_t>(meeting - run.steps.begin());
    const auto busiest = std::max_element(
        run.steps.begin(), run.steps.end(),
        [](const auto& x, const auto& y) { return x.record.tests < y.record.tests; });
    return static_cast<std::size_t>(busiest - run.steps.begin());
}

}  // namespace

template <int Dim>
Instant<Dim> instant_of(const scenes::Setup<Dim>& setup, const Options& options) {
    scenes::Setup<Dim> finest = setup;
    finest.scene.limits = {};
    if (options.at) finest.scene.duration = *options.at + finest.scene.time_step;
    const scenes::Run<Dim> run = play(finest, options, "Moving to the instant");
    const std::size_t frame =
        options.at ? static_cast<std::size_t>(std::lround(*options.at / setup.scene.time_step))
                   : telling_frame(run);
    const std::size_t index = std::min(frame, run.steps.size() - 1);

    Instant<Dim> instant;
    instant.time = static_cast<double>(index) * setup.scene.time_step;
    instant.bodies = setup.bodies;
    for (std::size_t i = 0; i < instant.bodies.size(); ++i)
        scenes::put(run.steps[index].before[i], instant.bodies[i]);
    lod::FrameStorage<Dim> storage;
    lod::Budget budget = lod::Budget::unlimited();
    instant.record = lod::detect<Dim>(
        instant.bodies, scenes::frame_settings(setup.scene, setup.scene.limits), budget, storage);
    return instant;
}

template <int Dim>
std::vector<lod::Front> levels_of(const Instant<Dim>& instant, const lod::PairRecord& pair) {
    return lod::traverse_levels(instant.bodies[static_cast<std::size_t>(pair.bodies.a)],
                                instant.bodies[static_cast<std::size_t>(pair.bodies.b)],
                                pair.level);
}

#define CLI_INSTANTIATE(Dim)                                                     \
    template Instant<Dim> instant_of(const scenes::Setup<Dim>&, const Options&); \
    template std::vector<lod::Front> levels_of(const Instant<Dim>&, const lod::PairRecord&);
CLI_INSTANTIATE(2)
CLI_INSTANTIATE(3)
#undef CLI_INSTANTIATE

}  // namespace cli
