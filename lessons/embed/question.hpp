#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lessons {

/// A line `key: text`.
struct KeyText {
    std::string text;
    int line = 0;  ///< of lesson.md, 1 and up
};

/// A line of a question: `answer: ...`, `within: ...`, `choice: ...`, `pick: ...`, `mistake: ...`,
/// `reply: ...`,
/// `told in: ...`.
struct QuestionLine {
    std::string key;
    KeyText said;
};

/// `{{ask: NAME}}` with the lines below it, as they were written: first the question's prose, then
/// what belongs to its answer.
struct QuestionScript {
    std::string name;
    int line = 0;  ///< of the tag
    KeyText prose;
    std::vector<QuestionLine> lines;
};

/// The key of a line `key: text`, in small letters; empty where it has none.
[[nodiscard]] std::string_view key_of(std::string_view line);

/// Takes the next line of a question. Throws lod::Error (input refused) for a key that no question
/// has.
void take_line(QuestionScript& question, const std::string& line, const std::string& where,
               int number);

}  // namespace lessons
