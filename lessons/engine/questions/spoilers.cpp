#include <algorithm>
#include <cctype>
#include <set>
#include <variant>

#include "lessons/embed/source.hpp"
#include "lessons/engine/filler.hpp"

namespace lessons {
namespace {

using Names = std::set<std::string>;  ///< of numbers

void add_numbers(Names& names, const std::string& text, const std::string& where) {
    for (const Tag& tag : find_tags(text, where))
        if (tag.kind == "number") names.insert(tag.name);
}

/// What the text of the page shows before its steps.
std::string opening(const Script& script) {
    return script.text.substr(0, script.text.find("{{steps}}"));
}

/// The numbers that a reader of a step sees in its text, its list and its figure's words.
Names told_by(const Script& script, const StepScript& step) {
    Names names;
    add_numbers(names, step.text, script.where);
    for (const ShownTag& tag : step.shown) names.insert(tag.name);
    if (const auto words = script.words.find(step.figure); words != script.words.end())
        for (const auto& [key, said] : words->second) add_numbers(names, said.text, script.where);
    return names;
}

/// The numbers in what a step's questions ask and, once they are answered, reply.
Names asked_by(const Script& script, const StepScript& step, bool is_answered) {
    Names names;
    for (const QuestionScript& question : step.questions) {
        add_numbers(names, question.prose.text, script.where);
        for (const QuestionLine& line : question.lines)
            if (is_answered && line.key == "reply")
                add_numbers(names, line.said.text, script.where);
    }
    return names;
}

/// The numbers that decide which answer is right.
Names decisive(const Script& script, const QuestionScript& question) {
    Names names;
    for (const QuestionLine& line : question.lines) {
        if (line.key == "answer") add_numbers(names, line.said.text, script.where);
        const std::size_t condition = line.said.text.rfind("(right if ");
        if (line.key == "choice" && condition != std::string::npos)
            add_numbers(names, line.said.text.substr(condition), script.where);
    }
    return names;
}

std::string words_of(const viz::Mark& mark) {
    if (const auto* label = std::get_if<viz::Label>(&mark)) return label->text;
    if (const auto* arrow = std::get_if<viz::Arrow>(&mark)) return arrow->label;
    if (const auto* line = std::get_if<viz::Polyline>(&mark)) return line->end_label;
    return {};
}

/// Whether a picture writes these words beside its marks, or at its head.
bool writes(const viz::Figure& figure, const std::string& words) {
    for (const viz::Quantity& number : figure.numbers)
        if (number.value == words) return true;
    for (const viz::Panel& panel : figure.panels) {
        if (panel.title.find(words) != std::string::npos) return true;
        for (const viz::Mark& mark : panel.marks)
            if (words_of(mark).find(words) != std::string::npos) return true;
    }
    return false;
}

/// Checks the questions of a step against what comes before and after.
class Check {
  public:
    Check(const Lesson& lesson, std::size_t step) : lesson_(lesson), step_(step) {
        const Script& script = lesson.script;
        add_numbers(seen_, opening(script), script.where);
        for (std::size_t i = 0; i < script.steps.size(); ++i) {
            Names names = told_by(script, script.steps[i]);
            if (i <= step) names.merge(asked_by(script, script.steps[i], i < step));
            (i <= step ? seen_ : later_).merge(names);
        }
    }

    void check(const QuestionScript& question) const {
        const Names names = decisive(lesson_.script, question);
        const QuestionLine* told = nullptr;
        for (const QuestionLine& line : question.lines)
            if (line.key == "told in") told = &line;
        if (told) check_told(question, told->said);
        for (const QuestionLine& line : question.lines)
            if (line.key == "pick") check_picks(question, lesson_.picks.at(line.said.text));
        std::string seen;  // where the reader has found out already
        bool is_open = names.empty();
        for (const std::string& name : names) {
            const std::string where = where_seen(name);
            if (!where.empty()) seen = where;
            if (!where.empty()) continue;
            is_open = true;
            if (!told && !later_.count(name))
                refuse(question, "is answered by no later step: show {{number: " + name +
                                     "}} in one, or name it in told in: TITLE OF THE STEP");
        }
        if (!is_open)
            refuse(question,
                   "is answered already: " + seen + "; ask before, or take it away there");
        if (names.empty() && !told)
            refuse(question,
                   "is answered by no later step; name one that does: told in: TITLE OF THE STEP");
    }

  private:
    [[noreturn]] void refuse(const QuestionScript& question, const std::string& why) const {
        refuse_line(lesson_.script.where, question.line, "question '" + question.name + "' " + why);
    }

    void check_told(const QuestionScript& question, const KeyText& told) const {
        for (std::size_t i = 0; i < lesson_.script.steps.size(); ++i)
            if (lesson_.script.steps[i].title == told.text && i > step_) return;
        refuse_line(lesson_.script.where, told.line,
                    "question '" + question.name + "' is told in no later step '" + told.text +
                        "'; write the title of one");
    }

    /// Whether a picture draws a right one as a circle that meets another.
    void check_picks(const QuestionScript& question, const Picks& picks) const {
        const viz::Figure& figure = lesson_.figures.at(lesson_.script.steps[step_].figure);
        if (figure.panels.empty()) return;
        for (const Pick& pick : picks)
            for (const viz::Mark& mark : figure.panels[0].marks) {
                const auto* disc = std::get_if<viz::Disc>(&mark);
                if (pick.right && disc && disc->centre == pick.centre &&
                    (disc->style.role == viz::Role::meeting_node ||
                     disc->style.role == viz::Role::true_collision))
                    refuse(question, "is answered by its picture, which draws " + pick.name +
                                         " as one that meets");
            }
    }

    /// Where a number stands in this step or before: under its name, under another with the same
    /// words, or in a picture; empty where nowhere.
    [[nodiscard]] std::string where_seen(const std::string& name) const {
        const std::string here = " stands in this step or before";
        if (seen_.count(name)) return "'" + name + "'" + here;
        constexpr std::ptrdiff_t telling = 3;  // fewer digits mean many things
        const Number& number = lesson_.numbers.at(name);
        const std::ptrdiff_t digits =
            std::count_if(number.text.begin(), number.text.end(),
                          [](unsigned char c) { return std::isdigit(c) != 0; });
        if (!number.is_counted || digits < telling) return {};
        for (const std::string& other : seen_)
            if (lesson_.numbers.at(other).text == number.text)
                return "'" + other + "', " + number.text + " as well," + here;
        for (std::size_t i = 0; i <= step_; ++i) {
            const std::string& figure = lesson_.script.steps[i].figure;
            if (writes(lesson_.figures.at(figure), number.text))
                return "the picture '" + figure + "' says " + number.text;
        }
        return {};
    }

    const Lesson& lesson_;
    std::size_t step_;
    Names seen_;
    Names later_;
};

}  // namespace

void check_questions(const Lesson& lesson) {
    const std::vector<StepScript>& steps = lesson.script.steps;
    for (std::size_t i = 0; i < steps.size(); ++i)
        for (const QuestionScript& question : steps[i].questions) Check(lesson, i).check(question);
}

}  // namespace lessons
