#include "lessons/embed/markdown.hpp"
#include "lessons/embed/script.hpp"
#include "lessons/embed/source.hpp"
#include "lessons/engine/embedded.hpp"
#include "lessons/engine/lessons.hpp"
#include "lessons/engine/plain.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"

using namespace lessons;

namespace {

/// What an error says, or "" when there is none.
template <class Action>
std::string complaint(Action action) {
    try {
        action();
    } catch (const lod::Error& error) {
        return error.what();
    }
    return {};
}

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Of the text and of its steps.
std::vector<Equation> equations_of(const std::string& markdown) {
    const Script script = read_script(markdown, "lesson.md");
    std::vector<Equation> equations = find_equations(script.text);
    for (const StepScript& step : script.steps)
        for (const Equation& equation : find_equations(step.text)) equations.push_back(equation);
    return equations;
}

constexpr const char* small_text =
    "# Small\n\nIt is {{number: depth}}.\n\n"
    "### Step: One\n\nFirst {{number: depth}}, then {{number: depth | 2 digits, no unit}}.\n\n"
    "{{figure: hole}}\ntitle: A hole of {{number: depth}}\nalt: A hole in\nthe ground.\n\n"
    "{{shown: how deep = depth}}\n\n## After\n\nThe end.\n";

Lesson small_lesson(const std::string& text = small_text) {
    Lesson lesson;
    lesson.entry = {9, "small", "Small"};
    lesson.script = read_script(text, "small/lesson.md");
    give(lesson, "depth", number(0.5, 1, "m"));
    give(lesson, "hole", viz::Figure());
    return lesson;
}

Lesson completed(Lesson lesson) {
    complete(lesson);
    return lesson;
}

/// The small lesson's text with a part of it replaced.
std::string with(const std::string& part, const std::string& other) {
    std::string text = small_text;
    return text.replace(text.find(part), part.size(), other);
}

std::string complaint_of(const std::string& text) {
    return complaint([&] { (void)completed(small_lesson(text)); });
}

}  // namespace

TEST_CASE("a step's words, numbers and figure come from its section", "[lessons]") {
    const Lesson lesson = completed(small_lesson());
    CHECK(says(lesson.text, "It is 0.5\u00a0m."));
    CHECK(says(lesson.text, "{{steps}}"));
    CHECK_FALSE(says(lesson.text, "First"));
    CHECK(says(lesson.text, "## After\n\nThe end."));
    REQUIRE(lesson.steps.size() == 1);
    CHECK(lesson.steps[0].title == "One");
    CHECK(lesson.steps[0].text == "First 0.5\u00a0m, then 0.50.");
    CHECK(lesson.steps[0].figure == "hole");
    REQUIRE(lesson.steps[0].numbers.size() == 1);
    CHECK(lesson.steps[0].numbers[0].told == "how deep");
    CHECK(lesson.steps[0].numbers[0].text == "0.5\u00a0m");
    CHECK(lesson.figures.at("hole").title == "A hole of 0.5\u00a0m");
    CHECK(lesson.figures.at("hole").alt == "A hole in the ground.");
}

TEST_CASE("what the code does not give is refused with the line of its tag", "[lessons]") {
    CHECK(says(complaint_of(with("It is {{number: depth}}", "It is {{number: width}}")),
               "small/lesson.md:3: no number 'width'; the lesson's code gives: depth"));
    CHECK(says(complaint_of(with("First {{number: depth}}", "First {{number: width}}")),
               "small/lesson.md:7: no number 'width'"));
    CHECK(says(complaint_of(with("hole of {{number: depth}}", "hole of {{number: width}}")),
               "small/lesson.md:10: no number 'width'"));
    CHECK(says(complaint_of(with("how deep = depth", "how deep = width")),
               "small/lesson.md:14: no number 'width'"));
    CHECK(says(complaint_of(with("{{figure: hole}}", "{{figure: hill}}")),
               "small/lesson.md:9: no figure 'hill'"));
    CHECK(says(complaint_of(with("The end.", "{{listing: loop}}")),
               "small/lesson.md:18: no listing 'loop'"));
    CHECK(says(complaint_of(with("The end.", "{{video}}")), "small/lesson.md:18:"));
}

