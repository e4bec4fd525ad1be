#include "lodlab/scenes/trace/trace_player.hpp"

#include <algorithm>

#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/scenes/trace/frame_mark.hpp"
#include "lodlab/scenes/trace/trace_json.hpp"

namespace scenes {
namespace {

std::string words_of(const Trace& trace, const Difference& where) {
    std::string words = "the replay differs from the trace (" + trace.source() + ") from frame " +
                        std::to_string(where.frame) + " on, first in the " +
                        std::string(lod::name_of(where.stage));
    if (where.body)
        words += where.stage == Stage::state
                     ? " that the frame finds, of body number "
                     : "; the first body that moves in another way is number ";
    if (where.body) words += std::to_string(*where.body + 1);
    return words + "; the trace was edited or written by another version";
}

/// The first stage that differs; nothing where none does.
std::optional<Stage> first_difference(const StageHashes& a, const StageHashes& b,
                                      bool motion_alone) {
    if (!motion_alone) {
        if (a.pairs != b.pairs) return Stage::pairs;
        if (a.levels != b.levels) return Stage::levels;
        if (a.contacts != b.contacts) return Stage::contacts;
        if (a.impulses != b.impulses) return Stage::impulses;
    }
    if (a.motion != b.motion) return Stage::motion;
    return std::nullopt;
}

template <class List>
std::optional<std::size_t> first_other(const List& a, const List& b) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (!(a[i] == b[i])) return i;
    return std::nullopt;
}

template <int Dim>
void check_start(const Trace& trace, std::span<const lod::Body<Dim>> bodies) {
    if (trace.head().dim != Dim || fingerprint(bodies) != trace.head().fingerprint)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "the scene is not the one of the trace (" + trace.head().scene +
                             ", or it has been changed since); name the scene of the trace");
}

/// As many as there are bodies.
template <int Dim>
std::vector<State<Dim>> told_states(const Trace& trace, const std::vector<double>& numbers,
                                    std::size_t bodies) {
    std::vector<State<Dim>> told = states_from<Dim>(numbers);
    if (told.size() != bodies)
        throw lod::Error(lod::ErrorKind::input_refused,
                         trace.source() + ": it tells of " + std::to_string(told.size()) +
                             " bodies, the scene has " + std::to_string(bodies) +
                             "; name the scene of the trace");
    return told;
}

template <int Dim>
RunOptions options_of(const Trace& trace, RunOptions options) {
    options.settings = trace.head().settings;
    options.frames = trace.frames();
    options.limits = {};
    options.cuts = {};
    return options;
}

}  // namespace

Divergence::Divergence(const Trace& trace, const Difference& where)
    : lod::Error(lod::ErrorKind::input_refused, words_of(trace, where)), where_(where) {}

template <int Dim>
TracePlayer<Dim>::TracePlayer(Trace trace, std::vector<lod::Body<Dim>> bodies_at_start,
                              const RunOptions& options)
    : trace_(std::move(trace)),
      runner_(bodies_at_start, options_of<Dim>(trace_, options)),
      bodies_(std::move(bodies_at_start)) {
    const std::span<const lod::Body<Dim>> bodies(bodies_);
    check_start(trace_, bodies);
    start_ = states_of(bodies);
    load(0);
    check_states(0, start_, states_.front());
}

template <int Dim>
std::uint64_t TracePlayer<Dim>::state_hash() const {
    return lod::state_hash<Dim>(bodies_);
}

template <int Dim>
std::size_t TracePlayer<Dim>::place(std::int64_t frame) const {
    return static_cast<std::size_t>(frame - interval_.first);
}

/// The frames around one, of which the first is known.
template <int Dim>
void TracePlayer<Dim>::load(std::int64_t frame) {
    interval_ = trace_.interval(frame);
    states_.clear();
    states_.push_back(interval_.states.empty()
                          ? start_
                          : told_states<Dim>(trace_, interval_.states, bodies_.size()));
    step_of_ = -1;
}

template <int Dim>
void TracePlayer<Dim>::check_states(std::int64_t frame, const std::vector<State<Dim>>& played,
                                    const std::vector<State<Dim>>& told) const {
    if (hash_of(played) == hash_of(told)) return;
    for (std::size_t i = 0; i < played.size(); ++i)
        if (hash_of<Dim>({played[i]}) != hash_of<Dim>({told[i]}))
            throw Divergence(trace_, {frame, Stage::state, i});
}

/// Makes the runner stand at a frame that it does not come to by itself. With Priority::trade what
/// pairs held in the frame before counts, so all frames before it are run.
template <int Dim>
void TracePlayer<Dim>::lead_runner_to(std::int64_t frame) {
    if (trace_.head().settings.priority != lod::Priority::trade) {
        runner_.put(frame, states_.back());
        return;
    }
    runner_.put(0, start_);
    while (runner_.frame() < frame) {
        const TraceInterval before = trace_.interval(runner_.frame());
        for (const FrameMark& told : before.frames) {
            if (runner_.frame() == frame) return;
            (void)runner_.next(told.cut);
            ++frames_run_;
        }
    }
}

