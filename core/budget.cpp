#include "lodlab/core/budget.hpp"

#include <algorithm>
#include <cmath>

namespace lod {

std::chrono::nanoseconds SteadyClock::now() const {
    return std::chrono::steady_clock::now().time_since_epoch();
}

Budget Budget::unlimited() {
    return {};
}

Budget Budget::node_tests(std::uint64_t quota, double contact_cost) {
    Budget budget;
    budget.quota_ = quota;
    budget.contact_cost_ = contact_cost;
    budget.reserve_contacts(0);
    return budget;
}

Budget Budget::deadline(const Clock& clock, std::chrono::nanoseconds quota,
                        std::chrono::nanoseconds contact_cost) {
    Budget budget;
    budget.clock_ = &clock;
    budget.deadline_ = clock.now() + quota;
    budget.contact_cost_ = static_cast<double>(contact_cost.count());
    return budget;
}

std::uint64_t Budget::grant(std::uint64_t wanted, std::uint64_t more_contacts) {
    if (ended_) return 0;
    const std::uint64_t granted = std::min(wanted, tests_left(more_contacts));
    if (granted < wanted) ended_ = true;
    spent_ += granted;
    return granted;
}

bool Budget::keeps_level(std::uint64_t more_contacts) {
    if (more_contacts == 0 || contact_cost_ == 0 || ended_) return !ended_;
    const bool fits = clock_ ? !past_deadline(contacts_ + more_contacts)
                             : spent_ <= test_limit(contacts_ + more_contacts);
    if (fits) return true;
    ended_ = true;
    if (spent_ > 0) --spent_;
    return false;
}

void Budget::reserve_contacts(std::uint64_t contacts) {
    contacts_ = contacts;
    limit_ = test_limit(contacts);
}

std::uint64_t Budget::test_limit(std::uint64_t contacts) const {
    if (contact_cost_ == 0) return quota_;
    const double reserved = std::ceil(static_cast<double>(contacts) * contact_cost_);
    if (!(reserved < static_cast<double>(quota_))) return 0;
    return quota_ - static_cast<std::uint64_t>(reserved);
}

std::uint64_t Budget::tests_left(std::uint64_t more_contacts) {
    if (clock_) {
        if (spent_ < next_reading_) return no_limit;
        next_reading_ = spent_ + tests_between_readings;
        return past_deadline(contacts_ + more_contacts) ? 0 : no_limit;
    }
    const std::uint64_t limit =
        more_contacts == 0 || contact_cost_ == 0 ? limit_ : test_limit(contacts_ + more_contacts);
    return limit > spent_ ? limit - spent_ : 0;
}

bool Budget::past_deadline(std::uint64_t contacts) const {
    const auto reserved = std::chrono::nanoseconds(
        static_cast<std::int64_t>(static_cast<double>(contacts) * contact_cost_));
    return clock_->now() + reserved >= deadline_;
}

}  // namespace lod