TEST_CASE("a number or figure that no text uses is refused with the line of the code",
          "[lessons]") {
    for (const std::string kind : {"number", "figure"}) {
        Lesson lesson = small_lesson();
        if (kind == "number")
            give(lesson, "width", count(3));
        else
            give(lesson, "width", viz::Figure());
        const std::string why = complaint([&] { complete(lesson); });
        CHECK(says(why, "mechanism.cpp:"));
        CHECK(says(why, "no text of small/lesson.md uses the " + kind + " width"));
    }
}

TEST_CASE("a name that is given twice is refused", "[lessons]") {
    Lesson lesson = small_lesson();
    CHECK(says(complaint([&] { give(lesson, "depth", count(1)); }), "'depth' is given already"));
}

TEST_CASE("a figure without title or alt text, or with other words, is refused", "[lessons]") {
    CHECK(says(complaint_of(with("title: A hole of {{number: depth}}\n", "")),
               "small/lesson.md:9: figure 'hole' has no title"));
    CHECK(says(complaint_of(with("alt: A hole in\nthe ground.\n", "")),
               "small/lesson.md:9: figure 'hole' has no alt text"));
    CHECK(says(complaint_of(with("alt: ", "caption: ")),
               "small/lesson.md:11: a figure has no 'caption'"));
    CHECK(
        says(complaint_of(with("alt: ", "title: ")), "small/lesson.md:11: 'title' is said twice"));
}

TEST_CASE("a step without title, text or figure, or after a heading, is refused", "[lessons]") {
    const std::string second = "\n### Step: Two\n\nText.\n\n{{figure: hole}}\n";
    CHECK(complaint_of(with("\n## After", second + "\n## After")).empty());
    CHECK(
        says(complaint_of(with("The end.\n", second)), "small/lesson.md:19: the steps stand one"));
    CHECK(
        says(complaint_of(with("Step: One", "Step:")), "small/lesson.md:5: a step needs a title"));
    CHECK(says(complaint_of(with("{{figure: hole}}", "")), "small/lesson.md:5: step 'One' has no"));
    CHECK(says(complaint_of(with("\n## After", "\n### Step: Two\n\n{{figure: hole}}\n\n## After")),
               "small/lesson.md:16: step 'Two' has no text"));
    CHECK(says(complaint_of(with("First", "First {{figure: hole}}")),
               "small/lesson.md:7: a figure stands on a line of its own"));
    CHECK(says(complaint_of(with("The end.", "{{steps}}")),
               "small/lesson.md:18: steps are sections"));
    CHECK(says(complaint_of(with("The end.", "{{shown: depth = depth}}")), "small/lesson.md:18:"));
}

TEST_CASE("a number takes the format that its tag asks for", "[lessons]") {
    const auto in = [](const Number& number, const std::string& format) {
        return in_format(number, read_format(format));
    };
    CHECK(in(number(1.2345, 3, "m"), "1 digit") == "1.2\u00a0m");
    CHECK(in(number(1.2345, 3, "m"), "0 digits, no unit") == "1");
    CHECK(in(number(1.2345, 2, "m"), "no unit") == "1.23");
    CHECK(in(count(12345, "pairs"), "no unit") == "12\u202f345");
    CHECK(says(complaint_of(with("2 digits, no unit", "in feet")),
               "small/lesson.md:7: unknown format 'in feet'"));
}

TEST_CASE("words that the code gives take no format", "[lessons]") {
    Lesson lesson = small_lesson(with("The end", "{{number: verdict | 2 digits}}"));
    give(lesson, "verdict", words("apart"));
    CHECK(says(complaint([&] { complete(lesson); }), "small/lesson.md:18: 'verdict' is words"));
}

TEST_CASE("the video's words are there to be asked for, and all of them are", "[lessons]") {
    const auto filmed = [](const std::string& below) {
        Lesson lesson = small_lesson(with("The end.", "{{video}}\n" + below));
        lesson.animation.shots.push_back({[] { return viz::Figure(); }, 1});
        return lesson;
    };
    Lesson lesson = filmed("title: A film of {{number: depth}}\nmeet: They meet");
    CHECK(video_words(lesson, "meet") == "They meet");
    complete(lesson);
    CHECK(lesson.animation.title == "A film of 0.5\u00a0m");
    CHECK(says(complaint([&] { (void)video_words(lesson, "part"); }), "no video's words 'part'"));
    CHECK(says(complaint([&] { (void)completed(filmed("title: A film\nmeet: They meet")); }),
               "small/lesson.md:20: the lesson's code asks for no words 'meet'"));
}

