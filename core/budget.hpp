#pragma once

#include <chrono>
#include <cstdint>
#include <limits>

namespace lod {

/// Where a deadline reads the time. Injected, so that a test owns the clock.
class Clock {
  public:
    virtual ~Clock() = default;
    [[nodiscard]] virtual std::chrono::nanoseconds now() const = 0;
};

/// std::chrono::steady_clock.
class SteadyClock final : public Clock {
  public:
    [[nodiscard]] std::chrono::nanoseconds now() const override;
};

/// What a frame may spend on collision handling (section 5.1): a number of node tests, which is
/// exactly repeatable, or a time on a clock. The time of the response is reserved: refinement stops
/// when `spent + reserved contacts x cost of one contact >= quota`, and a level whose contacts the
/// rest of the quota could not resolve is not kept.
class Budget {
  public:
    static Budget unlimited();
    /// A contact's cost is in node tests.
    static Budget node_tests(std::uint64_t quota, double contact_cost = 0);
    /// The quota counts from now on. The clock must outlive the budget.
    static Budget deadline(const Clock& clock, std::chrono::nanoseconds quota,
                           std::chrono::nanoseconds contact_cost = {});

    /// Asks for `wanted` node tests and returns how many may be done. Fewer than wanted means that
    /// the budget ended there; from then on it grants nothing. `more_contacts` are those that the
    /// level in the making has found beyond the reserved ones.
    [[nodiscard]] std::uint64_t grant(std::uint64_t wanted, std::uint64_t more_contacts = 0);

    /// Whether the response to `more_contacts` beyond the reserved ones can be paid as well. If
    /// not, the budget ended: the level that brought them must be dropped. Its last test then does
    /// not count as spent, so that a quota of spent() node tests ends within the same level.
    [[nodiscard]] bool keeps_level(std::uint64_t more_contacts);

    /// Node tests that are done whatever the budget says: level 0 of every pair, the method's one
    /// requirement. They count as spent.
    void spend(std::uint64_t tests) { spent_ += tests; }

    /// The number of contacts that the response will have to resolve.
    void reserve_contacts(std::uint64_t contacts);

    [[nodiscard]] std::uint64_t spent() const { return spent_; }
    [[nodiscard]] bool ended() const { return ended_; }

  private:
    [[nodiscard]] std::uint64_t tests_left(std::uint64_t more_contacts);
    [[nodiscard]] std::uint64_t test_limit(std::uint64_t contacts) const;
    [[nodiscard]] bool past_deadline(std::uint64_t contacts) const;

    static constexpr std::uint64_t no_limit = (std::numeric_limits<std::uint64_t>::max)();
    /// A clock is read once in so many tests: reading it costs about as much as ten tests.
    static constexpr std::uint64_t tests_between_readings = 64;

    const Clock* clock_ = nullptr;
    std::chrono::nanoseconds deadline_{};
    std::uint64_t quota_ = no_limit;
    double contact_cost_ = 0;  ///< node tests, or nanoseconds when there is a clock
    std::uint64_t contacts_ = 0;
    std::uint64_t limit_ = no_limit;  ///< of spent_: the quota less what the contacts reserve
    std::uint64_t spent_ = 0;
    std::uint64_t next_reading_ = 0;
    bool ended_ = false;
};

}  // namespace lod
