#pragma once

/// \file
/// Plays a trace again from any frame on, forwards and backwards, and finds where a replay differs.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lodlab/core/base/error.hpp"
#include "lodlab/scenes/trace/trace.hpp"

namespace scenes {

/// Where a replay differs from its trace first.
struct Difference {
    std::int64_t frame = 0;
    Stage stage = Stage::state;
    /// Index of the first body that the frame leaves in another state (in Stage::state: finds in
    /// one); nothing where it is none, or where the trace, one of version 2, does not tell.
    std::optional<std::size_t> body;
};

/// The error of a replay that differs; input refused.
class Divergence : public lod::Error {
  public:
    /// Says in one line where `trace` differs.
    Divergence(const Trace& trace, const Difference& where);
    /// Frame, stage and body.
    [[nodiscard]] const Difference& where() const { return where_; }

  private:
    Difference where_;
};

/// Plays a trace again. It stands at a frame, whose bodies it holds as that frame finds them. Every
/// frame that it runs is compared with the trace, stage by stage; every function that runs one
/// throws Divergence where it differs, and lod::Error (input refused) where the trace is damaged.
///
/// A seek runs the frames from the key frame before, at most TraceHead::key_frames, fewer where it
/// has been there since; so going back frame by frame runs each frame once, as going
/// forward does. Only with Priority::trade, where a frame depends on the one before by more than
/// the bodies, a seek runs all frames from the start. It holds the bodies of all frames from one
/// key frame to the next.
template <int Dim>
class TracePlayer {
  public:
    /// Stands at frame 0. `options` gives a clock for the frames' times; the rest comes from the
    /// trace. Throws lod::Error (input refused) when the bodies are not those of the trace at its
    /// start.
    TracePlayer(Trace trace, std::vector<lod::Body<Dim>> bodies_at_start,
                const RunOptions& options = {});

    /// What is played.
    [[nodiscard]] const Trace& trace() const { return trace_; }
    /// How many frames the trace has.
    [[nodiscard]] std::int64_t frames() const { return trace_.frames(); }
    /// Where it stands, from 0; frames() after the last one.
    [[nodiscard]] std::int64_t frame() const { return frame_; }
    /// The bodies there.
    [[nodiscard]] std::span<const lod::Body<Dim>> bodies() const { return bodies_; }
    /// Theirs: lod::state_hash.
    [[nodiscard]] std::uint64_t state_hash() const;

    /// Stands at another frame. Requires: 0 <= frame <= frames().
    void seek(std::int64_t frame);
    /// Stands one frame further; what that frame did. Valid until it moves again. Requires:
    /// frame() < frames().
    const Step<Dim>& forward();
    /// Stands one frame before. Requires: frame() > 0.
    void back() { seek(frame_ - 1); }
    /// What the frame does whose bodies it stands at, and moves on no further. Valid until it
    /// moves. Requires: frame() < frames().
    const Step<Dim>& step();

    /// How many frames it has run so far: what its seeks have cost.
    [[nodiscard]] std::uint64_t frames_run() const { return frames_run_; }

  private:
    void load(std::int64_t frame);
    void run_next();
    void lead_runner_to(std::int64_t frame);
    void stand_at(std::int64_t frame);
    void check_end();
    [[nodiscard]] std::size_t place(std::int64_t frame) const;
    void check_states(std::int64_t frame, const std::vector<State<Dim>>& played,
                      const std::vector<State<Dim>>& told) const;

    Trace trace_;
    Runner<Dim> runner_;
    std::vector<lod::Body<Dim>> bodies_;
    TraceInterval interval_;
    std::vector<std::vector<State<Dim>>> states_;  ///< of the interval's frames, as far as known
    std::vector<State<Dim>> start_;                ///< the scene's
    Step<Dim> step_;
    std::int64_t step_of_ = -1;  ///< the frame of step_
    std::int64_t frame_ = 0;
    std::uint64_t frames_run_ = 0;
};

/// Plays a trace again as a whole. Throws as TracePlayer does. `options` gives the clock and the
/// progress; its settings, frames, limits and cuts come from the trace.
template <int Dim>
[[nodiscard]] Run<Dim> replay(const Trace& trace, std::vector<lod::Body<Dim>> bodies,
                              const RunOptions& options = {});

/// The bodies as a trace leaves them, for a run that goes on from there: they are those of one that
/// never stopped. Throws lod::Error (input refused) when the bodies are not those of the trace at
/// its start, or the trace is damaged, of version 2, or of a run scheduled by Priority::trade.
template <int Dim>
[[nodiscard]] std::vector<lod::Body<Dim>> bodies_at_end(
    const Trace& trace, std::vector<lod::Body<Dim>> bodies_at_start);

}  // namespace scenes
