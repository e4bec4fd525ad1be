#include "lodlab/core/tree/deadline.hpp"

#include <algorithm>
#include <utility>

namespace lod {
namespace {

/// The latest moment that there is, where the quota goes beyond it.
std::chrono::nanoseconds later(std::chrono::nanoseconds now, std::chrono::nanoseconds quota) {
    const auto last = (std::chrono::nanoseconds::max)();
    return now.count() > 0 && quota > last - now ? last : now + quota;
}

/// Within a factor of two of what was expected.
double no_leap(double measured, double expected) {
    return std::clamp(measured, 0.5 * expected, 2 * expected);
}

}  // namespace

std::chrono::nanoseconds SteadyClock::now() const {
    return std::chrono::steady_clock::now().time_since_epoch();
}

Deadline::Deadline(const Clock& clock, std::chrono::nanoseconds quota,
                   std::chrono::nanoseconds pair_time)
    : clock_(&clock),
      last_(clock.now()),
      pair_time_((std::max)(0.0, static_cast<double>(pair_time.count()))),
      from_(last_),
      levels_end_(last_) {
    end_ = later(last_, quota);
}

void Deadline::expect(const Pace& pace, const Work& done) {
    last_ = (std::max)(last_, clock_->now());
    from_ = last_;
    levels_end_ = last_;
    tests_from_ = done.tests;
    measured_ = 0;
    expected_ = pace;
    expected_.test = (std::max)(least_pace, pace.test);
    pace_ = expected_.test;
    if (pair_time_ > 0 && pace.pair > 0) pair_time_ = pace.pair;
}

void Deadline::levels_done(const Work& done) {
    read(done);
    levels_end_ = last_;
    pairs_at_end_ = done.node_pairs;
}

AfterLevels Deadline::after_levels() const {
    const double reserved = static_cast<double>(pairs_at_end_) * pair_time_;
    return {end_ - levels_end_, std::chrono::nanoseconds(static_cast<std::int64_t>(reserved))};
}

void Deadline::divide(std::uint64_t node_pairs) {
    const auto left = static_cast<double>(this->left().count());
    const double least = static_cast<double>(node_pairs) * pair_time_;
    // More than all that is left keeps no test either.
    const double kept = std::clamp((std::max)(0.5 * left, least), 0.0, (std::max)(0.0, left));
    kept_ = std::chrono::nanoseconds(static_cast<std::int64_t>(kept));
    end_ -= kept_;
    undivided_pair_time_ = std::exchange(pair_time_, 0.0);
    next_reading_ = 0;
}

std::uint64_t Deadline::join(const Work& done) {
    end_ += std::exchange(kept_, {});
    pair_time_ = undivided_pair_time_;
    read({done.tests, 0});
    const auto left = static_cast<double>((end_ - last_).count());
    return left > 0 ? static_cast<std::uint64_t>(left / pair_time_) : 0;
}

Pace Deadline::next_pace() const {
    Pace next = expected_;
    if (measured_ > 0) next.test += 0.25 * (no_leap(measured_, expected_.test) - expected_.test);
    if (pairs_at_end_ < least_pairs_measured || !(pair_time_ > 0)) return next;
    const auto taken = static_cast<double>((clock_->now() - levels_end_).count());
    const double pair = no_leap(taken / static_cast<double>(pairs_at_end_), pair_time_);
    next.pair = pair > pair_time_ ? pair : pair_time_ + 0.0625 * (pair - pair_time_);
    return next;
}

bool Deadline::fits(std::uint64_t tests, const Work& done) {
    if (is_far(done, tests)) return true;
    const double room = read(done);
    return room > 0 && static_cast<double>(tests) * pace_ <= room;
}

bool Deadline::passed(const Work& done) {
    return !is_far(done, 0) && !(read(done) > 0);
}

double Deadline::tests_left() const {
    return (std::max)(0.0, static_cast<double>((end_ - last_).count()) / pace_);
}

/// Looks at the clock and returns the time left beside the reserve [ns].
double Deadline::read(const Work& done) {
    last_ = (std::max)(last_, clock_->now());
    measure(done.tests);
    const double room = static_cast<double>((end_ - last_).count()) -
                        static_cast<double>(done.node_pairs) * pair_time_;
    next_reading_ = static_cast<double>(done.tests) +
                    std::clamp(0.25 * room / pace_, least_unread, most_unread);
    pairs_at_reading_ = done.node_pairs;
    return room;
}

/// The slower of what was expected and what is measured in this frame.
void Deadline::measure(std::uint64_t tests) {
    if (tests < tests_from_ + least_measured) return;
    measured_ = (std::max)(least_pace, static_cast<double>((last_ - from_).count()) /
                                           static_cast<double>(tests - tests_from_));
    pace_ = (std::max)(expected_.test, measured_);
}

bool Deadline::is_far(const Work& done, std::uint64_t tests) const {
    const double more = done.node_pairs > pairs_at_reading_
                            ? static_cast<double>(done.node_pairs - pairs_at_reading_)
                            : 0;
    return static_cast<double>(done.tests + tests) + more * pair_cost() < next_reading_;
}

}  // namespace lod
