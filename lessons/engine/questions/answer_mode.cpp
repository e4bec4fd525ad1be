#include "lessons/engine/questions/answer_mode.hpp"

#include <algorithm>
#include <ostream>

#include "lessons/embed/lines.hpp"
#include "lessons/engine/plain.hpp"
#include "lessons/engine/sketch.hpp"
#include "lessons/engine/terminal/viewer.hpp"

namespace lessons {

std::string in_words(const Tally& tally) {
    return std::to_string(tally.at_once) + " right at the first try, " +
           std::to_string(tally.later) + " after a mistake, " + std::to_string(tally.passed) +
           " passed, " + std::to_string(tally.open) + " open.";
}

AnswerMode::AnswerMode(const Lesson& lesson, std::ostream& output, const StepperOptions& options)
    : lesson_(lesson), output_(output), options_(options) {
    for (const Step& step : lesson.steps) states_.emplace_back(step.questions.size());
}

std::size_t AnswerMode::first_open(int step) const {
    const std::vector<State>& states = states_[static_cast<std::size_t>(step - 1)];
    const auto open = std::find_if(states.begin(), states.end(), [](const State& state) {
        return !state.right && !state.passed;
    });
    return static_cast<std::size_t>(open - states.begin());
}

const Question* AnswerMode::open_in(int step) const {
    const std::vector<Question>& questions =
        lesson_.steps[static_cast<std::size_t>(step - 1)].questions;
    const std::size_t i = first_open(step);
    return i < questions.size() ? &questions[i] : nullptr;
}

std::optional<int> AnswerMode::blocked_between(int from, int to) const {
    for (int step = from; step < to; ++step)
        if (open_in(step)) return step;
    return {};
}

void AnswerMode::say(const std::string& markdown, const std::string& indent) {
    const int columns = options_.columns - static_cast<int>(indent.size());
    for (const std::string& line :
         lines_of(text_for_terminal(lesson_, markdown, columns, options_.styled)))
        output_ << indent << line << "\n";
}

void AnswerMode::ask(int step) {
    const Question& question = *open_in(step);
    output_ << "\n";
    say("**Question.** " + question.prose);
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        say(letter_of(i) + ") " + question.choices[i].text, "  ");
    for (const Pick& pick : question.picks)
        say(pick.name + ": at (" + shown(pick.centre.x, 2) + ", " + shown(pick.centre.y, 2) +
                "), radius " + shown(pick.radius, 2) + " m",
            "  ");
    output_ << (!question.picks.empty()
                    ? "Type the names of all that you pick, as in " + question.picks[0].name + " " +
                          question.picks[1].name + ","
                : question.choices.empty() ? "Type a number"
                                           : "Type a letter")
            << " and Enter; :p passes, :h helps.\n";
}

void AnswerMode::answer(int step, const std::string& typed) {
    const Question& question = *open_in(step);
    State& state = states_[static_cast<std::size_t>(step - 1)][first_open(step)];
    const Graded graded = grade(question, typed);
    const bool is_right = graded.grade == Grade::right;
    state.right = is_right;
    if (graded.grade == Grade::foreseen || graded.grade == Grade::wrong) ++state.mistakes;
    output_ << "\n";
    say(is_right && graded.reply != "Right." ? "**Right.** " + graded.reply : graded.reply);
    if (graded.grade == Grade::foreseen) output_ << "Try again, or pass by :p.\n";
}

void AnswerMode::pass(int step) {
    states_[static_cast<std::size_t>(step - 1)][first_open(step)].passed = true;
    output_ << "\nPassed: a later step tells the answer.\n";
}

Tally AnswerMode::tally() const {
    Tally tally;
    for (const std::vector<State>& states : states_)
        for (const State& state : states) {
            if (state.passed)
                ++tally.passed;
            else if (!state.right)
                ++tally.open;
            else
                ++(state.mistakes == 0 ? tally.at_once : tally.later);
        }
    return tally;
}

namespace {

/// Takes the last character, of one byte or more, off a line.
void take_back(std::string& line, std::ostream& output) {
    if (line.empty()) return;
    while (line.size() > 1 && (static_cast<unsigned char>(line.back()) & 0xC0U) == 0x80U)
        line.pop_back();
    line.pop_back();
    output << "\b \b" << std::flush;
}

}  // namespace

std::optional<std::string> read_line_from_keys(int terminal, std::ostream& output) {
    constexpr int end_of_input = 4;  // Ctrl-D
    constexpr int erase_line = 21;   // Ctrl-U
    constexpr int escape = 27;
    constexpr int backspace = 8;
    constexpr int erase = 127;
    std::string line;
    for (;;) {
        const int key = read_key(terminal);
        if (key < 0 || (key == end_of_input && line.empty())) return {};
        if (key == '\n' || key == '\r') return line;
        if (key == escape) {  // an arrow or another key without a character
            while (key_waiting(terminal)) {
                const int next = read_key(terminal);
                if (next < 0 || next == '~' || (next >= '@' && next != '[' && next != 'O')) break;
            }
        } else if (key == erase || key == backspace) {
            take_back(line, output);
        } else if (key == erase_line) {
            while (!line.empty()) take_back(line, output);
        } else if (key >= ' ') {
            line += static_cast<char>(key);
            output << static_cast<char>(key) << std::flush;
        }
    }
}

}  // namespace lessons
