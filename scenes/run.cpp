#include "lodlab/scenes/run.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/error.hpp"
#include "lodlab/core/state_hash.hpp"

namespace scenes {
namespace {

constexpr double most_metres = 1e9;
constexpr double most_speed = 1e9;  // m/s and rad/s

std::chrono::nanoseconds nanoseconds(double milliseconds) {
    return std::chrono::nanoseconds(static_cast<std::int64_t>(milliseconds * 1e6));
}

lod::Budget frame_budget(const RunOptions& options, std::size_t frame) {
    if (!options.cuts.empty()) {
        const auto& cut = options.cuts[frame];
        return cut ? lod::Budget::until(*cut) : lod::Budget::unlimited();
    }
    if (options.limits.milliseconds)
        return lod::Budget::deadline(*options.clock, nanoseconds(*options.limits.milliseconds),
                                     time_of_a_node_pair);
    if (options.limits.node_tests) return lod::Budget::node_tests(*options.limits.node_tests);
    return lod::Budget::unlimited();
}

template <int Dim>
void check_range(std::span<const lod::Body<Dim>> bodies, std::size_t frame) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const lod::Body<Dim>& body = bodies[i];
        if (body.position.norm() < most_metres && body.velocity.norm() < most_speed &&
            body.spin.norm() < most_speed)
            continue;
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         "frame " + std::to_string(frame) + ": body number " +
                             std::to_string(i + 1) +
                             " moves beyond 1e9 m or 1e9 m/s; the response sum does that, "
                             "choose net, or shorten the duration");
    }
}

template <int Dim>
std::vector<State<Dim>> states_of(std::span<const lod::Body<Dim>> bodies) {
    std::vector<State<Dim>> states;
    states.reserve(bodies.size());
    for (const lod::Body<Dim>& body : bodies) states.push_back(state_of(body));
    return states;
}

/// Value at the share of a sorted list, by the nearest rank.
template <class T>
T at_share(const std::vector<T>& sorted, double share) {
    const auto rank = std::ceil(share * static_cast<double>(sorted.size()));
    const auto index = static_cast<std::size_t>(std::max(1.0, rank)) - 1;
    return sorted[std::min(index, sorted.size() - 1)];
}

}  // namespace

template <int Dim>
State<Dim> state_of(const lod::Body<Dim>& body) {
    return {body.position, body.orientation, body.velocity, body.spin};
}

template <int Dim>
void put(const State<Dim>& state, lod::Body<Dim>& body) {
    body.position = state.position;
    body.orientation = state.orientation;
    body.velocity = state.velocity;
    body.spin = state.spin;
}

lod::FrameSettings frame_settings(const Scene& scene, const Limits& limits) {
    lod::FrameSettings settings;
    settings.time_step = scene.time_step;
    if (limits.level) settings.deepest_level = *limits.level;
    settings.contact_model = scene.contact_model;
    settings.point_model = scene.point_model;
    settings.response = scene.response;
    settings.priority = scene.priority;
    settings.finest = scene.finest;
    return settings;
}

template <int Dim>
Run<Dim> run(std::vector<lod::Body<Dim>> bodies, const RunOptions& options) {
    const std::span<const lod::Body<Dim>> seen(bodies);
    Run<Dim> result;
    result.settings = options.settings;
    result.energy_start = lod::kinetic_energy(seen);
    result.momentum_start = lod::momentum(seen);
    lod::FrameStorage<Dim> storage;
    const auto frames = static_cast<std::size_t>(options.frames);
    for (std::size_t frame = 0; frame < frames; ++frame) {
        lod::check_interrupted();
        Step<Dim> step;
        step.before = states_of(seen);
        const auto begin = options.clock ? options.clock->now() : std::chrono::nanoseconds{};
        lod::Budget budget = frame_budget(options, frame);
        step.record = lod::advance<Dim>(bodies, options.settings, budget, storage);
        if (options.clock) step.taken = options.clock->now() - begin;
        check_range(seen, frame);
        step.state_hash = lod::state_hash(seen);
        result.steps.push_back(std::move(step));
        if (options.progress)
            options.progress(static_cast<double>(frame + 1) / static_cast<double>(frames));
    }
    result.end = states_of(seen);
    result.state_hash = lod::state_hash(seen);
    result.energy_end = lod::kinetic_energy(seen);
    result.momentum_end = lod::momentum(seen);
    return result;
}

template <int Dim>
Summary summarise(const Run<Dim>& run) {
    Summary summary;
    std::vector<int> levels;
    std::vector<double> milliseconds;
    for (const Step<Dim>& step : run.steps) {
        summary.tests += step.record.tests;
        summary.contacts += step.record.impacts.size();
        summary.interrupted_frames += step.record.interrupted() ? 1 : 0;
        for (const lod::PairRecord& pair : step.record.pairs) {
            summary.exact_pairs += pair.finest != lod::Finest::leaves ? 1 : 0;
            summary.backtracked_pairs += pair.finest == lod::Finest::backtrack ? 1 : 0;
            if (pair.verdict != lod::Verdict::apart) levels.push_back(pair.level);
        }
        milliseconds.push_back(static_cast<double>(step.taken.count()) * 1e-6);
    }
    if (!levels.empty()) {
        std::sort(levels.begin(), levels.end());
        summary.level_min = levels.front();
        summary.level_median = at_share(levels, 0.5);
        summary.level_max = levels.back();
    }
    if (!milliseconds.empty()) {
        std::sort(milliseconds.begin(), milliseconds.end());
        summary.frame_ms_median = at_share(milliseconds, 0.5);
        summary.frame_ms_p99 = at_share(milliseconds, 0.99);
        summary.frame_ms_max = milliseconds.back();
    }
    return summary;
}

#define SCENES_INSTANTIATE(Dim)                                            \
    template State<Dim> state_of(const lod::Body<Dim>&);                   \
    template void put(const State<Dim>&, lod::Body<Dim>&);                 \
    template Run<Dim> run(std::vector<lod::Body<Dim>>, const RunOptions&); \
    template Summary summarise(const Run<Dim>&);
SCENES_INSTANTIATE(2)
SCENES_INSTANTIATE(3)
#undef SCENES_INSTANTIATE

}  // namespace scenes
