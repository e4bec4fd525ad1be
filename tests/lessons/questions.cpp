// Questions: how they are written, made and graded.

#include <fstream>
#include <sstream>

#include "lessons/embed/lines.hpp"
#include "lessons/embed/script.hpp"
#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"

using namespace lessons;

namespace {

std::string name_of(Grade grade) {
    constexpr const char* names[] = {"right", "foreseen", "wrong", "unclear"};
    return names[static_cast<int>(grade)];
}

std::vector<std::string> fields_of(const std::string& text, char sign) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, sign);) parts.push_back(trimmed(part));
    return parts;
}

Question question_of(const std::vector<std::string>& row) {
    Question question;
    question.value = std::stod(row[0]);
    question.tolerance = std::stod(row[1]);
    question.unit = row[2];
    for (const std::string& foreseen : fields_of(row[3], ',')) {
        Mistake mistake;
        if (foreseen == "above")
            mistake.kind = Mistake::Kind::above;
        else if (foreseen == "below")
            mistake.kind = Mistake::Kind::below;
        else
            mistake.value = std::stod(foreseen);
        mistake.reply = "foreseen " + std::to_string(question.mistakes.size());
        question.mistakes.push_back(mistake);
    }
    return question;
}

Question three_choices() {
    Question question;
    question.choices = {{"apart", false, "No proof."},
                        {"possible", true, "Nothing is known."},
                        {"true collision", false, ""}};
    return question;
}

std::string grade_of(const std::string& typed) {
    return name_of(grade(three_choices(), typed).grade);
}

constexpr const char* two_steps =
    "# Small\n\n"
    "### Step: One\n\nFirst.\n\n"
    "{{ask: how deep}}\nHow deep is\nthe hole?\nanswer: {{number: depth}}\nwithin: 10 %\n"
    "reply: As deep.\nmistake: 2 × {{number: depth}}\nreply: Twice as deep.\n\n"
    "{{figure: hole}}\ntitle: A hole\nalt: A hole in the ground.\n\n"
    "### Step: Two\n\nIt is {{number: depth}}.\n\n{{figure: hill}}\ntitle: A hill\nalt: A hill.\n";

Lesson lesson_of(const std::string& text) {
    Lesson lesson;
    lesson.entry = {9, "small", "Small"};
    lesson.script = read_script(text, "small.md");
    give(lesson, "depth", number(0.5, 2, "m"));
    give(lesson, "hole", viz::Figure());
    give(lesson, "hill", viz::Figure());
    complete(lesson);
    return lesson;
}

/// The text with a part of it replaced.
std::string replaced(const std::string& part, const std::string& other) {
    std::string text = two_steps;
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    return text.replace(at, part.size(), other);
}

/// What is said against a text; empty where nothing is.
std::string refusal_of(const std::string& text) {
    try {
        (void)lesson_of(text);
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::input_refused);
        return error.what();
    }
    return {};
}

void check_refused(const std::string& text, const std::string& why) {
    CHECK_THAT(refusal_of(text), lodtest::contains(why));
}

/// One right pick alone misses the others; all right ones and a wrong one are too many.
void check_mistakes_in_picks(const Question& question) {
    const auto first = [&](bool right) {
        return std::find_if(question.picks.begin(), question.picks.end(),
                            [&](const Pick& pick) { return pick.right == right; })
            ->name;
    };
    CHECK(grade(question, first(true)).grade == Grade::foreseen);
    CHECK(grade(question, question.answer + " " + first(false)).grade == Grade::foreseen);
}

constexpr const char* number_lines =
    "answer: {{number: depth}}\nwithin: 10 %\nreply: As deep.\nmistake: 2 × {{number: depth}}\n"
    "reply: Twice as deep.\n";

}  // namespace

