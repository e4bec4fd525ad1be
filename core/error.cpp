#include "lodlab/core/error.hpp"

#include <algorithm>
#include <utility>

namespace lod {

std::atomic<int> stop_signal{0};

namespace {

std::string without_controls(std::string line) {
    std::ranges::replace_if(
        line, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, ' ');
    return line;
}

}  // namespace

Error::Error(ErrorKind kind, std::string line)
    : std::runtime_error(without_controls(std::move(line))), kind_(kind) {}

void refuse_input(const std::string& name, const std::string& why) {
    throw Error(ErrorKind::input_refused, name + ": " + why);
}

void check_interrupted() {
    if (const int signal = stop_signal.load(std::memory_order_relaxed)) throw Interrupted(signal);
}

}  // namespace lod
