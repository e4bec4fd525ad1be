#pragma once

/// \file
/// What a frame may spend, as node tests or as time; and where it was cut, so that it can be played
/// again.

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>

#include "lodlab/core/tree/deadline.hpp"

namespace lod {

/// The part of a frame that a budget decided by counting: all of it under a quota of node tests; on
/// a clock the end of it, from the first level that would not have fitted into the time left.
struct Counted {
    std::uint64_t from = 0;        ///< levels that had been asked for before (Budget::fits)
    std::uint64_t quota = 0;       ///< node tests of the whole frame and what is reserved
    double pair_cost = 0;          ///< node tests that a node pair of a front counts as
    std::uint64_t level_cost = 0;  ///< and each level that is begun
    friend bool operator==(const Counted&, const Counted&) = default;
};

/// Where a budget ended a frame: all that it takes to play the frame again.
struct Cut {
    /// Number of the candidate pair in whose level the clock ended the frame; -1 where none did.
    std::int32_t pair = -1;
    std::int32_t level = 0;   ///< in the making; one beyond the leaves for the true shapes
    std::uint64_t tests = 0;  ///< node tests of that level, all lost
    std::optional<Counted> counted = {};  ///< nothing where the clock alone decided
    /// Node pairs that were answered at most, where levels were stored and not all were answered.
    std::optional<std::uint64_t> answered = {};
    /// On a clock that left no time for all entry levels: of the candidate pairs that meet at level
    /// 0 so many, chosen by the policy, were taken to their entry levels, and none beyond.
    std::optional<std::uint64_t> entered = {};
    /// Candidate pairs whose contacts were modelled when the time was over; those after them touch
    /// as their root balls do.
    std::optional<std::uint64_t> modelled = {};
    /// Rounds of the response before the time was over.
    std::optional<std::int32_t> rounds = {};
    friend bool operator==(const Cut&, const Cut&) = default;
};

/// What a frame may spend on collision handling (section 5.1): a number of node tests, which is
/// exactly repeatable, or a time on a clock. The cost of what follows is reserved: nothing is begun
/// unless `spent + its own tests + reserved node pairs x cost of one <= quota`, and a level whose
/// node pairs the rest of the quota could not pay for is not kept.
///
/// On a clock the time of a level is predicted from how long a node test took so far. From the
/// first level that would not fit, the time that is left is turned into node tests, so that what is
/// left out follows from few numbers (Counted); the clock still ends the frame, within a level,
/// where the prediction was too bold.
class Budget {
  public:
    /// Grants every test: frames go to the finest level that their settings ask for.
    static Budget unlimited();
    /// `pair_cost`: of a node pair of a front, its modelling and its share of the response, in node
    /// tests.
    static Budget node_tests(std::uint64_t quota, double pair_cost = 0);
    /// The quota counts from now on. The clock must outlive the budget.
    static Budget deadline(const Clock& clock, std::chrono::nanoseconds quota,
                           std::chrono::nanoseconds pair_cost = {});
    /// Ends where another budget did, for the same bodies and settings.
    static Budget until(const Cut& cut);

    /// Says what the next tests are for: a candidate pair and the level in the making.
    void begin(std::int32_t pair, std::int32_t level);

    /// Whether the level in the making, of so many node tests, can finish. If not, it must be left
    /// out, but what costs less may still fit unless the budget ended.
    [[nodiscard]] bool fits(std::uint64_t tests);
    /// Whether any level of at least so many tests may still fit. Where not, all that waits is left
    /// out.
    [[nodiscard]] bool fits_any(std::uint64_t tests);

    /// Asks for `wanted` node tests and returns how many may be done. Fewer than wanted means that
    /// the level in the making must be dropped. `more_pairs` are the node pairs that it has found
    /// beyond the reserved ones.
    [[nodiscard]] std::uint64_t grant(std::uint64_t wanted, std::uint64_t more_pairs = 0);

    /// Whether what follows from `more_pairs` beyond the reserved ones can be paid as well. If not,
    /// the level that brought them must be dropped.
    [[nodiscard]] bool keeps_level(std::uint64_t more_pairs);

    /// Node tests that are done whatever the budget says: the entry level of every pair, the
    /// method's one requirement. They count as spent.
    void spend(std::uint64_t tests) { spent_ += tests; }

    /// The number of node pairs that will have to be modelled and answered.
    void reserve(std::uint64_t node_pairs);

    /// Where what detection finds is stored first (Organisation::stored): keeps half of what is
    /// left for what follows, at least the cost of so many node pairs, and reserves nothing else.
    void divide(std::uint64_t node_pairs);
    /// Ends that. Returns how many node pairs can be modelled and answered.
    [[nodiscard]] std::uint64_t join();
    /// That so many node pairs were allowed, and that it was not enough for all that was found.
    void answer_only(std::uint64_t node_pairs);

