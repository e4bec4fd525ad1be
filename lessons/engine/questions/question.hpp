#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lessons {

/// One of the answers that a question offers, and what it says of a reader who takes it.
struct Choice {
    std::string text;
    bool right = false;
    std::string reply;
};

/// A wrong answer that was foreseen, and the reply that names the mistake.
struct Mistake {
    enum class Kind { value, above, below };
    Kind kind = Kind::value;  ///< above, below: any answer on that side of the right one
    double value = 0;
    std::string reply;
};

/// A question to the reader. Its texts are Markdown, their numbers filled in.
struct Question {
    std::string name;
    std::string prose;
    std::vector<Choice> choices;  ///< one of them right; empty: a number is asked
    double value = 0;             ///< the number, in `unit`
    double tolerance = 0;         ///< how far from it an answer may be
    std::string unit;
    std::string answer;             ///< as the text shows it: "0.418 N s", or the right choice
    std::string reply;              ///< to the right number
    std::vector<Mistake> mistakes;  ///< when a number is asked
};

/// What an answer is: right; wrong, as foreseen or not; or nothing that can be graded.
enum class Grade { right, foreseen, wrong, unclear };

/// An answer's grade, and what to say to the reader (Markdown).
struct Graded {
    Grade grade = Grade::unclear;
    std::string reply;
};

/// Grades an answer as a reader types it. A number may have a decimal comma or point, groups of
/// three digits, a fraction's bar, and a unit or none; a choice is named by its letter, its number
/// or its words.
[[nodiscard]] Graded grade(const Question& question, std::string_view typed);

/// The letter of a choice, from 0: "a".
[[nodiscard]] std::string letter_of(std::size_t choice);

}  // namespace lessons
