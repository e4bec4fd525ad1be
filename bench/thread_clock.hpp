#pragma once

#include <sys/resource.h>

#include <chrono>
#include <ctime>

#include "lodlab/core/tree/budget.hpp"

namespace bench {

/// The processor time of this thread: what other processes take does not count.
class ThreadClock final : public lod::Clock {
  public:
    [[nodiscard]] std::chrono::nanoseconds now() const override {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
    }
};

/// How often the operating system has taken the processor from this thread.
inline long preemptions() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_nivcsw;
}

}  // namespace bench