    /// How many of the pairs that meet at level 0 (`all.to_touch`) may be taken to their entry
    /// levels; the others touch as their root balls do. All, but on a clock that reserves what
    /// follows.
    [[nodiscard]] std::uint64_t entries(const Aftermath& all);
    /// Whether anything beyond the roots may be left out (entries, stops_contacts, goes_on).
    [[nodiscard]] bool governs_entries() const {
        return until_ ? until_->entered.has_value() : deadline_ && deadline_->pair_cost() > 0;
    }
    /// Whether deeper levels than the entry ones may be begun.
    [[nodiscard]] bool goes_deeper() const { return !entered_; }
    /// Says that the entry levels of so many pairs are done.
    void entries_done(std::uint64_t pairs);

    /// The contacts of so many candidate pairs may be modelled, from the first on; those of all
    /// behind them are those of root balls.
    [[nodiscard]] std::uint64_t most_modelled() const {
        return until_ ? until_->modelled.value_or(no_limit) : no_limit;
    }
    /// Whether a clock may end that before.
    [[nodiscard]] bool governs_contacts() const { return !until_ && governs_entries(); }
    /// Whether it does: what must follow does not fit any more. Looks at the clock; several threads
    /// may. Requires: governs_contacts().
    [[nodiscard]] bool is_late(const Aftermath& after) const { return deadline_->is_late(after); }
    /// Says from which pair on they were not, where not all were; and what is to be answered.
    void contacts_done(std::optional<std::uint64_t> modelled, const Aftermath& all);
    /// Whether a response that has done so many rounds, asking `before` pairs in the last one, may
    /// ask so many again.
    [[nodiscard]] bool goes_on(std::int32_t rounds, std::uint64_t pairs, std::uint64_t before);
    /// Says that the response is done: what follows is measured.
    void response_done();

    /// On a clock: begins to measure how long node tests take, which are expected to take what
    /// earlier frames measured; and what follows the levels, of which the reserve is made.
    void expect(const Pace& pace);
    /// Says that the levels are done: what follows is measured.
    void levels_done();
    /// What the next frame on this clock should expect; nothing without a clock.
    [[nodiscard]] std::optional<Pace> next_pace() const;

    /// Node tests done so far.
    [[nodiscard]] std::uint64_t spent() const { return spent_; }
    /// Node tests left beside what is reserved; nothing where they are not counted.
    [[nodiscard]] std::optional<std::uint64_t> tests_left() const;
    /// Time until the deadline, negative after it; nothing without one. Reads the clock.
    [[nodiscard]] std::optional<std::chrono::nanoseconds> time_left() const;
    /// The same when the levels were done, with what was kept of it; nothing without a clock.
    [[nodiscard]] std::optional<AfterLevels> after_levels() const;
    /// Whether it was made by unlimited().
    [[nodiscard]] bool is_unlimited() const { return !deadline_ && !counted_ && !until_; }
    /// Whether it has refused something.
    [[nodiscard]] bool refused() const { return refused_ || ended_; }
    /// Whether it refuses everything from now on.
    [[nodiscard]] bool ended() const { return ended_; }
    /// Where it ended the frame; nothing where it refused nothing.
    [[nodiscard]] std::optional<Cut> cut() const;

    /// On a clock a level counts as so many node tests more: taking it from the heap, carrying its
    /// nodes, sorting its front.
    static constexpr std::uint64_t tests_of_a_level = 32;
    /// While levels are left out, a clock is looked at once in so many of them.
    static constexpr std::uint64_t skips_unread = 8;

  private:
    [[nodiscard]] bool fits_count(std::uint64_t tests);
    [[nodiscard]] bool fits_time(std::uint64_t tests, std::uint64_t asked);
    void count(const Counted& counted);
    bool end();
    [[nodiscard]] Work work(std::uint64_t more_pairs = 0) const;
    [[nodiscard]] std::uint64_t used() const;
    [[nodiscard]] std::uint64_t count_left(std::uint64_t more_pairs = 0) const;
    [[nodiscard]] std::uint64_t test_limit(std::uint64_t node_pairs) const;
    [[nodiscard]] bool is_at_cut() const;

    static constexpr std::uint64_t no_limit = (std::numeric_limits<std::uint64_t>::max)();

    std::optional<Deadline> deadline_;
    std::optional<Counted> counted_;    ///< in force
    std::optional<Counted> undivided_;  ///< while divided
    std::optional<std::uint64_t> answered_;
    std::optional<std::uint64_t> entered_;
    std::optional<std::uint64_t> modelled_;
    std::optional<std::int32_t> rounds_;
    std::optional<Cut> until_;
    std::uint64_t node_pairs_ = 0;
    std::uint64_t limit_ = no_limit;  ///< of tests: the quota less what the node pairs reserve
    std::uint64_t spent_ = 0;
    std::uint64_t asked_ = 0;         ///< levels
    std::uint64_t begun_ = 0;         ///< of them
    std::uint64_t begun_before_ = 0;  ///< of these: before counting began
    std::uint64_t skips_ = 0;
    Cut at_;                          ///< pair and level in the making
    std::uint64_t spent_before_ = 0;  ///< them
    bool divided_ = false;
    bool refused_ = false;
    bool ended_ = false;
};

}  // namespace lod
