#include "lessons/embed/markdown.hpp"
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

Lesson small_lesson() {
    Lesson lesson;
    lesson.entry = {9, "small", "Small"};
    lesson.markdown = "# Small\n\nIt is {{number: depth}}.\n";
    lesson.numbers["depth"] = {0.5, "0.5 m"};
    return lesson;
}

}  // namespace

TEST_CASE("a step's text holds the lesson's numbers, and shows them under names of its own",
          "[lessons]") {
    Lesson lesson = small_lesson();
    viz::Figure figure;
    figure.title = "A picture";
    add_step(lesson, "Title", "First {{number: depth}}, then {{number: depth}}.", figure,
             {{"how deep", "depth"}}, "kept");
    REQUIRE(lesson.steps.size() == 1);
    CHECK(lesson.steps[0].text == "First 0.5 m, then 0.5 m.");
    CHECK(lesson.steps[0].numbers.at("how deep").value == 0.5);
    CHECK(lesson.figures.at("kept").title == "A picture");
}

TEST_CASE("a step that names what the lesson does not have is refused", "[lessons]") {
    Lesson lesson = small_lesson();
    const std::string in_text =
        complaint([&] { add_step(lesson, "Title", "It is {{number: width}}.", {}); });
    CHECK(says(in_text, "width"));
    CHECK(says(in_text, "small, step 'Title'"));
    CHECK(says(complaint([&] { add_step(lesson, "T", "It.", {}, {{"w", "width"}}); }), "width"));
    CHECK(says(complaint([&] { add_step(lesson, "T", "{{figure: depth}}", {}); }), "figure"));
    CHECK(lesson.steps.empty());
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

TEST_CASE("a tag that is not closed or lacks its name is refused", "[lessons]") {
    CHECK(says(complaint([] { (void)find_tags("{{figure: x", "t"); }), "not closed"));
    CHECK(says(complaint([] { (void)find_tags("{{figure}}", "t"); }), "needs a name"));
    CHECK(says(complaint([] { (void)find_tags("{{steps: x}}", "t"); }), "takes no name"));
}

TEST_CASE("a text that names an unknown number, figure or listing is refused", "[lessons]") {
    Lesson lesson = small_lesson();
    CHECK(complaint([&] { check_lesson(lesson); }).empty());
    for (const std::string kind : {"number", "figure", "listing"}) {
        lesson = small_lesson();
        lesson.markdown += "{{" + kind + ": missing}}\n";
        const std::string why = complaint([&] { check_lesson(lesson); });
        CHECK(says(why, "small/lesson.md:4"));
        CHECK(says(why, "no " + kind + " 'missing'"));
    }
}

TEST_CASE("steps or a video that a lesson does not have are refused", "[lessons]") {
    for (const std::string kind : {"steps", "video"}) {
        Lesson lesson = small_lesson();
        lesson.markdown += "{{" + kind + "}}\n";
        CHECK_FALSE(complaint([&] { check_lesson(lesson); }).empty());
    }
}

TEST_CASE("a step without an alt text is refused", "[lessons]") {
    Lesson lesson = small_lesson();
    lesson.steps.push_back({"title", "text", {}, {}});
    CHECK(says(complaint([&] { check_lesson(lesson); }), "alt"));
    lesson.steps[0].figure.alt = "a picture";
    CHECK(complaint([&] { check_lesson(lesson); }).empty());
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

TEST_CASE("every equation of every lesson was converted when the library was built", "[lessons]") {
    for (const EmbeddedLesson& lesson : embedded_lessons())
        for (const Equation& equation : find_equations(lesson.source.markdown)) {
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
    Lesson lesson = small_lesson();
    lesson.markdown = "# T\n\nWith $r_a$:\n\n$$ j = -\\frac{(1 + e)\\, v_c}{K} $$\n";
    CHECK(text_for_terminal(lesson, 80, false) ==
          "# T\n\nWith r_a:\n\n     j = −((1 + e)  v_c) / K \n");
}
