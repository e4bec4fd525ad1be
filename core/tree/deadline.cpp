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

/// What takes longer counts at once, and less by a part.
double held(double measured, double expected, double part = 0.0625) {
    const double next = no_leap(measured, expected);
    return next > expected ? next : expected + part * (next - expected);
}

double share(std::chrono::nanoseconds time, double parts) {
    return static_cast<double>(time.count()) / (std::max)(1.0, parts);
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
    const std::chrono::nanoseconds now = clock_->now();
    if (measures_after_) learn_after(now, next);
    if (pairs_at_end_ < least_pairs_measured || !(pair_time_ > 0)) return next;
    next.pair = held(share(now - levels_end_, static_cast<double>(pairs_at_end_)), pair_time_);
    if (cut_after_) next.pair = (std::max)(next.pair, pair_time_);
    return next;
}

/// Of what follows the levels. What was cut says nothing of how long all of it takes.
void Deadline::learn_after(std::chrono::nanoseconds now, Pace& next) const {
    const auto bodies = static_cast<double>(after_.bodies);
    const auto contacts = static_cast<double>(after_.contacts);
    if (entered_ >= least_pairs_measured) {
        const double by_roots =
            bodies_of_a_touch * expected_.response * static_cast<double>(after_.to_touch);
        const auto taken = entry_time_ + (contacts_end_ - levels_end_) -
                           std::chrono::nanoseconds(static_cast<std::int64_t>(by_roots));
        const double entry = share(taken, static_cast<double>(entered_));
        next.entry += 0.25 * (no_leap(entry, expected_.entry) - expected_.entry);
    }
    if (after_.bodies < least_pairs_measured) return;
    next.motion = (std::max)(least_motion, held(share(now - response_end_, bodies), next.motion));
    // Its later rounds can be ended, so it need not be held for long.
    const double response =
        held(share(response_end_ - contacts_end_, bodies + bodies_of_a_contact * contacts),
             expected_.response, 0.25);
    next.response = (std::max)({least_response, response, rounds_cut_ ? expected_.response : 0.0});
}

double Deadline::time_of(const Aftermath& after) const {
    const auto bodies = static_cast<double>(after.bodies);
    const double of_contacts =
        bodies_of_a_contact * static_cast<double>(after.contacts) +
        (bodies_of_a_contact + bodies_of_a_touch) * static_cast<double>(after.to_touch);
    return margin *
           ((expected_.response + expected_.motion) * bodies + expected_.response * of_contacts);
}

std::uint64_t Deadline::entries(const Aftermath& all) {
    last_ = (std::max)(last_, clock_->now());
    entry_begin_ = last_;
    const auto pairs = static_cast<double>(all.to_touch);
    const double room = static_cast<double>((end_ - last_).count()) - time_of(all);
    if (room >= pairs * more_of_an_entry()) return all.to_touch;
    const double chosen = (room - pairs * to_wait) / more_of_an_entry();
    return chosen > 0.03125 * pairs ? static_cast<std::uint64_t>(chosen) : 0;
}

/// Beside what is reserved for it: half of the pairs are then told apart, and touch no more.
double Deadline::more_of_an_entry() const {
    const double touch = (bodies_of_a_contact + bodies_of_a_touch) * expected_.response;
    return (std::max)(0.25 * expected_.entry, expected_.entry - 0.5 * touch);
}

bool Deadline::is_spent_by(std::uint64_t entered, const Aftermath& all) const {
    const double room = static_cast<double>((end_ - last_).count()) - time_of(all) -
                        static_cast<double>(entered) * more_of_an_entry();
    return room < static_cast<double>(all.to_touch) * to_wait;
}

void Deadline::entered(std::uint64_t pairs) {
    entered_ = pairs;
    entry_time_ = clock_->now() - entry_begin_;
}

void Deadline::contacts_done(const Aftermath& all) {
    after_ = all;
    contacts_end_ = clock_->now();
    round_end_ = contacts_end_;
}

bool Deadline::goes_on(std::uint64_t pairs, std::uint64_t before) {
    const std::chrono::nanoseconds now = clock_->now();
    // Before the first round the rows are made, which takes about as long.
    const double round = share(now - round_end_, static_cast<double>(before)) *
                         (round_end_ == contacts_end_ ? 0.5 : 1.0) * static_cast<double>(pairs);
    round_end_ = now;
    const double motion = margin * expected_.motion * static_cast<double>(after_.bodies);
    return static_cast<double>((end_ - now).count()) >= margin * round + motion;
}

void Deadline::response_done(bool contacts_cut, bool rounds_cut) {
    response_end_ = clock_->now();
    cut_after_ = contacts_cut || rounds_cut;
    rounds_cut_ = rounds_cut;
    measures_after_ = true;
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
