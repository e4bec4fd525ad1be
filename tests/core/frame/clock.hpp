#pragma once

#include <utility>

#include "lodlab/core/tree/budget.hpp"

namespace lodtest {

/// A clock that a test owns: it moves by `step` at each reading.
struct FakeClock final : lod::Clock {
    mutable std::chrono::nanoseconds time{};
    std::chrono::nanoseconds step{};
    mutable int readings = 0;

    std::chrono::nanoseconds now() const override {
        ++readings;
        return std::exchange(time, time + step);
    }
};

}  // namespace lodtest
