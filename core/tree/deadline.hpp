#pragma once

/// \file
/// A moment that a frame must not pass: when to look at the clock, and what still fits before it.

#include <chrono>
#include <cstdint>

namespace lod {

/// Where a deadline reads the time. Injected, so that a test owns the clock. A frame with an
/// executor reads it from its threads, too.
class Clock {
  public:
    virtual ~Clock() = default;
    /// Time since any one moment. Where it goes back, a deadline takes it to stand still.
    [[nodiscard]] virtual std::chrono::nanoseconds now() const = 0;
};

/// std::chrono::steady_clock.
class SteadyClock final : public Clock {
  public:
    /// Time since any one moment; never decreasing.
    [[nodiscard]] std::chrono::nanoseconds now() const override;
};

/// What a frame has done so far and has to pay for later.
struct Work {
    std::uint64_t tests = 0;       ///< node tests, those that levels count as included
    std::uint64_t node_pairs = 0;  ///< to be modelled and answered
};

/// What was left of a quota on a clock when the levels of a frame were done.
struct AfterLevels {
    std::chrono::nanoseconds left{};      ///< negative where the quota was over
    std::chrono::nanoseconds reserved{};  ///< held back for what follows; more than what was left,
                                          ///< where the levels that are always done took too long
    /// Whether they are the same.
    friend bool operator==(const AfterLevels&, const AfterLevels&) = default;
};

/// What a frame does after its levels, whatever the clock says.
struct Aftermath {
    std::uint64_t bodies = 0;
    std::uint64_t contacts = 0;  ///< made already
    std::uint64_t to_touch = 0;  ///< pairs that will touch as their root balls do
};

/// How long things take on a clock, as earlier frames measured it.
struct Pace {
    double test = 4;  ///< [ns] a node test; before any was measured: of a slow processor
    /// [ns] all that follows the levels, for each node pair of a front; 0: not measured yet.
    double pair = 0;
    double entry = 700;   ///< [ns] a pair's entry levels and its contacts
    double response = 8;  ///< [ns] for each body, and as much for a quarter of a contact
    double motion = 16;   ///< [ns] all that follows the response, for each body
};

/// A deadline on a clock. The time of node tests is predicted from how long they took so far, and
/// the time of what follows from what it took in the last frames.
class Deadline {
  public:
    /// The quota counts from now on; `pair_time` is that of a node pair, kept in reserve, until a
    /// frame has measured it; 0: nothing is reserved.
    Deadline(const Clock& clock, std::chrono::nanoseconds quota,
             std::chrono::nanoseconds pair_time);

    /// Begins to measure how long a node test takes.
    void expect(const Pace& pace, const Work& done);
    /// Begins to measure how long what follows the levels takes.
    void levels_done(const Work& done);
    /// At the end of a frame: what to expect of the next. Of a node test, what was expected, a
    /// quarter of the way to what was measured; of what follows, what takes longer counts at once,
    /// and less by a sixteenth: the reserve should hold in nearly all frames. Neither more than
    /// doubles or halves, for a frame may have been preempted.
    [[nodiscard]] Pace next_pace() const;

    /// Keeps half of the time left for what follows, at least what so many node pairs take, and
    /// reserves nothing else until `join`.
    void divide(std::uint64_t node_pairs);
    /// Goes on to the end. Returns how many node pairs there is time for.
    [[nodiscard]] std::uint64_t join(const Work& done);

    /// Whether the time for so many tests more is there. Looks at the clock only where it is near.
    [[nodiscard]] bool fits(std::uint64_t tests, const Work& done);
    /// Whether it is over, less what is reserved. Looks at the clock only where it is near.
    [[nodiscard]] bool passed(const Work& done);