TEST_CASE("a live part has a title, a task and controls, and a scene of the code", "[lessons]") {
    const auto playable = [](const std::string& below, bool with_scene = true) {
        Lesson lesson = small_lesson(with("The end.", "{{live}}\n" + below));
        if (with_scene) give(lesson, live::Scene());
        return lesson;
    };
    const std::string title = "title: Play\n";
    const std::string task = "try: Move it by {{number: depth}}.\n";
    const Lesson lesson = completed(playable(title + task + "controls: level, policy trade"));
    REQUIRE(lesson.live);
    CHECK(lesson.live->title == "Play");
    CHECK(lesson.live->task == "Move it by 0.5\u00a0m.");
    CHECK(lesson.live->controls == "level, policy trade");
    CHECK(lesson.live->scene.name == "small");
    CHECK(says(text_for_terminal(lesson, lesson.text, 80, false),
               "lodlab page lesson:small --out small.html"));
    CHECK(says(complaint([&] { (void)completed(playable(title + task)); }),
               "small/lesson.md:18: the live part has no controls"));
    CHECK(says(complaint([&] { (void)completed(playable(title + task + "controls: levl")); }),
               "small/lesson.md:21: no control 'levl'"));
    CHECK(says(
        complaint([&] { (void)completed(playable(title + task + "controls: level\nalt: None")); }),
        "small/lesson.md:22: a live part has no 'alt'"));
    CHECK(says(complaint([&] { (void)completed(playable(title, false)); }),
               "small/lesson.md:18: the lesson's code gives no scene"));
    Lesson vain = small_lesson();
    give(vain, live::Scene());
    CHECK(says(complaint([&] { complete(vain); }), "uses the live part"));
    CHECK(says(complaint_of(with("The end.", "{{live}}\n\n{{live}}")), "a live part already"));
}

TEST_CASE("tags are found in order with their names", "[lessons]") {
    const auto tags =
        find_tags("a {{number: depth}} b\n{{ steps }}\n{{listing: core/x.hpp f}}", "t");
    REQUIRE(tags.size() == 3);
    CHECK(tags[0].kind == "number");
    CHECK(tags[0].name == "depth");
    CHECK(tags[0].begin == 2);
    CHECK(tags[0].end == 19);
    CHECK(tags[1].kind == "steps");
    CHECK(tags[2].name == "core/x.hpp f");
}

TEST_CASE("a tag of an unknown kind is refused with its line", "[lessons]") {
    const std::string why =
        complaint([] { (void)find_tags("one\ntwo {{picture: x}}", "text.md"); });
    CHECK(says(why, "text.md:2"));
    CHECK(says(why, "picture"));
}

TEST_CASE("another lesson is told by its number, and one that is not there with its line",
          "[lessons]") {
    const auto with_text = [](const std::string& text) {
        Lesson lesson;
        lesson.script = read_script("# Title\n\n" + text + "\n", "lesson.md");
        complete(lesson);
        return lesson.text;
    };
    const std::string number = std::to_string(find_lesson("traversal")->number);
    CHECK(says(with_text("As in {{lesson: traversal}}, it goes down."),
               "As in lesson " + number + ", it"));
    const std::string why = complaint([&] { (void)with_text("As in {{lesson: nowhere}}."); });
    CHECK(says(why, "lesson.md:3: no lesson 'nowhere'; there are: distance_test, "));
}

TEST_CASE("a tag that is not closed or lacks its name is refused", "[lessons]") {
    CHECK(says(complaint([] { (void)find_tags("{{figure: x", "t"); }), "not closed"));
    CHECK(says(complaint([] { (void)find_tags("{{figure}}", "t"); }), "needs a name"));
    CHECK(says(complaint([] { (void)find_tags("{{steps: x}}", "t"); }), "takes no name"));
}

TEST_CASE("a listing is the lines between its markers, without shared indentation", "[lessons]") {
    const auto listings = find_listings(
        "int a;\n    // listing: two lines\n    int b;\n      int c;\n    // end of listing\nint "
        "d;\n",
        "x.cpp");
    REQUIRE(listings.size() == 1);
    CHECK(listings.at("two lines") == "int b;\n  int c;\n");
}

