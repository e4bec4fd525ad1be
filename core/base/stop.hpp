#pragma once

/// \file
/// How a program asks long work to end: it sets stop_requested, and the work throws Interrupted.

#include <atomic>
#include <stdexcept>

namespace lod {

/// Thrown by check_interrupted().
class Interrupted : public std::runtime_error {
  public:
    Interrupted();
};

/// Whether all work is asked to end soon; who asks (a signal, a window, another thread) is the
/// program's affair. Free of locks, so that a signal handler may set it. Stays set until cleared.
extern std::atomic<bool> stop_requested;
static_assert(std::atomic<bool>::is_always_lock_free);

/// Throws Interrupted when stop_requested is set. Long loops call it once a round.
void check_interrupted();

}  // namespace lod
