#include "core/budget.hpp"

#include <algorithm>
#include <cmath>

namespace lod {

std::chrono::nanoseconds SteadyClock::now() const {
    return std::chrono::steady_clock::now().time_since_epoch();
}

Budget Budget::unlimited() { return {}; }

Budget Budget::node_tests(std::uint64_t quota, double contact_cost) {
    Budget budget;
    budget.quota_ = quota;
    budget.contact_cost_ = contact_cost;
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

std::uint64_t Budget::grant(std::uint64_t wanted) {
    if (ended_) return 0;
    const std::uint64_t granted = std::min(wanted, tests_left());
    if (granted < wanted) ended_ = true;
    spent_ += granted;
    return granted;
}

std::uint64_t Budget::tests_left() {
    if (clock_) {
        if (spent_ < next_reading_) return no_limit;
        next_reading_ = spent_ + tests_between_readings;
        return past_deadline() ? 0 : no_limit;
    }
    if (quota_ == no_limit) return no_limit;
    const double reserved = std::ceil(static_cast<double>(contacts_) * contact_cost_);
    const double left = static_cast<double>(quota_) - static_cast<double>(spent_) - reserved;
    return left > 0 ? static_cast<std::uint64_t>(left) : 0;
}

bool Budget::past_deadline() const {
    const auto reserved = std::chrono::nanoseconds(
        static_cast<std::int64_t>(static_cast<double>(contacts_) * contact_cost_));
    return clock_->now() + reserved >= deadline_;
}

}  // namespace lod
