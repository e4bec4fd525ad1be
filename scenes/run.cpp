#include "lodlab/scenes/run.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/base/to_chars.hpp"
#include "lodlab/core/frame/state_hash.hpp"

namespace scenes {
namespace {

constexpr double runaway_metres = 1e9;
constexpr double runaway_speed = 1e9;  // m/s and rad/s

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
        if (body.position.norm() < runaway_metres && body.velocity.norm() < runaway_speed &&
            body.spin.norm() < runaway_speed)
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
    const bool beyond_leaves = scene.finest.level != lod::Finest::leaves;
    settings.sweep.on = scene.sweep.value_or(beyond_leaves);
    // What is swept is paid by no budget: under one, as little as may be.
    const bool limited = limits.node_tests || limits.milliseconds;
    settings.sweep.deepest_level = limited ? 0 : settings.deepest_level;
    settings.sweep.exact = beyond_leaves && !limited && !limits.level;
    settings.sweep.tolerance = scene.finest.tolerance;
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

namespace {

/// A number with three digits.
std::string rounded(double number) {
    return lod::number_text(number, std::chars_format::general, 3);
}

/// Whether there is something that it could pass through.
template <int Dim>
bool has_others(std::span<const lod::Body<Dim>> bodies, std::size_t body) {
    for (std::size_t other = 0; other < bodies.size(); ++other)
        if (other != body && !bodies[other].tree->is_half_space()) return true;
    return false;
}

}  // namespace

template <int Dim>
std::vector<std::string> speed_warnings(const Scene& scene, std::span<const lod::Body<Dim>> bodies,
                                        const Run<Dim>& run) {
    std::vector<std::string> lines;
    if (run.settings.sweep.on) return lines;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!has_others(bodies, i)) continue;
        lod::Body<Dim> body = bodies[i];
        double furthest = 0;
        for (const Step<Dim>& step : run.steps) {
            put(step.before[i], body);
            furthest = std::max(furthest, lod::reach_of_motion(body, run.settings.time_step));
        }
        const double thickness = lod::thickness(*body.tree);
        if (furthest <= thickness) continue;
        lines.push_back("body " + scene.bodies[i].name + " moves up to " + rounded(furthest) +
                        " m a frame and is " + rounded(thickness) +
                        " m thick, so it may pass through others unseen; let fast bodies be swept "
                        "(sweep = true, --sweep on), or stay below " +
                        rounded(thickness / run.settings.time_step) + " m/s");
    }
    return lines;
}

template <int Dim>
Summary summarise(const Run<Dim>& run) {
    Summary summary;
    std::vector<int> levels;
    std::vector<double> milliseconds;
    for (const Step<Dim>& step : run.steps) {
        summary.tests += step.record.tests;
        summary.contacts += step.record.impacts.size();
        summary.swept_contacts += step.record.swept.size();
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
    template std::vector<std::string> speed_warnings(                      \
        const Scene&, std::span<const lod::Body<Dim>>, const Run<Dim>&);   \
    template Run<Dim> run(std::vector<lod::Body<Dim>>, const RunOptions&); \
    template Summary summarise(const Run<Dim>&);
SCENES_INSTANTIATE(2)
SCENES_INSTANTIATE(3)
#undef SCENES_INSTANTIATE

}  // namespace scenes
