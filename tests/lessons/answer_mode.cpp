// Questions in the terminal: what is typed to them is an answer, and only a colon makes it a
// command.

#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "lessons/engine/lessons.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"

using namespace lessons;

namespace {

Question number_question() {
    Question question;
    question.name = "tests";
    question.prose = "How many tests?";
    question.value = 16;
    question.answer = "16";
    question.reply = "Four times four.";
    question.mistakes = {{Mistake::Kind::value, 8, "That is the *sum*."}};
    return question;
}

Question choice_question() {
    Question question;
    question.name = "verdict";
    question.prose = "What is said?";
    question.choices = {
        {"apart", false, "No proof."}, {"nothing", false, ""}, {"possible", true, "So it is."}};
    question.answer = "possible";
    return question;
}

/// Three steps: the first asks for a number, the second for a number and a choice.
Lesson asking() {
    Lesson lesson;
    lesson.entry = {7, "three", "Three"};
    for (int i = 1; i <= 3; ++i) {
        Step step;
        step.title = "Title " + std::to_string(i);
        step.text = "Text.";
        step.figure = "figure";
        if (i < 3) step.questions.push_back(number_question());
        if (i == 2) step.questions.push_back(choice_question());
        lesson.steps.push_back(step);
    }
    return lesson;
}

std::string dialogue(const std::string& input, const StepperOptions& options = {}) {
    std::istringstream in(input);
    std::ostringstream out;
    step_in_terminal(asking(), in, out, options);
    return out.str();
}

/// The numbers of the steps shown, in order.
std::string steps_shown(const std::string& output) {
    std::string steps;
    for (std::size_t at = output.find("\n["); at != std::string::npos;
         at = output.find("\n[", at + 1))
        steps += output[at + 2];
    return steps;
}

std::size_t times(const std::string& output, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = output.find(part); at != std::string::npos;
         at = output.find(part, at + 1))
        ++count;
    return count;
}

bool prints(const std::string& output, const std::string& part) {
    return times(output, part) > 0;
}

}  // namespace

TEST_CASE("a question keeps the reader until it is answered or passed", "[lessons]") {
    CHECK(steps_shown(dialogue("\n\nn\n:n\n:3\n")) == "1");
    CHECK(steps_shown(dialogue("16\n\n")) == "12");
    CHECK(steps_shown(dialogue(":p\n\n")) == "12");
    CHECK(steps_shown(dialogue("16\n3\n")) == "12");  // the second asks as well
    CHECK(steps_shown(dialogue("16\n\n16\nc\n\n")) == "123");
    CHECK(steps_shown(dialogue("16\n\n:b\n\n:p\n:p\n\n")) == "12123");
    CHECK(prints(dialogue(":n\n"), "First answer the question of this step"));
}

TEST_CASE("what is typed to a question is an answer, even where it is a command's letter",
          "[lessons]") {
    for (const std::string letter :
         {"n", "b", "p", "q", "t", "?", "h", "g2", "2", "3", "next", "quit", "back", "\033[C"}) {
        INFO(letter);
        const std::string output = dialogue(letter + "\n16\n");
        CHECK(steps_shown(output) == "1");
        CHECK(prints(output, "Four times four."));
    }
    const std::string second = dialogue("16\n\n16\nb\na\nc\n");  // b and a are choices there
    CHECK(steps_shown(second) == "12");
    CHECK(prints(second, "No proof."));
    CHECK(prints(second, "So it is."));
}

TEST_CASE("right, foreseen, other and unclear answers get their replies", "[lessons]") {
    CHECK(prints(dialogue("16\n"), "Right. Four times four.\n\nEnter: next step."));
    CHECK(prints(dialogue("16,0\n"), "Right."));
    CHECK(prints(dialogue("8\n"), "That is the sum.\nTry again"));
    CHECK(prints(dialogue("9\n"), "Not that. Try again, or pass."));
    CHECK(prints(dialogue("\n"), "Type an answer, or pass."));
    CHECK(prints(dialogue("many\n"), "That is no number."));
    CHECK(prints(dialogue("16\n\n16\nd\n"), "Answer with a letter, a to c."));
    CHECK(prints(dialogue(":p\n"), "a later step tells the answer"));
}

