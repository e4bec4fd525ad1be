#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lodlab/viz/figure/figure.hpp"

namespace lessons {

/// One of the answers that a question offers, and what it says of a reader who takes it.
struct Choice {
    std::string text;
    bool right = false;
    std::string reply;
};

/// A round mark of the step's picture that a reader may pick.
struct Pick {
    std::string name;  ///< which stands beside it: "3"
    viz::Point centre;
    double radius = 0;
    bool right = false;
    std::string kind;  ///< of a wrong one: by what mistakes call it
};
/// What a lesson's code gives for a question: all that may be picked.
using Picks = std::vector<Pick>;

/// A wrong answer that was foreseen, and the reply that names the mistake.
struct Mistake {
    /// Of numbers `value`, or any on that side of the right one; of picks those without a wrong
    /// one, those with one, those with one of a kind.
    enum class Kind { value, above, below, missing, more, kind };
    Kind kind = Kind::value;
    double value = 0;
    std::string reply;
    std::string picked = {};  ///< the kind of pick
};

/// A question to the reader. Its texts are Markdown, their numbers filled in.
struct Question {
    std::string name;
    std::string prose;
    std::vector<Choice> choices;  ///< one of them right
    Picks picks;           ///< some of them right; without choices and these a number is asked
    double value = 0;      ///< the number, in `unit`
    double tolerance = 0;  ///< how far from it an answer may be
    std::string unit;
    std::string answer;  ///< as the text shows it: "0.418 N s", the right choice or picks
    std::string reply;   ///< to the right number or picks
    std::vector<Mistake> mistakes;  ///< of numbers and picks
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
/// or its words, picks by their names.
[[nodiscard]] Graded grade(const Question& question, std::string_view typed);

/// The names of picks: "1, 4".
[[nodiscard]] std::string names_of(const Picks& picks, bool only_right);

/// The letter of a choice, from 0: "a".
[[nodiscard]] std::string letter_of(std::size_t choice);

}  // namespace lessons
