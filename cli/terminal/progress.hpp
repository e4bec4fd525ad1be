#pragma once

#include <chrono>
#include <string>

namespace cli {

/// A bar on standard error with the time left: only on a terminal, and only for work that takes
/// longer than a moment. Erases itself.
class ProgressBar {
  public:
    explicit ProgressBar(std::string label);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Share of the work that is done, 0 to 1. The time left follows from the pace so far.
    void show(double share);

  private:
    std::string label_;
    bool on_terminal_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point begin_;
    std::chrono::steady_clock::time_point shown_;
};

}  // namespace cli
