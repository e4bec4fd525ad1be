#pragma once

/// \file
/// The one exception that lodlab throws, and its kinds.

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lod {

/// Why something could not be done. What a program makes of it (a message, an exit code) is the
/// program's affair.
enum class ErrorKind {
    usage,           ///< the call asks for what there is not
    input_refused,   ///< what was read is not what it should be
    output_failed,   ///< what was made could not be written
    limit_exceeded,  ///< it would take more than is granted
    not_installed,   ///< something of the machine is missing
};

/// The one exception of lodlab. what() is one line: what, where, why, and the mend. Whatever a file
/// brings into it, line ends and other control characters are blanks there.
class Error : public std::runtime_error {
  public:
    /// `line`: what what() gives back.
    Error(ErrorKind kind, std::string line);
    /// Why it was thrown.
    [[nodiscard]] ErrorKind kind() const { return kind_; }

  private:
    ErrorKind kind_;
};

/// Throws Error, input refused: "name: why".
[[noreturn]] void refuse_input(const std::string& name, const std::string& why);

/// Throws Error, usage: no WHAT is called NAME; choose one of these.
[[noreturn]] void refuse_choice(std::string_view what, std::string_view name,
                                std::span<const std::string_view> names);

}  // namespace lod
