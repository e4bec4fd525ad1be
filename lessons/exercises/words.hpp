#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace exercises {

/// A line of the reference solution, and what may stand there instead.
struct CodeLine {
    std::string text;
    bool in_gap = false;                                        ///< the student writes it
    std::vector<std::pair<std::string, std::string>> mistakes;  ///< name -> text of the line
};

/// A foreseen mistake, and the reply that names it.
struct Mistake {
    std::string name;
    std::string reply;
};

/// An exercise as it was written, tasks/PART/NAME.md:
///
///     # TITLE
///     lesson: SLUG             of the lesson that it belongs to
///     case: ... {} ...         how a case is told: see told()
///     answer: ... {} ...       the same of an answer
///
///     What is to be done.
///
///     ## Code                  the reference solution, in a fence
///     ## Harness               what else takes cases and gives answers, where
///     lessons/exercises/wire.hpp does not
///     ## Hints                 a list, shown one by one
///     ## Mistakes              a list of `NAME: reply`
///
/// In the code, NAME(...) is the function; the lines between `//[` and `//]` are the gap, the text
/// that follows `//[` stands in the starter there; `//! NAME| text` is a mistake that replaces the
/// line before, and a second such line of the same name adds to it.
struct Words {
    std::string name;
    std::string title;
    std::string lesson;
    std::string told_case;
    std::string told_answer;
    std::string task;
    std::vector<CodeLine> code;
    std::vector<std::string> in_starter;  ///< lines in the gap
    std::string harness;
    std::vector<std::string> hints;
    std::vector<Mistake> mistakes;
};

/// `path` is PART/NAME. Throws lod::Error (input refused) with the line where the text is not as
/// Words says.
[[nodiscard]] Words read_words(const std::string& path, std::string_view markdown);

/// The solution, with these mistakes in it.
[[nodiscard]] std::string code_with(const Words& words, const std::vector<int>& mistakes);

/// What the student begins with, without the comment above it.
[[nodiscard]] std::string starter_code(const Words& words);

/// The type of the function: "bool(const lod::Sphere<2>& a)".
[[nodiscard]] std::string signature_of(const Words& words);
/// Its first lines as they stand in the code: "bool meet(const lod::Sphere<2>& a)".
[[nodiscard]] std::string declaration_of(const Words& words);

/// No mistake, each, and each two that replace different lines.
[[nodiscard]] std::vector<std::vector<int>> mixtures_of(const Words& words);

/// A row of numbers as `format` has it: {} is a number, {yes} yes or no, {skip N} leaves N out,
/// {list ...} is so many of what follows as the next number says, {count ...} how many.
[[nodiscard]] std::string told(std::string_view format, const std::vector<double>& numbers);

}  // namespace exercises