    /// By the last look at the clock: the node tests for which there was time, nothing reserved.
    [[nodiscard]] double tests_left() const;
    /// A node pair's time in node tests.
    [[nodiscard]] double pair_cost() const { return pair_time_ / pace_; }
    /// Whether what must follow does not fit any more. Looks at the clock; several threads may.
    [[nodiscard]] bool is_late(const Aftermath& after) const {
        return static_cast<double>(left().count()) < time_of(after);
    }
    /// How many pairs can be taken to their entry levels where all can touch as root balls.
    [[nodiscard]] std::uint64_t entries(const Aftermath& all);
    /// Whether beside their entries there is no time to begin with deeper levels. Looks at no
    /// clock.
    [[nodiscard]] bool is_spent_by(std::uint64_t entered, const Aftermath& all) const;
    /// Says that the entry levels of so many pairs are done.
    void entered(std::uint64_t pairs);
    /// Says that the contacts are.
    void contacts_done(const Aftermath& all);
    /// Whether there is time to ask so many pairs again, of which the last time so many were asked.
    [[nodiscard]] bool goes_on(std::uint64_t pairs, std::uint64_t before);
    /// Says that the response is done; and what the clock ended.
    void response_done(bool contacts_cut, bool rounds_cut);

    /// Negative when it is over. Looks at the clock.
    [[nodiscard]] std::chrono::nanoseconds left() const { return end_ - clock_->now(); }

    /// At the end of the levels.
    [[nodiscard]] AfterLevels after_levels() const;

    /// No processor is faster than that: what a clock that stands still is taken for.
    static constexpr double least_pace = 0.05;
    /// Fewer tests and node pairs measure nothing.
    static constexpr std::uint64_t least_measured = 512;
    static constexpr std::uint64_t least_pairs_measured = 16;
    /// The next look at the clock comes when a quarter of the time left is over, by prediction, but
    /// not sooner nor later than after so many tests: .1 us and 20 us, about, where a look takes
    /// .02 us.
    static constexpr double least_unread = 64;
    static constexpr double most_unread = 8192;
    /// Of the response a contact takes as much as so many bodies; a pair that touches as its root
    /// balls do, besides, to be modelled.
    static constexpr double bodies_of_a_contact = 4;
    static constexpr double bodies_of_a_touch = 3;
    /// Times that are predicted and cannot be ended are taken to be that much longer.
    static constexpr double margin = 1.02;
    /// No processor is faster [ns a body].
    static constexpr double least_response = 0.5;
    static constexpr double least_motion = 0.5;
    /// [ns] to weigh a pair and put it into the heap.
    static constexpr double to_wait = 60;

  private:
    [[nodiscard]] double time_of(const Aftermath& after) const;
    [[nodiscard]] double more_of_an_entry() const;
    void learn_after(std::chrono::nanoseconds now, Pace& next) const;
    double read(const Work& done);
    void measure(std::uint64_t tests);
    [[nodiscard]] bool is_far(const Work& done, std::uint64_t tests) const;

    const Clock* clock_;
    std::chrono::nanoseconds end_;
    std::chrono::nanoseconds last_;    ///< the latest reading
    double pair_time_;                 ///< [ns]
    std::chrono::nanoseconds kept_{};  ///< while divided
    double undivided_pair_time_ = 0;
    double next_reading_ = 0;  ///< of tests done
    std::uint64_t pairs_at_reading_ = 0;
    Pace expected_;
    double measured_ = 0;  ///< [ns a test]; 0: nothing yet
    double pace_ = expected_.test;
    std::chrono::nanoseconds from_;  ///< when measuring began
    std::uint64_t tests_from_ = 0;
    std::chrono::nanoseconds levels_end_;
    std::uint64_t pairs_at_end_ = 0;
    std::chrono::nanoseconds entry_begin_{};
    std::chrono::nanoseconds entry_time_{};
    std::chrono::nanoseconds contacts_end_{};
    std::chrono::nanoseconds round_end_{};
    std::chrono::nanoseconds response_end_{};
    std::uint64_t entered_ = 0;
    Aftermath after_;
    bool measures_after_ = false;  ///< response and motion of this frame
    bool cut_after_ = false;       ///< contacts or response
    bool rounds_cut_ = false;
};

}  // namespace lod
