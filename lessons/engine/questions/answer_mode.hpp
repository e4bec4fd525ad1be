#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "lessons/engine/lessons.hpp"

namespace lessons {

/// What became of the questions of a lesson.
struct Tally {
    int at_once = 0;  ///< right at the first try
    int later = 0;    ///< right after a mistake
    int passed = 0;
    int open = 0;
};

/// "3 right at the first try, 1 after a mistake, 2 passed, 1 open."
[[nodiscard]] std::string in_words(const Tally& tally);

/// Asks the questions of a lesson in a terminal and remembers what became of them.
class AnswerMode {
  public:
    AnswerMode(const Lesson& lesson, std::ostream& output, const StepperOptions& options);

    /// The first question of a step (1 and up) that is neither answered rightly nor passed.
    [[nodiscard]] const Question* open_in(int step) const;
    /// The first step from `from` on, before `to`, with an open question.
    [[nodiscard]] std::optional<int> blocked_between(int from, int to) const;

    /// Prints the question of a step, with its choices.
    void ask(int step);
    /// Grades what the reader typed to it, and prints the reply.
    void answer(int step, const std::string& typed);
    void pass(int step);

    [[nodiscard]] Tally tally() const;

  private:
    struct State {
        int mistakes = 0;
        bool right = false;
        bool passed = false;
    };
    [[nodiscard]] std::size_t first_open(int step) const;
    void say(const std::string& markdown, const std::string& indent = "");

    const Lesson& lesson_;
    std::ostream& output_;
    const StepperOptions& options_;
    std::vector<std::vector<State>> states_;  ///< of each step's questions
};

/// A line that a reader types on a terminal in the mode of single keys; shown as it is typed. Empty
/// at the end of the input.
[[nodiscard]] std::optional<std::string> read_line_from_keys(int terminal, std::ostream& output);

}  // namespace lessons
