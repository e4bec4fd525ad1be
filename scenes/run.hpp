#pragma once

/// \file
/// Runs a scene, frame by frame, and keeps each record.

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lodlab/scenes/scene.hpp"

namespace scenes {

/// Where a body is and how it moves. World frame, SI units.
template <int Dim>
struct State {
    lod::Vector<Dim> position = lod::Vector<Dim>::Zero();
    lod::Orientation<Dim> orientation = lod::Space<Dim>::unturned();
    lod::Vector<Dim> velocity = lod::Vector<Dim>::Zero();
    lod::Spin<Dim> spin = lod::Spin<Dim>::Zero();
};
/// The state of a body now.
template <int Dim>
[[nodiscard]] State<Dim> state_of(const lod::Body<Dim>& body);
/// Puts a body where a state says, moving as it says.
template <int Dim>
void put(const State<Dim>& state, lod::Body<Dim>& body);

/// One frame of a run: the bodies as the frame found them, and what it did.
template <int Dim>
struct Step {
    std::vector<State<Dim>> before;  ///< one a body, before response and motion
    lod::FrameRecord<Dim> record;
    std::uint64_t state_hash = 0;      ///< of the bodies after the frame
    std::chrono::nanoseconds taken{};  ///< by the frame on the clock; 0 without one
};

/// A whole run. Step k begins at time k x time_step.
template <int Dim>
struct Run {
    lod::FrameSettings settings;
    Limits limits;  ///< of its frames; a run that was played again has those of the trace
    std::vector<Step<Dim>> steps;
    std::vector<State<Dim>> end;  ///< after the last step
    std::uint64_t state_hash = 0;
    double energy_start = 0;  ///< kinetic [J]
    double energy_end = 0;
    lod::Vector<Dim> momentum_start = lod::Vector<Dim>::Zero();  ///< [kg m/s]
    lod::Vector<Dim> momentum_end = lod::Vector<Dim>::Zero();
};

/// How a run goes.
struct RunOptions {
    lod::FrameSettings settings;
    std::int64_t frames = 1;
    Limits limits;
    /// For `limits.milliseconds` (required there) and for the frames' times. It must outlive the
    /// run.
    const lod::Clock* clock = nullptr;
    /// Replay: where each frame was cut, nothing for a frame that was not. Takes the place of
    /// node_tests and milliseconds. Requires: empty or one entry a frame.
    std::span<const std::optional<lod::Cut>> cuts;
    /// Whose threads do the parts of a frame; it changes no bit and must outlive the run.
    lod::Executor* executor = nullptr;
    std::function<void(double share)> progress;  ///< called after every frame with the share done
};

/// Runs bodies frame by frame, for a caller that keeps of each frame what it wants; `run` keeps
/// all. A frame's bits follow from the bodies and the options alone, not from the frames before it.
template <int Dim>
class Runner {
  public:
    /// `first_frame`: how many frames have brought the bodies to where they are.
    Runner(std::vector<lod::Body<Dim>> bodies, const RunOptions& options,
           std::int64_t first_frame = 0);

    /// Runs the next frame under the limits, or the cuts, of the options. What it gives is valid
    /// until the next call. Throws as `run` does.
    const Step<Dim>& next();
    /// Runs the next frame as one that was cut there, whole where it was not.
    const Step<Dim>& next(const std::optional<lod::Cut>& cut);
    /// Goes on from there, one state a body, as if the frames before had just been run.
    void put(std::int64_t frame, const std::vector<State<Dim>>& states);

    /// How many frames have been run: the number of the next one.
    [[nodiscard]] std::int64_t frame() const { return frame_; }
    /// As they are before that frame.
    [[nodiscard]] std::span<const lod::Body<Dim>> bodies() const { return bodies_; }

  private:
    const Step<Dim>& advance(lod::Budget budget, std::chrono::nanoseconds begin);
    [[nodiscard]] std::chrono::nanoseconds now() const;

