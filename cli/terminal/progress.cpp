#include "cli/terminal/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace cli {
namespace {

using namespace std::chrono_literals;
constexpr auto patience = 300ms;  // work that is shorter needs no bar
constexpr auto between_showings = 100ms;
constexpr std::size_t width = 30;

std::string time_left(double seconds) {
    const auto whole = static_cast<long>(std::ceil(seconds));
    if (whole < 60) return std::to_string(whole) + " s";
    return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

}  // namespace

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)),
      on_terminal_(::isatty(STDERR_FILENO) == 1),
      begin_(std::chrono::steady_clock::now()),
      shown_(begin_) {}

ProgressBar::~ProgressBar() {
    if (drawn_) std::cerr << "\r\033[K" << std::flush;
}

void ProgressBar::show(double share) {
    if (!on_terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - begin_ < patience || now - shown_ < between_showings) return;
    shown_ = now;
    drawn_ = true;
    const double part = std::clamp(share, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(part * static_cast<double>(width));
    const std::chrono::duration<double> spent = now - begin_;
    std::cerr << "\r\033[K" << label_ << " [" << std::string(filled, '#')
              << std::string(width - filled, ' ') << "] " << static_cast<int>(100 * part) << " %";
    if (part > 0) std::cerr << ", " << time_left(spent.count() * (1 - part) / part) << " left";
    std::cerr << std::flush;
}

}  // namespace cli
