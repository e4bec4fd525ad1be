#include "lodlab/viz/draw/motion/quota_use.hpp"

#include <algorithm>

namespace viz {
namespace {

double milliseconds(std::chrono::nanoseconds time) {
    return 1e-6 * static_cast<double>(time.count());
}

/// Fills in what is left of a quota. `kept`: for what followed the levels.
QuotaUse divided(double quota, double levels, double response, double kept) {
    QuotaUse use{quota, levels, response, 0, 0, std::max(0.0, levels + response - quota)};
    const double left = std::max(0.0, quota - levels - response);
    use.reserve = std::clamp(kept - response, 0.0, left);
    use.unused = left - use.reserve;
    return use;
}

}  // namespace

template <int Dim>
std::optional<QuotaUse> use_of(const lod::FrameRecord<Dim>& record, const Quota& quota) {
    const lod::Spending& spending = record.spending;
    if (quota.milliseconds) {
        if (!spending.time_left || !spending.after_levels) return std::nullopt;
        const double left = milliseconds(spending.after_levels->left);
        return divided(*quota.milliseconds, *quota.milliseconds - left,
                       left - milliseconds(*spending.time_left),
                       milliseconds(spending.after_levels->reserved));
    }
    if (!quota.node_tests) return std::nullopt;
    const auto all = static_cast<double>(*quota.node_tests);
    const auto tests = static_cast<double>(record.tests);
    // What is neither spent nor left is kept.
    const double left = static_cast<double>(spending.tests_left.value_or(0));
    return divided(all, tests, 0, spending.tests_left ? all - tests - left : 0);
}

template std::optional<QuotaUse> use_of(const lod::FrameRecord<2>&, const Quota&);
template std::optional<QuotaUse> use_of(const lod::FrameRecord<3>&, const Quota&);

}  // namespace viz
