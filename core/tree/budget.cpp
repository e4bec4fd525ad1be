#include "lodlab/core/tree/budget.hpp"

#include <algorithm>
#include <cmath>

namespace lod {

Budget Budget::unlimited() {
    return {};
}

Budget Budget::node_tests(std::uint64_t quota, double pair_cost) {
    Budget budget;
    budget.count({0, quota, pair_cost, 0});
    return budget;
}

Budget Budget::deadline(const Clock& clock, std::chrono::nanoseconds quota,
                        std::chrono::nanoseconds pair_cost) {
    Budget budget;
    budget.deadline_.emplace(clock, quota, pair_cost);
    return budget;
}

Budget Budget::until(const Cut& cut) {
    Budget budget;
    budget.until_ = cut;
    if (cut.counted && cut.counted->from == 0) budget.count(*cut.counted);
    return budget;
}

void Budget::begin(std::int32_t pair, std::int32_t level) {
    at_ = {pair, level, 0, {}, {}};
    spent_before_ = spent_;
}

std::optional<Cut> Budget::cut() const {
    if (!refused()) return std::nullopt;
    Cut cut;
    if (ended_) cut = {at_.pair, at_.level, spent_ - spent_before_};
    cut.counted = counted_;
    cut.answered = answered_;
    cut.entered = entered_;
    cut.modelled = modelled_;
    cut.rounds = rounds_;
    return cut;
}

bool Budget::fits(std::uint64_t tests) {
    if (ended_) return false;
    const std::uint64_t asked = asked_++;
    if (until_ && until_->counted && until_->counted->from == asked) count(*until_->counted);
    if (is_at_cut()) return true;  // until its last test
    if (!(counted_ ? fits_count(tests) : fits_time(tests, asked))) return false;
    ++begun_;
    return true;
}

/// On a clock; from the first level that does not fit, by counting.
bool Budget::fits_time(std::uint64_t tests, std::uint64_t asked) {
    if (!deadline_ || deadline_->fits(tests + tests_of_a_level, work())) return true;
    if (deadline_->passed(work())) return end();
    count({asked, spent_ + static_cast<std::uint64_t>(deadline_->tests_left()),
           deadline_->pair_cost(), tests_of_a_level});
    return fits_count(tests);
}

bool Budget::fits_count(std::uint64_t tests) {
    const std::uint64_t left = count_left();
    if (counted_->level_cost <= left && tests <= left - counted_->level_cost) return true;
    refused_ = true;
    if (deadline_ && ++skips_ % skips_unread == 0 && deadline_->left().count() <= 0) return end();
    return false;
}

bool Budget::fits_any(std::uint64_t tests) {
    if (ended_) return false;
    if (!counted_ || tests + counted_->level_cost <= count_left()) return true;
    refused_ = true;
    return false;
}

void Budget::count(const Counted& counted) {
    counted_ = counted;
    begun_before_ = begun_;
    limit_ = test_limit(node_pairs_);
}

/// Refuses everything from now on.
bool Budget::end() {
    ended_ = true;
    return false;
}

std::uint64_t Budget::grant(std::uint64_t wanted, std::uint64_t more_pairs) {
    if (ended_) return 0;
    std::uint64_t left = no_limit;
    if (is_at_cut()) {
        left = until_->tests - std::min(until_->tests, spent_ - spent_before_);
        ended_ = left < wanted;
    } else if (deadline_ && deadline_->passed(work(more_pairs))) {
        left = 0;
        ended_ = true;
    } else if (counted_) {
        left = count_left(more_pairs);
    }
    const std::uint64_t granted = std::min(wanted, left);
    if (granted < wanted) refused_ = true;
    spent_ += granted;
    return granted;
}

bool Budget::keeps_level(std::uint64_t more_pairs) {
    if (ended_) return false;
    if (is_at_cut()) return end();
    if (more_pairs == 0) return true;
    if (deadline_ && deadline_->passed(work(more_pairs))) return end();
    if (!counted_ || counted_->pair_cost == 0) return true;
    const bool kept = used() <= test_limit(node_pairs_ + more_pairs);
    if (!kept) refused_ = true;
    return kept;
}

void Budget::reserve(std::uint64_t node_pairs) {
    node_pairs_ = node_pairs;
    if (counted_) limit_ = test_limit(node_pairs);
}

void Budget::divide(std::uint64_t node_pairs) {
    if (deadline_ && deadline_->pair_cost() > 0) {
        divided_ = true;
        deadline_->divide(node_pairs);
    } else if (!until_ && counted_ && counted_->pair_cost != 0) {
        divided_ = true;
        undivided_ = counted_;
        reserve(node_pairs);
        const std::uint64_t left = counted_->quota - std::min(counted_->quota, used());
        count({0, used() + std::min(count_left(), left / 2), 0, counted_->level_cost});
    }
}

std::uint64_t Budget::join() {
    if (until_) return until_->answered.value_or(no_limit);
    if (!divided_) return no_limit;
    divided_ = false;
    if (deadline_) return deadline_->join(work());
    const double left =
        static_cast<double>(undivided_->quota - std::min(undivided_->quota, used()));
    return static_cast<std::uint64_t>(left / undivided_->pair_cost);
}

void Budget::answer_only(std::uint64_t node_pairs) {
    answered_ = node_pairs;
    refused_ = true;
}

std::uint64_t Budget::entries(const Aftermath& all) {
    if (!governs_entries()) return all.to_touch;
    const std::uint64_t most =
        (std::min)(all.to_touch, until_ ? *until_->entered : deadline_->entries(all));
    if (!until_ && most == all.to_touch && !deadline_->is_spent_by(most, all)) return most;
    entered_ = most;
    count({});
    refused_ = true;
    return most;
}

void Budget::entries_done(std::uint64_t pairs) {
    if (deadline_) deadline_->entered(pairs);
}

void Budget::contacts_done(std::optional<std::uint64_t> modelled, const Aftermath& all) {
    modelled_ = modelled;
    if (modelled) refused_ = true;
    if (deadline_) deadline_->contacts_done(all);
}

bool Budget::goes_on(std::int32_t rounds, std::uint64_t pairs, std::uint64_t before) {
    const bool more = until_ ? !until_->rounds || rounds < *until_->rounds
                             : !governs_entries() || deadline_->goes_on(pairs, before);
    if (more) return true;
    rounds_ = rounds;
    refused_ = true;
    return false;
}

void Budget::response_done() {
    if (deadline_) deadline_->response_done(modelled_.has_value(), rounds_.has_value());
}

void Budget::expect(const Pace& pace) {
    if (deadline_) deadline_->expect(pace, work());
}

void Budget::levels_done() {
    if (deadline_) deadline_->levels_done(work());
}

std::optional<Pace> Budget::next_pace() const {
    return deadline_ ? std::optional(deadline_->next_pace()) : std::nullopt;
}

std::optional<std::uint64_t> Budget::tests_left() const {
    return counted_ ? std::optional(count_left()) : std::nullopt;
}

std::optional<std::chrono::nanoseconds> Budget::time_left() const {
    return deadline_ ? std::optional(deadline_->left()) : std::nullopt;
}

std::optional<AfterLevels> Budget::after_levels() const {
    return deadline_ ? std::optional(deadline_->after_levels()) : std::nullopt;
}

Work Budget::work(std::uint64_t more_pairs) const {
    return {spent_ + begun_ * tests_of_a_level, node_pairs_ + more_pairs};
}

/// Node tests that count against the quota.
std::uint64_t Budget::used() const {
    return spent_ + (begun_ - begun_before_) * counted_->level_cost;
}

std::uint64_t Budget::count_left(std::uint64_t more_pairs) const {
    const std::uint64_t limit = more_pairs == 0 ? limit_ : test_limit(node_pairs_ + more_pairs);
    return limit - std::min(limit, used());
}

/// The quota less what so many node pairs reserve.
std::uint64_t Budget::test_limit(std::uint64_t node_pairs) const {
    if (counted_->pair_cost == 0) return counted_->quota;
    const double reserved = std::ceil(static_cast<double>(node_pairs) * counted_->pair_cost);
    if (!(reserved < static_cast<double>(counted_->quota))) return 0;
    return counted_->quota - static_cast<std::uint64_t>(reserved);
}

bool Budget::is_at_cut() const {
    return until_ && until_->pair >= 0 && until_->pair == at_.pair && until_->level == at_.level;
}

}  // namespace lod
