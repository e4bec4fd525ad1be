#include "lodlab/core/tree/budget.hpp"

#include <algorithm>
#include <cmath>

namespace lod {

std::chrono::nanoseconds SteadyClock::now() const {
    return std::chrono::steady_clock::now().time_since_epoch();
}

Budget Budget::unlimited() {
    return {};
}

Budget Budget::node_tests(std::uint64_t quota, double pair_cost) {
    Budget budget;
    budget.quota_ = quota;
    budget.pair_cost_ = pair_cost;
    budget.reserve(0);
    return budget;
}

Budget Budget::deadline(const Clock& clock, std::chrono::nanoseconds quota,
                        std::chrono::nanoseconds pair_cost) {
    Budget budget;
    budget.clock_ = &clock;
    budget.deadline_ = clock.now() + quota;
    budget.pair_cost_ = static_cast<double>(pair_cost.count());
    return budget;
}

Budget Budget::until(const Cut& cut) {
    Budget budget;
    budget.until_ = cut;
    return budget;
}

void Budget::begin(std::int32_t pair, std::int32_t level) {
    at_ = {pair, level, 0};
    spent_before_ = spent_;
}

std::optional<Cut> Budget::cut() const {
    if (!ended_) return std::nullopt;
    return Cut{at_.pair, at_.level, spent_ - spent_before_};
}

bool Budget::is_at_cut() const {
    return until_ && until_->pair == at_.pair && until_->level == at_.level;
}

std::uint64_t Budget::grant(std::uint64_t wanted, std::uint64_t more_pairs) {
    if (ended_) return 0;
    const std::uint64_t granted = std::min(wanted, tests_left(more_pairs));
    if (granted < wanted) ended_ = true;
    spent_ += granted;
    return granted;
}

bool Budget::keeps_level(std::uint64_t more_pairs) {
    if (ended_) return false;
    if (is_at_cut())
        ended_ = true;
    else if (more_pairs > 0 && pair_cost_ > 0)
        ended_ = clock_ != nullptr ? past_deadline(node_pairs_ + more_pairs)
                                   : spent_ > test_limit(node_pairs_ + more_pairs);
    return !ended_;
}

void Budget::reserve(std::uint64_t node_pairs) {
    node_pairs_ = node_pairs;
    limit_ = test_limit(node_pairs);
}

std::uint64_t Budget::test_limit(std::uint64_t node_pairs) const {
    if (pair_cost_ == 0) return quota_;
    const double reserved = std::ceil(static_cast<double>(node_pairs) * pair_cost_);
    if (!(reserved < static_cast<double>(quota_))) return 0;
    return quota_ - static_cast<std::uint64_t>(reserved);
}

std::uint64_t Budget::tests_left(std::uint64_t more_pairs) {
    if (clock_ != nullptr) {
        if (spent_ < next_reading_) return no_limit;
        next_reading_ = spent_ + tests_between_readings;
        return past_deadline(node_pairs_ + more_pairs) ? 0 : no_limit;
    }
    if (is_at_cut()) return until_->tests - std::min(until_->tests, spent_ - spent_before_);
    const std::uint64_t limit =
        more_pairs == 0 || pair_cost_ == 0 ? limit_ : test_limit(node_pairs_ + more_pairs);
    return limit > spent_ ? limit - spent_ : 0;
}

bool Budget::past_deadline(std::uint64_t node_pairs) const {
    const auto reserved = std::chrono::nanoseconds(
        static_cast<std::int64_t>(static_cast<double>(node_pairs) * pair_cost_));
    return clock_->now() + reserved >= deadline_;
}

}  // namespace lod
