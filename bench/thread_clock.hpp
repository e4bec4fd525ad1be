#pragma once

#include <sys/resource.h>

#include "lodlab/scenes/threads/thread_clock.hpp"

namespace bench {

using ThreadClock = scenes::ThreadClock;

/// How often the operating system has taken the processor from this thread.
inline long preemptions() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_nivcsw;
}

}  // namespace bench