TEST_CASE("listing markers that do not match are refused with their line", "[lessons]") {
    const auto why = [](const std::string& code) {
        return complaint([&] { (void)find_listings(code, "x.cpp"); });
    };
    CHECK(says(why("// listing: a\nint b;\n"), "not closed"));
    CHECK(says(why("\n// end of listing\n"), "x.cpp:2"));
    CHECK(says(why("// listing: a\n// listing: b\n// end of listing\n"), "still open"));
    CHECK(
        says(why("// listing: a\n// end of listing\n// listing: a\n// end of listing\n"), "twice"));
    CHECK(says(why("// listing:\n// end of listing\n"), "needs a name"));
}

TEST_CASE("a definition is found with its comment and template line, past its declaration",
          "[lessons]") {
    const std::string code =
        "int twice(int);\n\n/// Doubles x.\ntemplate <int N>\nint twice(int x) {\n    if (x) { }\n"
        "    return 2 * x;\n}\n\nint other() { return twice(1); }\n";
    CHECK(find_definition(code, "twice", "x.hpp") ==
          "/// Doubles x.\ntemplate <int N>\nint twice(int x) {\n    if (x) { }\n    return 2 * "
          "x;\n}\n");
    CHECK(says(complaint([&] { (void)find_definition(code, "thrice", "x.hpp"); }), "thrice"));
}

TEST_CASE("equations are found, and shown as the MathML that they were converted to", "[lessons]") {
    const std::string text = "With $a < b$ we have\n\n$$ \\frac{a}{b} $$\n";
    const auto equations = find_equations(text);
    REQUIRE(equations.size() == 2);
    CHECK(equations[0].key() == "$a < b$");
    CHECK(equations[1].display);
    const std::string html = markdown_to_html(
        text, {{equations[0].key(), "<math>1</math>"}, {equations[1].key(), "<math>2</math>"}});
    CHECK(says(html, "With <math>1</math> we have"));
    CHECK(says(html, "<math>2</math>"));
    CHECK(says(complaint([&] { (void)markdown_to_html(text, {}); }), "$a < b$"));
}

TEST_CASE("the empty corner of a table is no heading", "[lessons]") {
    const std::string html = markdown_to_html("| | plane |\n|---|---|\n| **a** | |\n", {});
    CHECK(says(html, "<td></td>\n<th>plane</th>"));
    CHECK_FALSE(says(html, "<th></th>"));
}

TEST_CASE("every equation of every lesson was converted when the library was built", "[lessons]") {
    for (const EmbeddedLesson& lesson : embedded_lessons())
        for (const Equation& equation : equations_of(lesson.source.markdown)) {
            INFO(equation.key());
            REQUIRE(lesson.source.equations.count(equation.key()) == 1);
            CHECK(says(lesson.source.equations.at(equation.key()), "<math"));
        }
}

TEST_CASE("text for a terminal is wrapped by characters and loses its marks", "[lessons]") {
    CHECK(wrapped("äöü äöü äöü äöü äöü äöü", 20, false) == "äöü äöü äöü äöü äöü\näöü\n");
    CHECK(wrapped("**Predict:** a *b* c", 40, false) == "Predict: a b c\n");
    CHECK(wrapped("**Predict:** a", 40, true) == "\033[1mPredict:\033[0m a\n");
    CHECK(wrapped("- one\n- two", 40, false) == "- one\n- two\n");
    CHECK(wrapped("so *at any moment*, yes", 40, false) == "so at any moment, yes\n");
    CHECK(wrapped("> **Predict:** a\n> b", 40, false) == "Predict: a b\n");
    CHECK(wrapped("a\n\nb", 40, false) == "a\n\nb\n");
}

TEST_CASE("an equation is shown in a terminal in plain characters", "[lessons]") {
    CHECK(text_for_terminal(Lesson(),
                            "# T\n\nWith $r_a$:\n\n$$ j = -\\frac{(1 + e)\\, v_c}{K} $$\n", 80,
                            false) == "# T\n\nWith r_a:\n\n     j = −((1 + e)  v_c) / K \n");
}