TEST_CASE("answers are graded as the table says", "[lessons]") {
    std::ifstream table(LODLAB_SOURCE_DIR "/tests/lessons/grading.txt");
    int rows = 0;
    for (std::string line; std::getline(table, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::vector<std::string> row = fields_of(line, '|');
        REQUIRE(row.size() == 6);
        ++rows;
        INFO(line);
        const Graded graded = grade(question_of(row), row[4]);
        const std::string found =
            graded.grade == Grade::foreseen ? graded.reply : name_of(graded.grade);
        CHECK(found == row[5]);
        CHECK_FALSE(graded.reply.empty());
    }
    CHECK(rows > 80);
}

TEST_CASE("a choice is named by its letter, its number or its words, and by nothing else",
          "[lessons]") {
    for (const std::string answer : {"b", "B", " b ", "b)", "b.", "2", "possible", "Possible"})
        CHECK(grade_of(answer) == "right");
    for (const std::string answer : {"a", "1", "apart"}) CHECK(grade_of(answer) == "foreseen");
    CHECK(grade_of("c") == "wrong");
    for (const std::string answer : {"", " ", "d", "n", "q", "?", "4", "0", "-1", "ab", "b b"})
        CHECK(grade_of(answer) == "unclear");
}

TEST_CASE("an answer of wild bytes is graded without harm", "[lessons]") {
    for (const std::string& wild :
         {std::string("\xff\xfe"), std::string("\0", 1), std::string(100000, '9'),
          std::string("\xe2\x88"), std::string(3, '/'), std::string("16\x1b[2J")}) {
        CHECK(grade(three_choices(), wild).grade == Grade::unclear);
        CHECK(grade(question_of({"16", "0", "m", "8", "", ""}), wild).grade == Grade::unclear);
    }
}

TEST_CASE("a question is made of the lines below its tag", "[lessons]") {
    const Lesson lesson = lesson_of(two_steps);
    REQUIRE(lesson.steps[0].questions.size() == 1);
    const Question& question = lesson.steps[0].questions[0];
    CHECK(question.name == "how deep");
    CHECK(question.prose == "How deep is the hole?");
    CHECK(question.value == 0.5);
    CHECK(question.unit == "m");
    CHECK(question.tolerance == Approx(0.05));
    CHECK(question.reply == "As deep.");
    REQUIRE(question.mistakes.size() == 1);
    CHECK(question.mistakes[0].value == 1);
    CHECK(question.mistakes[0].reply == "Twice as deep.");
    CHECK(lesson.steps[0].text == "First.");
    CHECK(lesson.steps[1].questions.empty());
}

TEST_CASE("without a tolerance a number may be off by its rounding", "[lessons]") {
    const Lesson lesson = lesson_of(replaced("within: 10 %\n", ""));
    CHECK(lesson.steps[0].questions[0].tolerance == Approx(0.005));
}

TEST_CASE("the right choice follows from the lesson's numbers", "[lessons]") {
    const auto right = [](const std::string& condition) {
        const std::string choices = "choice: deep (right if " + condition +
                                    ")\nreply: Yes.\nchoice: flat\nreply: No.\n"
                                    "told in: Two\n";
        return refusal_of(replaced(number_lines, choices));
    };
    CHECK(right("{{number: depth}} > 0.4").empty());
    CHECK(right("{{number: depth}} × 2 = 1 and {{number: depth}} < 0.6").empty());
    CHECK_THAT(right("{{number: depth}} < 0.5"), lodtest::contains("no right choice"));
    CHECK_THAT(right("{{number: depth}}"), lodtest::contains("compares nothing"));
    CHECK_THAT(right("{{number: depth}} > deep"), lodtest::contains("'deep' is no number"));
    const std::string words =
        "choice: 0.50\u00a0m\nchoice: 1 m\nreply: No.\nanswer: {{number: depth}}\n";
    CHECK(lesson_of(replaced(number_lines, words)).steps[0].questions[0].choices[0].right);
}

TEST_CASE("a question that cannot be graded is refused with its line and the mend", "[lessons]") {
    check_refused(replaced(number_lines, "told in: Two\n"),
                  "small.md:7: question 'how deep' has no answer");
    check_refused(replaced("answer: {{number: depth}}", "answer: {{number: width}}"),
                  "small.md:10: no number 'width'; the lesson's code gives: depth");
    check_refused(replaced("answer: {{number: depth}}", "answer: 0.5"),
                  "small.md:10: question 'how deep' takes its answer from the code");
    check_refused(replaced("mistake: 2 ×", "mistake: 1.01 ×"),
                  "small.md:13: question 'how deep' has a mistake that is the answer, 0.50");
    check_refused(replaced("mistake: 2 × {{number: depth}}\nreply: Twice as deep.\n", ""),
                  "small.md:7: question 'how deep' foresees no mistake");
    check_refused(replaced("reply: Twice as deep.\n", ""),
                  "small.md:13: question 'how deep' has a mis");
    check_refused(replaced("within: 10 %", "within: little"),
                  "small.md:11: question 'how deep' is");
    check_refused(replaced("mistake: 2 ×", "mistaek: 2 ×"),
                  "small.md:13: a question has no 'mistaek'");
    check_refused(replaced("How deep is\nthe hole?\n", ""), "small.md:7: question 'how deep' asks");
    check_refused(replaced("reply: Twice as deep.\n", "reply: Twice.\nmistake: 1\nreply: Again.\n"),
                  "small.md:15: question 'how deep' foresees this mistake already, in line 13");
    const auto choices = [](const std::string& lines) { return replaced(number_lines, lines); };
    check_refused(choices("choice: a\nchoice: b\nreply: No.\n"), "has no right choice");
    check_refused(choices("choice: a (right)\nchoice: b (right)\nreply: No.\n"),
                  "two right choices");
    check_refused(choices("choice: a (right)\nchoice: b\n"), "foresees no mistake");
    check_refused(choices("choice: a\nchoice: b\nreply: No.\nanswer: {{number: depth}}\n"),
                  "has no choice '0.50");
}

TEST_CASE("a question stands in a step, once, with words and numbers only", "[lessons]") {
    check_refused(replaced("# Small\n\n", "# Small\n\n{{ask: early}}\nWhat?\n\n"),
                  "small.md:3: a question stands in a step");
    check_refused(replaced("First.", "First {{ask: here}}"), "small.md:5: a question stands on a");
    check_refused(replaced("It is {{number: depth}}.\n",
                           "It is {{number: depth}}.\n\n{{ask: how deep}}\nAgain?\n"),
                  "small.md:24: question 'how deep' is asked already, in line 7");
    check_refused(replaced("How deep is\n", "How deep is {{figure: hole}} the\n"),
                  "small.md:8: a figure stands on a line of its own");
}

TEST_CASE("a question without a later answer is refused, and so is one answered before",
          "[lessons]") {
    check_refused(replaced("It is {{number: depth}}.", "It is deep."),
                  "small.md:7: question 'how deep' is answered by no later step");
    CHECK(refusal_of(replaced("It is {{number: depth}}.\n\n{{figure: hill}}\ntitle: A hill\n",
                              "It is deep.\n\n{{figure: hill}}\ntitle: A {{number: depth}} hole\n"))
              .empty());
    const std::string told = "reply: Twice as deep.\ntold in: Two\n";
    std::string text = replaced("reply: Twice as deep.\n", told);
    CHECK(refusal_of(text.replace(text.find("It is {{number: depth}}"), 23, "It is deep")).empty());
    check_refused(replaced("reply: Twice as deep.\n", "reply: Twice.\ntold in: One\n"),
                  "small.md:15: question 'how deep' is told in no later step 'One'");
    check_refused(replaced("reply: Twice as deep.\n", "reply: Twice.\ntold in: Three\n"),
                  "no later step");
    for (const auto& [part, spoilt] :
         {std::pair{"First.", "First {{number: depth}}."},
          {"title: A hole\n", "title: A hole of {{number: depth}}\n"},
          {"alt: A hole in the ground.\n", "alt: A hole, {{number: depth}} deep.\n"},
          {"First.\n", "First.\n\n{{shown: deep = depth}}\n"},
          {"# Small\n", "# Small\n\nIt is {{number: depth | 1 digit}}.\n"},
          {"How deep is\n", "{{number: depth}}? How deep is\n"}})
        check_refused(replaced(part, spoilt), "question 'how deep' is answered already");
}

TEST_CASE("a picture that shows the answer before is refused", "[lessons]") {
    for (const bool by_label : {true, false}) {
        Lesson lesson;
        lesson.entry = {9, "small", "Small"};
        lesson.script = read_script(two_steps, "small.md");
        give(lesson, "depth", number(0.5, 2, "m"));
        viz::Figure hole;
        hole.panels.emplace_back();
        const std::string words = lesson.numbers["depth"].text;
        if (by_label)
            hole.panels[0].marks.push_back(viz::Label{{}, {0, 0}, "depth " + words, 0});
        else
            hole.numbers = {{"depth", words}};
        give(lesson, "hole", hole);
        give(lesson, "hill", viz::Figure());
        CHECK_THROWS_WITH(complete(lesson), lodtest::contains("the picture 'hole' says 0.50"));
    }
}

TEST_CASE("every lesson asks, foresees mistakes, and grades its own answers as right",
          "[lessons]") {
    std::size_t questions = 0;
    for (const Entry& entry : list()) {
        const Lesson lesson = run(entry.number);
        INFO(entry.slug);
        std::size_t asked = 0;
        for (const Step& step : lesson.steps)
            for (const Question& question : step.questions) {
                INFO(question.name);
                ++asked;
                CHECK(grade(question, question.answer).grade == Grade::right);
                if (!question.picks.empty()) check_mistakes_in_picks(question);
                for (const Mistake& mistake : question.mistakes) {
                    if (mistake.kind != Mistake::Kind::value) continue;
                    const Graded graded = grade(question, std::to_string(mistake.value));
                    CHECK(graded.grade == Grade::foreseen);
                    CHECK(graded.reply == mistake.reply);
                }
            }
        CHECK(asked >= 5);
        CHECK(lesson.steps.back().questions.empty());
        questions += asked;
    }
    CHECK(questions >= 40);
}
