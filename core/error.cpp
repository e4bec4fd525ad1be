#include "lodlab/core/error.hpp"

namespace lod {

std::atomic<int> stop_signal{0};

void refuse_input(const std::string& name, const std::string& why) {
    throw Error(ErrorKind::input_refused, name + ": " + why);
}

void check_interrupted() {
    if (const int signal = stop_signal.load(std::memory_order_relaxed)) throw Interrupted(signal);
}

}  // namespace lod
