// Questions that are answered in the picture: how they are made, checked and graded.

#include <algorithm>
#include <fstream>
#include <sstream>

#include "lessons/embed/lines.hpp"
#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"

using namespace lessons;

namespace {

std::vector<std::string> cells_of(const std::string& text, char sign) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, sign);) parts.push_back(trimmed(part));
    return parts;
}

Question picks_of_row(const std::vector<std::string>& row) {
    Question question;
    const std::vector<std::string> right = cells_of(row[1], ',');
    for (const std::string& text : cells_of(row[0], ',')) {
        const std::vector<std::string> named = cells_of(text, '=');
        Pick pick;
        pick.name = named[0];
        pick.kind = named.size() > 1 ? named[1] : "";
        pick.right = std::find(right.begin(), right.end(), pick.name) != right.end();
        question.picks.push_back(pick);
    }
    for (const std::string& foreseen : cells_of(row[2], ',')) {
        Mistake mistake;
        mistake.kind = foreseen == "missing" ? Mistake::Kind::missing
                       : foreseen == "more"  ? Mistake::Kind::more
                                             : Mistake::Kind::kind;
        mistake.picked = foreseen;
        mistake.reply = "foreseen " + std::to_string(question.mistakes.size());
        question.mistakes.push_back(mistake);
    }
    return question;
}

std::string word_of(Grade grade) {
    constexpr const char* names[] = {"right", "foreseen", "wrong", "unclear"};
    return names[static_cast<int>(grade)];
}

constexpr const char* with_picks =
    "# Small\n\n### Step: One\n\nFirst.\n\n"
    "{{ask: which}}\nWhich meet?\npick: circles\nreply: These.\n"
    "mistake: far\nreply: That is far away.\nmistake: missing\nreply: There are more.\n"
    "told in: Two\n\n"
    "{{figure: plain}}\ntitle: Circles\nalt: Three circles.\n\n"
    "### Step: Two\n\nTwo do.\n\n{{figure: told}}\ntitle: Two\nalt: Two are bold.\n";

viz::Figure circles(viz::Role first) {
    viz::Panel panel;
    panel.view = box(-2, -2, 8, 8);
    add_ball<2>(panel, {{0, 0}, 1}, style(first, 0));
    add_ball<2>(panel, {{1, 0}, 1}, style(viz::Role::level_node, 1));
    add_ball<2>(panel, {{5, 5}, 1}, style(viz::Role::level_node, 1));
    return figure_of(std::move(panel));
}

Picks three_picks() {
    return {{"1", {0, 0}, 1, true, ""}, {"2", {1, 0}, 1, true, ""}, {"3", {5, 5}, 1, false, "far"}};
}

Lesson lesson_with_picks(const std::string& text, const Picks& picks = three_picks(),
                         viz::Role first = viz::Role::level_node) {
    Lesson lesson;
    lesson.entry = {9, "small", "Small"};
    lesson.script = read_script(text, "small.md");
    give(lesson, "circles", picks);
    give(lesson, "plain", circles(first));
    give(lesson, "told", circles(viz::Role::meeting_node));
    complete(lesson);
    return lesson;
}

std::string with_picks_changed(const std::string& part, const std::string& other) {
    std::string text = with_picks;
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    return text.replace(at, part.size(), other);
}

template <class Make>
void check_picks_refused(const Make& make, const std::string& why) {
    CHECK_THROWS_WITH(static_cast<void>(make()), lodtest::contains(why));
}

}  // namespace

TEST_CASE("picks are graded as the table says", "[lessons]") {
    std::ifstream table(LODLAB_SOURCE_DIR "/tests/lessons/picking.txt");
    int rows = 0;
    for (std::string line; std::getline(table, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::vector<std::string> row = cells_of(line, '|');
        REQUIRE(row.size() == 5);
        ++rows;
        INFO(line);
        const Graded graded = grade(picks_of_row(row), row[3]);
        CHECK((graded.grade == Grade::foreseen ? graded.reply : word_of(graded.grade)) == row[4]);
        CHECK_FALSE(graded.reply.empty());
    }
    CHECK(rows > 20);
}

TEST_CASE("picks of wild bytes are graded without harm", "[lessons]") {
    const Question question = picks_of_row({"1, 2=far", "1", "missing"});
    for (const std::string& wild : {std::string("\xff\xfe"), std::string("\0", 1),
                                    std::string(100000, '1'), std::string("1\x1b[2J")}) {
        const Graded graded = grade(question, wild);
        CHECK(graded.grade == Grade::unclear);
        CHECK(graded.reply.find('\x1b') == std::string::npos);
    }
}

TEST_CASE("a question that is answered in the picture takes its picks from the code", "[lessons]") {
    const Lesson lesson = lesson_with_picks(with_picks);
    const Question& question = lesson.steps[0].questions.at(0);
    REQUIRE(question.picks.size() == 3);
    CHECK(question.answer == "1, 2");
    CHECK(question.reply == "These.");
    CHECK(grade(question, "1 2").reply == "These.");
    CHECK(grade(question, "3").reply == "That is far away.");
    CHECK(grade(question, "1").reply == "There are more.");
}

TEST_CASE("picks that cannot be graded are refused with the line and the mend", "[lessons]") {
    check_picks_refused(
        [] { return lesson_with_picks(with_picks_changed("pick: circles", "pick: discs")); },
        "small.md:9: no picks 'discs'; the lesson's code gives: circles");
    check_picks_refused(
        [] { return lesson_with_picks(with_picks_changed("mistake: far", "mistake: near")); },
        "small.md:11: question 'which' has no wrong pick of the kind 'near'");
    check_picks_refused(
        [] { return lesson_with_picks(with_picks_changed("reply: That is far away.\n", "")); },
        "small.md:11: question 'which' has a mistake without a reply");
    check_picks_refused([] { return lesson_with_picks(with_picks_changed("told in: Two\n", "")); },
                        "question 'which' is answered by no later step");
    check_picks_refused(
        [] {
            return lesson_with_picks(
                with_picks_changed("mistake: far\nreply: That is far away.\nmistake: "
                                   "missing\nreply: There are more.\n",
                                   ""));
        },
        "foresees no mistake");
    check_picks_refused(
        [] {
            Picks picks = three_picks();
            picks[2].right = true;
            return lesson_with_picks(
                with_picks_changed("mistake: far\nreply: That is far away.\n", ""), picks);
        },
        "has nothing to tell apart");
    check_picks_refused(
        [] { return lesson_with_picks(with_picks, three_picks(), viz::Role::meeting_node); },
        "is answered by its picture, which draws 1 as one that meets");
    check_picks_refused(
        [] {
            Lesson lesson = lesson_with_picks(with_picks);
            give(lesson, "circles", three_picks());
            return lesson;
        },
        "'circles' is given already");
}
