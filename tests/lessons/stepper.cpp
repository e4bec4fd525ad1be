#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "lessons/engine/lessons.hpp"
#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"
#include "tests/lessons/scratch.hpp"

using namespace lessons;

namespace {

/// A lesson of three steps.
Lesson three_steps() {
    Lesson lesson;
    lesson.entry = {7, "three", "Three"};
    for (int i = 1; i <= 3; ++i) {
        Step step;
        step.title = "Title " + std::to_string(i);
        step.text = "Text " + std::to_string(i) + ".";
        step.figure = "figure " + std::to_string(i);
        viz::Panel panel;
        panel.view = {{-1, -1}, {1, 1}};
        panel.marks.push_back(viz::Disc{{}, {0, 0}, 0.1 * i});
        lesson.figures[step.figure].panels.push_back(panel);
        lesson.steps.push_back(step);
    }
    return lesson;
}

std::string session(const std::string& input, const StepperOptions& options = {}) {
    std::istringstream in(input);
    std::ostringstream out;
    step_in_terminal(three_steps(), in, out, options);
    return out.str();
}

/// What a lesson prints on a terminal of that size whose reader presses the keys.
std::string on_terminal(const Lesson& lesson, std::uint16_t columns, std::uint16_t rows,
                        const std::string& keys) {
    int screen = -1;
    int keyboard = -1;
    winsize window{};
    window.ws_col = columns;
    window.ws_row = rows;
    REQUIRE(openpty(&screen, &keyboard, nullptr, nullptr, &window) == 0);
    REQUIRE(write(screen, keys.data(), keys.size()) == static_cast<ssize_t>(keys.size()));
    std::istringstream none;
    std::ostringstream out;
    StepperOptions options;
    options.keyboard = keyboard;
    step_in_terminal(lesson, none, out, options);
    close(keyboard);
    close(screen);
    return out.str();
}

/// What the stepper printed for each step it showed, in order: from "[2/7]" to its end.
std::vector<std::string> texts(const std::string& output) {
    std::vector<std::string> result;
    const std::regex step("\n\\[[0-9]+/[0-9]+\\][^]*?(?=\n> |\n\nQuestion)");
    for (std::sregex_iterator it(output.begin(), output.end(), step), end; it != end; ++it)
        result.push_back(it->str());
    return result;
}

/// The numbers of the steps shown, in order.
std::string shown_steps(const std::string& output) {
    std::string steps;
    for (const std::string& text : texts(output)) steps += text[2];
    return steps;
}

}  // namespace

TEST_CASE("a pipe steps forwards and back line by line", "[lessons]") {
    CHECK(shown_steps(session("")) == "1");
    CHECK(shown_steps(session("\n\n")) == "123");
    CHECK(shown_steps(session("n\nn\nb\np\n")) == "12321");
    CHECK(shown_steps(session("3\ng1\ng 2\nq\nn\n")) == "1312");
    CHECK(shown_steps(session("right\nleft\n")) == "121");
    CHECK(shown_steps(session("\033[C\n\033[D\n")) == "121");
    CHECK(shown_steps(session("n\r\n")) == "12");
}

TEST_CASE("a step reads the same forwards and back", "[lessons]") {
    const auto seen = texts(session("n\nn\nb\nb\n"));
    REQUIRE(seen.size() == 5);
    CHECK(seen[0] == seen[4]);
    CHECK(seen[1] == seen[3]);
}

TEST_CASE("the ends, a wrong number and an unknown command are answered in words", "[lessons]") {
    CHECK(session("b\n").find("first step") != std::string::npos);
    CHECK(session("3\nn\n").find("last step") != std::string::npos);
    CHECK(session("9\n").find("steps 1 to 3") != std::string::npos);
    CHECK(session("0\n").find("steps 1 to 3") != std::string::npos);
    CHECK(session("hello\n").find("'hello' is no command") != std::string::npos);
    CHECK(session("?\n").find("go to step") != std::string::npos);
}

TEST_CASE("a terminal steps by single keys, arrows among them, and is left as it was",
          "[lessons]") {
    int screen = -1;  // the end that a terminal program would hold
    int keyboard = -1;
    REQUIRE(openpty(&screen, &keyboard, nullptr, nullptr, nullptr) == 0);
    termios before{};
    REQUIRE(tcgetattr(keyboard, &before) == 0);
    const std::string keys =
        " \033[D\033[C\033OD"
        "3\ng2\nnbpq";
    REQUIRE(write(screen, keys.data(), keys.size()) == static_cast<ssize_t>(keys.size()));
    StepperOptions options;
    options.keyboard = keyboard;
    CHECK(shown_steps(session("", options)) ==
          "121213"
          "2321");
    termios after{};
    REQUIRE(tcgetattr(keyboard, &after) == 0);
    CHECK(after.c_lflag == before.c_lflag);
    close(screen);
    close(keyboard);
}

