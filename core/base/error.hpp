#pragma once

#include <atomic>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lod {

/// Why something could not be done; the program's exit code.
enum class ErrorKind {
    usage = 2,
    input_refused = 3,
    output_failed = 4,
    limit_exceeded = 5,
    not_installed = 6,
};

/// The one exception of lodlab. what() is one line: what, where, why, and the mend. Whatever a file
/// brings into it, line ends and other control characters are blanks there.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, std::string line);
    [[nodiscard]] ErrorKind kind() const { return kind_; }

  private:
    ErrorKind kind_;
};

/// Throws Error, input refused: "name: why".
[[noreturn]] void refuse_input(const std::string& name, const std::string& why);

/// Throws Error, usage: no WHAT is called NAME; choose one of these.
[[noreturn]] void refuse_choice(std::string_view what, std::string_view name,
                                std::span<const std::string_view> names);

/// Thrown by check_interrupted() when a signal asked the program to stop.
class Interrupted : public std::runtime_error {
  public:
    explicit Interrupted(int signal) : std::runtime_error("interrupted"), signal_(signal) {}
    [[nodiscard]] int signal() const { return signal_; }

  private:
    int signal_;
};

/// Set by a signal handler (async-signal-safe); 0 while nothing asked to stop.
extern std::atomic<int> stop_signal;

/// Throws Interrupted when stop_signal is set. Long loops call it once a round.
void check_interrupted();

}  // namespace lod