/// Runs the first frame of the interval that has not been run, and compares it.
template <int Dim>
void TracePlayer<Dim>::run_next() {
    const std::int64_t frame = interval_.first + static_cast<std::int64_t>(states_.size()) - 1;
    if (runner_.frame() != frame || step_of_ != frame - 1) lead_runner_to(frame);
    const FrameMark& told = interval_.frames[place(frame)];
    step_ = runner_.next(told.cut);
    step_of_ = -1;  // until it is known to be right
    ++frames_run_;
    std::vector<State<Dim>> after = states_of(runner_.bodies());
    const FrameMark played = mark_of(step_, after);
    const bool old = told.bodies.empty();
    if (const auto stage = first_difference(played.hashes, told.hashes, old))
        throw Divergence(trace_, {frame, *stage, first_other(played.bodies, told.bodies)});
    step_.record.spending.time_left = told.time_left;  // the run's, not the replay's
    step_.record.spending.after_levels = told.after_levels;
    step_of_ = frame;
    states_.push_back(std::move(after));
}

template <int Dim>
void TracePlayer<Dim>::stand_at(std::int64_t frame) {
    const std::vector<State<Dim>>& states = states_[place(frame)];
    for (std::size_t i = 0; i < bodies_.size(); ++i) put(states[i], bodies_[i]);
    frame_ = frame;
}

template <int Dim>
void TracePlayer<Dim>::seek(std::int64_t frame) {
    const std::int64_t behind =
        interval_.first + static_cast<std::int64_t>(interval_.frames.size());
    const bool inside =
        frame >= interval_.first && (frame < behind || (frame == behind && frame == frames()));
    if (!inside) load(std::min(frame, frames() - 1));
    while (states_.size() <= place(frame)) run_next();
    stand_at(frame);
    if (frame == frames()) check_end();
}

template <int Dim>
const Step<Dim>& TracePlayer<Dim>::step() {
    const std::int64_t frame = frame_;
    if (step_of_ == frame) return step_;
    const std::size_t known = place(frame) + 1;
    if (states_.size() > known) states_.resize(known);  // it is run once more, for its record
    run_next();
    return step_;
}

template <int Dim>
const Step<Dim>& TracePlayer<Dim>::forward() {
    step();
    const std::int64_t next = frame_ + 1;
    if (next < frames() && place(next) == interval_.frames.size()) {
        const std::vector<State<Dim>> played = std::move(states_.back());
        load(next);
        step_of_ = next - 1;  // the runner stands there, and its step stays valid
        check_states(next, played, states_.front());
    }
    stand_at(next);
    if (next == frames()) check_end();
    return step_;
}

template <int Dim>
void TracePlayer<Dim>::check_end() {
    const std::vector<double> end = trace_.end();
    if (end.empty()) return;
    check_states(frames(), states_of<Dim>(bodies_), told_states<Dim>(trace_, end, bodies_.size()));
}

template <int Dim>
Run<Dim> replay(const Trace& trace, std::vector<lod::Body<Dim>> bodies, const RunOptions& options) {
    TracePlayer<Dim> player(trace, std::move(bodies), options);
    Run<Dim> result;
    result.settings = trace.head().settings;
    result.limits = trace.head().limits;
    result.energy_start = lod::kinetic_energy(player.bodies());
    result.momentum_start = lod::momentum(player.bodies());
    while (player.frame() < player.frames()) result.steps.push_back(player.forward());
    result.end = states_of(player.bodies());
    result.state_hash = player.state_hash();
    result.energy_end = lod::kinetic_energy(player.bodies());
    result.momentum_end = lod::momentum(player.bodies());
    return result;
}

template <int Dim>
std::vector<lod::Body<Dim>> bodies_at_end(const Trace& trace, std::vector<lod::Body<Dim>> bodies) {
    check_start<Dim>(trace, bodies);
    const std::vector<double> end = trace.end();
    if (end.empty())
        throw lod::Error(lod::ErrorKind::input_refused,
                         trace.source() +
                             ": a trace of version 2 does not tell how it ends; write it anew by "
                             "lodlab simulate --replay OLD --trace NEW");
    if (trace.head().settings.priority == lod::Priority::trade)
        throw lod::Error(
            lod::ErrorKind::input_refused,
            trace.source() +
                ": a run scheduled by trade does not go on from its trace, for that "
                "does not tell what pairs held; choose another policy, or run it anew");
    const std::vector<State<Dim>> told = told_states<Dim>(trace, end, bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) put(told[i], bodies[i]);
    const TraceInterval last = trace.interval(trace.frames() - 1);
    if (lod::state_hash<Dim>(bodies) != last.frames.back().hashes.motion)
        throw Divergence(trace, {trace.frames(), Stage::state, std::nullopt});
    return bodies;
}

#define SCENES_INSTANTIATE(Dim)                                                             \
    template class TracePlayer<Dim>;                                                        \
    template Run<Dim> replay(const Trace&, std::vector<lod::Body<Dim>>, const RunOptions&); \
    template std::vector<lod::Body<Dim>> bodies_at_end(const Trace&, std::vector<lod::Body<Dim>>);
SCENES_INSTANTIATE(2)
SCENES_INSTANTIATE(3)
#undef SCENES_INSTANTIATE

}  // namespace scenes
