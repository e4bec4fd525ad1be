#include "lodlab/core/base/stop.hpp"

namespace lod {

std::atomic<bool> stop_requested{false};

Interrupted::Interrupted() : std::runtime_error("interrupted") {}

void check_interrupted() {
    if (stop_requested.load(std::memory_order_relaxed)) throw Interrupted();
}

}  // namespace lod
