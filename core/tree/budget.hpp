#pragma once

/// \file
/// What a frame may spend, as node tests or as time; and where it was cut, so that it can be played
/// again.

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>

namespace lod {

/// Where a deadline reads the time. Injected, so that a test owns the clock.
class Clock {
  public:
    virtual ~Clock() = default;
    /// Time since any one moment; never decreasing.
    [[nodiscard]] virtual std::chrono::nanoseconds now() const = 0;
};

/// std::chrono::steady_clock.
class SteadyClock final : public Clock {
  public:
    /// Time since any one moment; never decreasing.
    [[nodiscard]] std::chrono::nanoseconds now() const override;
};

/// Where a budget ended a frame: all that it takes to play the frame again.
struct Cut {
    std::int32_t pair = 0;    ///< number of the candidate pair that was refined
    std::int32_t level = 0;   ///< in the making; one beyond the leaves for the true shapes
    std::uint64_t tests = 0;  ///< node tests of that level, all lost
    friend bool operator==(const Cut&, const Cut&) = default;
};

/// What a frame may spend on collision handling (section 5.1): a number of node tests, which is
/// exactly repeatable, or a time on a clock. The cost of what follows is reserved: refinement stops
/// when `spent + reserved node pairs x cost of one >= quota`, and a level whose node pairs the rest
/// of the quota could not pay for is not kept.
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

    /// Asks for `wanted` node tests and returns how many may be done. Fewer than wanted means that
    /// the budget ended there; from then on it grants nothing. `more_pairs` are the node pairs that
    /// the level in the making has found beyond the reserved ones.
    [[nodiscard]] std::uint64_t grant(std::uint64_t wanted, std::uint64_t more_pairs = 0);

    /// Whether what follows from `more_pairs` beyond the reserved ones can be paid as well. If not,
    /// the budget ended: the level that brought them must be dropped.
    [[nodiscard]] bool keeps_level(std::uint64_t more_pairs);

    /// Node tests that are done whatever the budget says: the entry level of every pair, the
    /// method's one requirement. They count as spent.
    void spend(std::uint64_t tests) { spent_ += tests; }

    /// The number of node pairs that will have to be modelled and answered.
    void reserve(std::uint64_t node_pairs);

    /// Node tests done so far.
    [[nodiscard]] std::uint64_t spent() const { return spent_; }
    /// Whether it was made by unlimited().
    [[nodiscard]] bool is_unlimited() const {
        return clock_ == nullptr && quota_ == no_limit && !until_;
    }
    /// Whether it has refused something.
    [[nodiscard]] bool ended() const { return ended_; }
    /// Where it ended; nothing where it did not.
    [[nodiscard]] std::optional<Cut> cut() const;

  private:
    [[nodiscard]] std::uint64_t tests_left(std::uint64_t more_pairs);
    [[nodiscard]] std::uint64_t test_limit(std::uint64_t node_pairs) const;
    [[nodiscard]] bool past_deadline(std::uint64_t node_pairs) const;
    [[nodiscard]] bool is_at_cut() const;

    static constexpr std::uint64_t no_limit = (std::numeric_limits<std::uint64_t>::max)();
    /// A clock is read once in so many tests: reading it costs about as much as ten tests.
    static constexpr std::uint64_t tests_between_readings = 64;

    const Clock* clock_ = nullptr;
    std::chrono::nanoseconds deadline_{};
    std::optional<Cut> until_;
    std::uint64_t quota_ = no_limit;
    double pair_cost_ = 0;  ///< node tests, or nanoseconds when there is a clock
    std::uint64_t node_pairs_ = 0;
    std::uint64_t limit_ = no_limit;  ///< of spent_: the quota less what the node pairs reserve
    std::uint64_t spent_ = 0;
    std::uint64_t next_reading_ = 0;
    Cut at_;                          ///< pair and level in the making
    std::uint64_t spent_before_ = 0;  ///< them
    bool ended_ = false;
};

}  // namespace lod
