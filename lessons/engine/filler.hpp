#pragma once

#include <set>
#include <string>

#include "lessons/embed/lines.hpp"
#include "lessons/engine/lessons.hpp"

namespace lessons {

template <class Table>
std::string names_in(const Table& table) {
    std::string names;
    for (const auto& [name, value] : table) names += (names.empty() ? "" : ", ") + name;
    return names.empty() ? "none" : names;
}

/// What the lesson's code gives by a name, or an error with the line that asks for it.
template <class Table>
const auto& find_given(const Table& table, const std::string& kind, const std::string& name,
                       const std::string& where, int line) {
    const auto found = table.find(name);
    if (found == table.end())
        refuse_line(where, line,
                    "no " + kind + " '" + name + "'; the lesson's code gives: " + names_in(table));
    return found->second;
}

/// Fills a lesson's words, and remembers what they used.
class Filler {
  public:
    explicit Filler(const Lesson& lesson) : lesson_(lesson) {}

    /// A text that begins after `lines_before` lines, its numbers of its own and of lessons filled
    /// in; other tags stay.
    std::string fill(const std::string& text, int lines_before);
    std::string fill(const KeyText& words) { return fill(words.text, words.line - 1); }

    /// "lesson 3", by its name.
    [[nodiscard]] std::string lesson(const std::string& name, int line) const;
    /// A number of the lesson, which is used by this.
    const Number& use_number(const std::string& name, int line);
    std::string number(const std::string& name, const std::string& format, int line);
    void use_figure(const std::string& name, int line);
    const Picks& use_picks(const std::string& name, int line);

    void use_live(int line);

    /// Throws for what the code gave in vain.
    void check_all_used() const;

    [[nodiscard]] const std::string& where() const { return lesson_.script.where; }

  private:
    const Lesson& lesson_;
    std::set<std::string> used_;
};

/// The question of a script, its answer from the lesson's numbers. Throws lod::Error (input
/// refused), with file and line, where it cannot be graded: no answer or two, a mistake that is the
/// answer, a reply to nothing.
[[nodiscard]] Question make_question(const QuestionScript& script, Filler& filler);

/// Throws lod::Error (input refused), with file and line, for a question that no later step
/// answers, and for one whose answer the reader has seen by then. Figures have their words.
void check_questions(const Lesson& lesson);

}  // namespace lessons