TEST_CASE("stepping begins at the step that was asked for, or says which there are", "[lessons]") {
    StepperOptions options;
    options.first_step = 2;
    CHECK(shown_steps(session("n\n", options)) == "23");
    options.first_step = 4;
    CHECK_THROWS_AS(session("", options), lod::Error);
}

TEST_CASE("the picture of each step that was seen is written to the folder", "[lessons]") {
    const Scratch folder;
    StepperOptions options;
    options.pictures = folder.path() / "pictures";
    const std::string output = session("n\nb\n", options);
    CHECK(std::filesystem::file_size(options.pictures / "step_01.png") > 1000);
    CHECK(std::filesystem::exists(options.pictures / "step_02.png"));
    CHECK_FALSE(std::filesystem::exists(options.pictures / "step_03.png"));
    CHECK(output.find("step_02.png") != std::string::npos);
}

TEST_CASE("a picture of the reader's own is not replaced, one of the same lesson is", "[lessons]") {
    const Scratch folder;
    StepperOptions options;
    options.pictures = folder.path();
    session("n\n", options);
    CHECK_NOTHROW(session("n\n", options));
    const std::filesystem::path third = folder.path() / "step_03.png";
    std::ofstream(third) << "mine";
    try {
        session("n\n", options);
        FAIL("the reader's picture may be replaced");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::output_failed);
        CHECK_THAT(error.what(), lodtest::contains("step_03.png: another picture has that name"));
    }
    CHECK(std::filesystem::file_size(third) == 4);
}

TEST_CASE("on a terminal a long text comes by windows, and q is enough of it", "[lessons]") {
    Lesson lesson = three_steps();
    for (int i = 1; i <= 20; ++i) lesson.text += "Paragraph " + std::to_string(i) + ".\n\n";
    // Its text, one window more, enough; the end. Five lines a window, every other blank.
    const std::string output = on_terminal(lesson, 40, 6, "t qq");
    CHECK_THAT(output, lodtest::contains("Paragraph 5."));
    CHECK(output.find("Paragraph 6.") == std::string::npos);
}

TEST_CASE("text is as wide as the terminal's window", "[lessons]") {
    Lesson lesson = three_steps();
    for (int i = 0; i < 40; ++i) lesson.steps[0].text += " word";
    for (const std::uint16_t columns : std::array<std::uint16_t, 2>{40, 60}) {
        std::istringstream lines(on_terminal(lesson, columns, 24, "q"));
        std::size_t widest = 0;
        for (std::string line; std::getline(lines, line);)
            if (line.find("word word") != std::string::npos) widest = std::max(widest, line.size());
        CHECK(widest <= columns);
        CHECK(widest + 5 > columns);
    }
}

TEST_CASE("a folder for pictures that cannot be made is refused", "[lessons]") {
    StepperOptions options;
    options.pictures = "/proc/none/pictures";
    try {
        session("", options);
        FAIL("a folder below /proc was made");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::output_failed);
    }
}

TEST_CASE("every lesson can be stepped through to its end and back in a pipe", "[lessons]") {
    for (const Entry& entry : list()) {
        const Lesson lesson = run(entry.number);
        std::string input;
        for (std::size_t i = 1; i < lesson.steps.size(); ++i) {
            for (const Question& question : lesson.steps[i - 1].questions)
                input += question.choices.empty() ? "0\n:p\n" : "a\n" + question.answer + "\n";
            input += "n\n";
        }
        for (std::size_t i = 1; i < lesson.steps.size(); ++i) input += "b\n";
        std::istringstream in(input + "t\nq\n");
        std::ostringstream out;
        step_in_terminal(lesson, in, out);
        const auto seen = texts(out.str());
        REQUIRE(seen.size() == 2 * lesson.steps.size() - 1);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            CHECK(seen[i] == seen[seen.size() - 1 - i]);
            CHECK(seen[i].find("**") == std::string::npos);
        }
        CHECK(out.str().find("{{") == std::string::npos);
    }
}
