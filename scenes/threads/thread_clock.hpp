#pragma once

/// \file
/// A clock that other processes do not move.

#include <chrono>
#include <ctime>

#include "lodlab/core/tree/deadline.hpp"

namespace scenes {

/// The processor time of the calling thread: what others do meanwhile does not count.
class ThreadClock final : public lod::Clock {
  public:
    /// Since the thread began.
    [[nodiscard]] std::chrono::nanoseconds now() const override {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
    }
};

}  // namespace scenes