TEST_CASE("a colon makes a command of an answer's line", "[lessons]") {
    CHECK(prints(dialogue(":h\n"), ":p   pass this question"));
    CHECK(prints(dialogue(":\n"), ":p   pass this question"));
    CHECK(prints(dialogue(":b\n"), "This is the first step."));
    CHECK(prints(dialogue(":dance\n"), "'dance' is no command"));
    CHECK(dialogue(":q\n16\n") == dialogue(":q\n"));
    CHECK(steps_shown(dialogue("16\n:n\n")) == "12");  // where none is asked as well
    CHECK(prints(dialogue("16\n:p\n"), "':p' is no command"));
}

TEST_CASE("the question is asked once, and again when its step is shown again", "[lessons]") {
    CHECK(times(dialogue("1\n2\n3\n"), "How many tests?") == 1);
    CHECK(times(dialogue("1\n2\n3\n"), "answer> ") == 4);
    CHECK(times(dialogue(":1\n"), "How many tests?") == 2);
    const std::string choices = dialogue(":p\n\n:p\n");
    CHECK(prints(choices, "  a) apart\n  b) nothing\n  c) possible\n"));
}

TEST_CASE("the lesson ends with a word on its questions", "[lessons]") {
    CHECK(prints(dialogue("8\n16\n\n16\n:p\n\nn\n"),
                 "last step. b goes back, q quits.\nQuestions: 1 right at the first try, 1 after a "
                 "mistake, 1 passed, 0 open."));
    CHECK(prints(dialogue("16\n:q\n"),
                 "Questions: 1 right at the first try, 0 after a mistake, 0 "
                 "passed, 2 open."));
    CHECK_FALSE(prints(dialogue(":q\n"), "Questions:"));
    CHECK(
        prints(dialogue("many\n\n16\n:q\n"), "1 right at the first try"));  // unclear is no mistake
}

TEST_CASE("on a terminal an answer is a line, with its keys for mending it", "[lessons]") {
    int screen = -1;  // the end that a terminal program would hold
    int keyboard = -1;
    REQUIRE(openpty(&screen, &keyboard, nullptr, nullptr, nullptr) == 0);
    termios raw{};
    REQUIRE(tcgetattr(keyboard, &raw) == 0);
    cfmakeraw(&raw);  // so that the keys below reach the stepper as they are
    REQUIRE(tcsetattr(keyboard, TCSANOW, &raw) == 0);
    const std::string erase = "\177";
    const std::string erase_line = "\025";
    const std::string keys = "q9\n\033[C\033[5~8\n" + ("1ä" + erase) + ("n1" + erase + erase) +
                             ("7" + erase + "6\n") + " " + ("q17" + erase_line + "16\n") +
                             "b\n:b\n\004";
    REQUIRE(write(screen, keys.data(), keys.size()) == static_cast<ssize_t>(keys.size()));
    StepperOptions options;
    options.keyboard = keyboard;
    const std::string output = dialogue("", options);
    CHECK(prints(output, "That is no number."));  // q9
    CHECK(prints(output, "That is the sum."));    // 8, after keys that type nothing
    CHECK(times(output, "Four times four.") == 2);
    CHECK(prints(output, "Answer with a letter") == false);
    CHECK(prints(output, "Not that."));  // b, a choice
    CHECK(steps_shown(output) == "121");
    close(screen);
    close(keyboard);
}

TEST_CASE("a terminal without UTF-8 gets ASCII alone, and the same grades", "[lessons]") {
    StepperOptions options;
    options.ascii = true;
    for (const Entry& entry : list()) {
        if (lodtest::sanitized && entry.number > 2) break;
        std::istringstream in("-1\n\xff\xfe\n:p\n\nt\n");
        std::ostringstream out;
        step_in_terminal(run(entry.number), in, out, options);
        const std::string shown = out.str();
        CHECK(std::all_of(shown.begin(), shown.end(),
                          [](char c) { return static_cast<unsigned char>(c) < 0x80; }));
    }
    CHECK(prints(dialogue("8\n16\n", options), "Right. Four times four."));
}

TEST_CASE("a long question is broken at the terminal's width", "[lessons]") {
    StepperOptions options;
    options.columns = 40;
    const std::string output = dialogue("", options);
    std::istringstream lines(output.substr(output.find("Question.")));
    for (std::string line; std::getline(lines, line);) {
        INFO(line);
        CHECK(line.size() <= 52);  // the line on what to press is ours, and short
    }
}
