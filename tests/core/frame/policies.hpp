#pragma once

#include <array>

#include "lodlab/core/frame/schedule/policy.hpp"

namespace lodtest {

/// Every policy of the scheduler.
inline constexpr auto policies = lod::choices<lod::Priority>();

}  // namespace lodtest