    std::vector<lod::Body<Dim>> bodies_;
    RunOptions options_;
    std::int64_t frame_ = 0;
    Step<Dim> step_;
    lod::FrameStorage<Dim> storage_;
};

/// One state a body.
template <int Dim>
[[nodiscard]] std::vector<State<Dim>> states_of(std::span<const lod::Body<Dim>> bodies);

/// What a deadline holds back for each overlapping node pair, for its contact and the response to
/// it: some five times what both took in a crowd (bench/crowd.cpp: 34 and 10 ns). How many row
/// visits the response may take at most is counted (FrameRecord::reserved_row_visits).
inline constexpr std::chrono::nanoseconds time_of_a_node_pair{250};

/// What a frame may spend under limits; `clock` is required with milliseconds, and must outlive it.
[[nodiscard]] lod::Budget budget_of(const Limits& limits, const lod::Clock* clock);

/// Runs the bodies for options.frames frames. The same bodies and options give the same bits,
/// except with milliseconds; such a run has the cuts with which it can be replayed. Throws
/// lod::Error (limit exceeded) when a body leaves the range that numbers and pictures hold, and
/// lod::Interrupted when stop_requested is set.
template <int Dim>
[[nodiscard]] Run<Dim> run(std::vector<lod::Body<Dim>> bodies, const RunOptions& options);

/// The settings of a scene as the frames take them, `limits` instead of the scene's own.
[[nodiscard]] lod::FrameSettings frame_settings(const Scene& scene, const Limits& limits);

/// Looks for bodies that move further in a frame than they are thick, where nothing is swept: they
/// may pass through others that no frame sees them in.
template <int Dim>
class SpeedWatch {
  public:
    /// Watches a run of these bodies.
    SpeedWatch(std::span<const lod::Body<Dim>> bodies, const lod::FrameSettings& settings);
    /// Looks at one frame.
    void add(const Step<Dim>& step);
    /// One line for every such body. Names it as the scene does, and the speed up to which that
    /// cannot happen. Requires: the bodies are the scene's.
    [[nodiscard]] std::vector<std::string> warnings(const Scene& scene) const;

  private:
    std::vector<lod::Body<Dim>> bodies_;
    lod::FrameSettings settings_;
    std::vector<double> furthest_;  ///< of each body, in one frame [m]
};

/// The lines of a SpeedWatch over a whole run. Requires: the run is one of scene and bodies.
template <int Dim>
[[nodiscard]] std::vector<std::string> speed_warnings(const Scene& scene,
                                                      std::span<const lod::Body<Dim>> bodies,
                                                      const Run<Dim>& run);

/// Numbers of a whole run, for reports.
struct Summary {
    std::uint64_t tests = 0;
    std::uint64_t contacts = 0;  ///< handed to the response, over all frames
    int interrupted_frames = 0;
    std::uint64_t exact_pairs = 0;        ///< that got exact contact, over all frames
    std::uint64_t backtracked_pairs = 0;  ///< of these: that responded at their time of impact
    std::uint64_t swept_contacts = 0;     ///< of fast bodies, between two frames
    /// Last finished level of the pairs whose nodes still overlapped there: those that the response
    /// treated as colliding. All -1 when there was none.
    int level_min = -1;
    int level_median = -1;
    int level_max = -1;
    double frame_ms_median = 0;
    double frame_ms_p99 = 0;
    double frame_ms_max = 0;
};
/// Adds up steps one by one. Holds eight bytes a step, for the times, and nothing else of them.
class Tally {
  public:
    /// Adds one step.
    template <int Dim>
    void add(const Step<Dim>& step);
    /// Of all that were added.
    [[nodiscard]] Summary summary() const;
    /// How many were added.
    [[nodiscard]] std::size_t steps() const { return milliseconds_.size(); }

  private:
    Summary sums_;
    std::vector<std::uint64_t>
        pairs_at_;  ///< colliding pairs whose last finished level is the index
    std::vector<double> milliseconds_;
};

/// Adds up a run.
template <int Dim>
[[nodiscard]] Summary summarise(const Run<Dim>& run);

}  // namespace scenes
