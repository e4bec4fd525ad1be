#include "lodlab/scenes/run.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/base/to_chars.hpp"
#include "lodlab/core/frame/state_hash.hpp"

namespace scenes {
namespace {

constexpr double runaway_metres = 1e9;
constexpr double runaway_speed = 1e9;  // m/s and rad/s

/// What is no number is no time, and what is more than there is, all of it.
std::chrono::nanoseconds nanoseconds(double milliseconds) {
    if (!(milliseconds > 0)) return {};
    if (milliseconds > 1e12) return (std::chrono::nanoseconds::max)();
    return std::chrono::nanoseconds(static_cast<std::int64_t>(milliseconds * 1e6));
}

lod::Budget budget_until(const std::optional<lod::Cut>& cut) {
    return cut ? lod::Budget::until(*cut) : lod::Budget::unlimited();
}

lod::Budget frame_budget(const RunOptions& options, std::int64_t frame) {
    if (!options.cuts.empty()) return budget_until(options.cuts[static_cast<std::size_t>(frame)]);
    return budget_of(options.limits, options.clock);
}

template <int Dim>
void check_range(std::span<const lod::Body<Dim>> bodies, std::int64_t frame) {
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

/// Place in a sorted list of so many, > 0, at the share of it, by the nearest rank.
std::uint64_t place_at(double share, std::uint64_t count) {
    const auto rank = std::ceil(share * static_cast<double>(count));
    return std::min(static_cast<std::uint64_t>(std::max(1.0, rank)), count) - 1;
}

/// The index at a place in the sorted list that has each index as often as the counts say.
int index_at(std::uint64_t place, const std::vector<std::uint64_t>& counts) {
    std::size_t index = 0;
    for (std::uint64_t before = counts[0]; before <= place; before += counts[index]) ++index;
    return static_cast<int>(index);
}

}  // namespace

lod::Budget budget_of(const Limits& limits, const lod::Clock* clock) {
    if (limits.milliseconds)
        return lod::Budget::deadline(*clock, nanoseconds(*limits.milliseconds),
                                     time_of_a_node_pair);
    if (limits.node_tests) return lod::Budget::node_tests(*limits.node_tests);
    return lod::Budget::unlimited();
}

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
    settings.viewer = scene.viewer;
    settings.organisation = scene.organisation;
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
std::vector<State<Dim>> states_of(std::span<const lod::Body<Dim>> bodies) {
    std::vector<State<Dim>> states;
    states.reserve(bodies.size());
    for (const lod::Body<Dim>& body : bodies) states.push_back(state_of(body));
    return states;
}

template <int Dim>
Runner<Dim>::Runner(std::vector<lod::Body<Dim>> bodies, const RunOptions& options,
                    std::int64_t first_frame)
    : bodies_(std::move(bodies)), options_(options), frame_(first_frame) {
    storage_.executor = options.executor;
}

template <int Dim>
std::chrono::nanoseconds Runner<Dim>::now() const {
    return options_.clock ? options_.clock->now() : std::chrono::nanoseconds{};
}

template <int Dim>
const Step<Dim>& Runner<Dim>::next() {
    lod::check_interrupted();
    const std::chrono::nanoseconds begin = now();
    return advance(frame_budget(options_, frame_), begin);
}

template <int Dim>
const Step<Dim>& Runner<Dim>::next(const std::optional<lod::Cut>& cut) {
    lod::check_interrupted();
    return advance(budget_until(cut), now());
}

template <int Dim>
const Step<Dim>& Runner<Dim>::advance(lod::Budget budget, std::chrono::nanoseconds begin) {
    const std::span<const lod::Body<Dim>> seen(bodies_);
    step_.before = states_of(seen);
    step_.record = lod::advance<Dim>(bodies_, options_.settings, budget, storage_);
    step_.taken = now() - begin;
    check_range(seen, frame_);
    step_.state_hash = lod::state_hash(seen);
    ++frame_;
    if (options_.progress)
        options_.progress(static_cast<double>(frame_) / static_cast<double>(options_.frames));
    return step_;
}

template <int Dim>
void Runner<Dim>::put(std::int64_t frame, const std::vector<State<Dim>>& states) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) scenes::put(states[i], bodies_[i]);
    frame_ = frame;
    storage_ = {};
    storage_.executor = options_.executor;
}

