#include "cli/instant.hpp"

#include <algorithm>
#include <cmath>

#include "cli/staging.hpp"

namespace cli {
namespace {

bool leaves_meet(const scenes::Step<2>& step) {
    return std::any_of(step.record.pairs.begin(), step.record.pairs.end(), [](const auto& pair) {
        return pair.verdict == lod::Verdict::true_collision;
    });
}

std::size_t telling_frame(const scenes::Run<2>& run) {
    const auto meeting = std::find_if(run.steps.begin(), run.steps.end(), leaves_meet);
    if (meeting != run.steps.end()) return static_cast<std::size_t>(meeting - run.steps.begin());
    const auto busiest = std::max_element(
        run.steps.begin(), run.steps.end(),
        [](const auto& x, const auto& y) { return x.record.tests < y.record.tests; });
    return static_cast<std::size_t>(busiest - run.steps.begin());
}

}  // namespace

Instant instant_of(const scenes::Setup& setup, const Options& options) {
    scenes::Setup finest = setup;
    finest.scene.limits = {};
    if (options.at) finest.scene.duration = *options.at + finest.scene.time_step;
    const scenes::Run<2> run = play(finest, options, "Moving to the instant");
    const std::size_t frame =
        options.at ? static_cast<std::size_t>(std::lround(*options.at / setup.scene.time_step))
                   : telling_frame(run);
    const std::size_t index = std::min(frame, run.steps.size() - 1);

    Instant instant;
    instant.time = static_cast<double>(index) * setup.scene.time_step;
    instant.bodies = setup.bodies;
    for (std::size_t i = 0; i < instant.bodies.size(); ++i)
        scenes::put(run.steps[index].before[i], instant.bodies[i]);
    lod::FrameStorage<2> storage;
    lod::Budget budget = lod::Budget::unlimited();
    instant.record = lod::detect<2>(
        instant.bodies, scenes::frame_settings(setup.scene, setup.scene.limits), budget, storage);
    return instant;
}

std::vector<lod::Front> levels_of(const Instant& instant, const lod::PairRecord& pair) {
    return lod::traverse_levels(instant.bodies[static_cast<std::size_t>(pair.bodies.a)],
                                instant.bodies[static_cast<std::size_t>(pair.bodies.b)],
                                pair.level);
}

}  // namespace cli
