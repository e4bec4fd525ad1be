#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

namespace lessons {

/// What a reader of a lesson can say, in words for her.
extern const std::string_view help_text;
extern const std::string_view answer_help;  ///< while a question is open

/// What the reader of a lesson asks for.
struct Command {
    enum class Kind { next, back, go, text, help, quit, pass, answer, unknown };
    Kind kind = Kind::unknown;
    int step = 0;       ///< of go
    std::string typed;  ///< of unknown, and of answer
};

/// What the reader says next: a key, a line, or in answer to a question a whole line. Nothing at
/// the end of the input. `keyboard`: a terminal for single keys; -1: lines come from the input.
[[nodiscard]] std::optional<Command> read_command(bool is_asking, std::istream& input,
                                                  std::ostream& output, int keyboard);

}  // namespace lessons