template <int Dim>
Run<Dim> run(std::vector<lod::Body<Dim>> bodies, const RunOptions& options) {
    Run<Dim> result;
    result.settings = options.settings;
    result.limits = options.limits;
    result.energy_start = lod::kinetic_energy<Dim>(bodies);
    result.momentum_start = lod::momentum<Dim>(bodies);
    Runner<Dim> runner(std::move(bodies), options);
    while (runner.frame() < options.frames) result.steps.push_back(runner.next());
    result.end = states_of(runner.bodies());
    result.state_hash = lod::state_hash(runner.bodies());
    result.energy_end = lod::kinetic_energy(runner.bodies());
    result.momentum_end = lod::momentum(runner.bodies());
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
SpeedWatch<Dim>::SpeedWatch(std::span<const lod::Body<Dim>> bodies,
                            const lod::FrameSettings& settings)
    : bodies_(bodies.begin(), bodies.end()),
      settings_(settings),
      furthest_(settings.sweep.on ? 0 : bodies.size()) {}

template <int Dim>
void SpeedWatch<Dim>::add(const Step<Dim>& step) {
    for (std::size_t i = 0; i < furthest_.size(); ++i) {
        put(step.before[i], bodies_[i]);
        furthest_[i] =
            std::max(furthest_[i], lod::reach_of_motion(bodies_[i], settings_.time_step));
    }
}

template <int Dim>
std::vector<std::string> SpeedWatch<Dim>::warnings(const Scene& scene) const {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < furthest_.size(); ++i) {
        if (!has_others(std::span<const lod::Body<Dim>>(bodies_), i)) continue;
        const double thickness = lod::thickness(*bodies_[i].tree);
        if (furthest_[i] <= thickness) continue;
        lines.push_back("body " + scene.bodies[i].name + " moves up to " + rounded(furthest_[i]) +
                        " m a frame and is " + rounded(thickness) +
                        " m thick, so it may pass through others unseen; let fast bodies be swept "
                        "(sweep = true, --sweep on), or stay below " +
                        rounded(thickness / settings_.time_step) + " m/s");
    }
    return lines;
}

template <int Dim>
std::vector<std::string> speed_warnings(const Scene& scene, std::span<const lod::Body<Dim>> bodies,
                                        const Run<Dim>& run) {
    SpeedWatch<Dim> watch(bodies, run.settings);
    for (const Step<Dim>& step : run.steps) watch.add(step);
    return watch.warnings(scene);
}

template <int Dim>
void Tally::add(const Step<Dim>& step) {
    sums_.tests += step.record.tests;
    sums_.contacts += step.record.impacts.size();
    sums_.swept_contacts += step.record.swept.size();
    sums_.interrupted_frames += step.record.interrupted() ? 1 : 0;
    for (const lod::PairRecord& pair : step.record.pairs) {
        sums_.exact_pairs += pair.finest != lod::Finest::leaves ? 1 : 0;
        sums_.backtracked_pairs += pair.finest == lod::Finest::backtrack ? 1 : 0;
        if (pair.verdict == lod::Verdict::apart) continue;
        const std::size_t level = lod::at(pair.level);
        if (pairs_at_.size() <= level) pairs_at_.resize(level + 1);
        ++pairs_at_[level];
    }
    milliseconds_.push_back(static_cast<double>(step.taken.count()) * 1e-6);
}

Summary Tally::summary() const {
    Summary summary = sums_;
    std::uint64_t pairs = 0;
    for (const std::uint64_t count : pairs_at_) pairs += count;
    if (pairs > 0) {
        summary.level_min = index_at(0, pairs_at_);
        summary.level_median = index_at(place_at(0.5, pairs), pairs_at_);
        summary.level_max = index_at(pairs - 1, pairs_at_);
    }
    if (!milliseconds_.empty()) {
        std::vector<double> sorted = milliseconds_;
        std::sort(sorted.begin(), sorted.end());
        summary.frame_ms_median = sorted[place_at(0.5, sorted.size())];
        summary.frame_ms_p99 = sorted[place_at(0.99, sorted.size())];
        summary.frame_ms_max = sorted.back();
    }
    return summary;
}

template <int Dim>
Summary summarise(const Run<Dim>& run) {
    Tally tally;
    for (const Step<Dim>& step : run.steps) tally.add(step);
    return tally.summary();
}

#define SCENES_INSTANTIATE(Dim)                                                  \
    template State<Dim> state_of(const lod::Body<Dim>&);                         \
    template void put(const State<Dim>&, lod::Body<Dim>&);                       \
    template std::vector<State<Dim>> states_of(std::span<const lod::Body<Dim>>); \
    template class Runner<Dim>;                                                  \
    template class SpeedWatch<Dim>;                                              \
    template std::vector<std::string> speed_warnings(                            \
        const Scene&, std::span<const lod::Body<Dim>>, const Run<Dim>&);         \
    template Run<Dim> run(std::vector<lod::Body<Dim>>, const RunOptions&);       \
    template void Tally::add(const Step<Dim>&);                                  \
    template Summary summarise(const Run<Dim>&);
SCENES_INSTANTIATE(2)
SCENES_INSTANTIATE(3)
#undef SCENES_INSTANTIATE

}  // namespace scenes
