#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>
#include <map>

#include "lessons/engine/lessons.hpp"
#include "lessons/exercises/compiler_errors.hpp"
#include "lessons/exercises/judge.hpp"
#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"

using exercises::Attempt;
using exercises::Case;
using exercises::Exercise;
using exercises::Numbers;

namespace {

/// As if a student's file had answered so.
template <class Function>
exercises::Judgement judged(const Exercise& exercise, const Function& function) {
    const std::vector<Case> cases = exercises::cases_of(exercise);
    Attempt attempt;
    for (const Case& one : cases) attempt.answers.push_back(function(one.numbers));
    return exercises::judge(exercise, cases, attempt);
}

const Exercise& named(const std::string& name) {
    const Exercise* found = exercises::find_exercise(name);
    REQUIRE(found != nullptr);
    return *found;
}

std::vector<std::string> mistakes_of(const Exercise& exercise, const exercises::Judgement& found) {
    std::vector<std::string> names;
    for (const int mistake : found.mistakes)
        names.push_back(exercise.words.mistakes[static_cast<std::size_t>(mistake)].name);
    return names;
}

}  // namespace

TEST_CASE("every lesson has two exercises at least, and every exercise a lesson") {
    std::map<std::string, int> exercises;
    for (const Exercise& exercise : exercises::all()) ++exercises[exercise.words.lesson];
    for (const lessons::Entry& entry : lessons::list()) {
        CAPTURE(entry.slug);
        CHECK(exercises[entry.slug] >= 2);
    }
    CHECK(exercises.size() == lessons::list().size());
}

TEST_CASE("exercises stand in the order of their lessons") {
    std::vector<int> lessons;
    for (const Exercise& exercise : exercises::all())
        lessons.push_back(lessons::find_lesson(exercise.words.lesson).value().number);
    CHECK(std::is_sorted(lessons.begin(), lessons.end()));
}

TEST_CASE("every exercise has three hints and foresees six mistakes at least") {
    for (const Exercise& exercise : exercises::all()) {
        CAPTURE(exercise.words.name);
        CHECK(exercise.words.hints.size() >= 3);
        CHECK(exercise.words.mistakes.size() >= 6);
    }
}

TEST_CASE("exercises are numbered from 1 and found by number and by name") {
    int number = 0;
    for (const Exercise& exercise : exercises::all()) {
        CHECK(exercise.number == ++number);
        CHECK(exercises::find_exercise(std::to_string(number)) == &exercise);
        CHECK(exercises::find_exercise(exercise.words.name) == &exercise);
    }
    for (const char* word : {"0", "99", "", "met", "01"})
        CHECK(exercises::find_exercise(word) == nullptr);
}

TEST_CASE("the reference solution of an exercise answers every case as the truth has it") {
    for (const Exercise& exercise : exercises::all()) {
        CAPTURE(exercise.words.name);
        const exercises::Judgement found = judged(exercise, exercise.variants.front().answer);
        CAPTURE(found.verdict, found.lines);
        CHECK(found.passes);
        CHECK(found.lines.empty());
    }
}

TEST_CASE("every foreseen mistake of an exercise gets the reply that names it, and no other") {
    for (const Exercise& exercise : exercises::all())
        for (const exercises::Variant& variant : exercise.variants) {
            if (variant.mistakes.size() != 1) continue;
            const auto& mistake =
                exercise.words.mistakes[static_cast<std::size_t>(variant.mistakes.front())];
            CAPTURE(exercise.words.name, mistake.name);
            const exercises::Judgement found = judged(exercise, variant.answer);
            CAPTURE(found.lines);
            CHECK_FALSE(found.passes);
            CHECK(found.mistakes == variant.mistakes);
            REQUIRE(found.lines.size() == 2);
            CHECK(found.lines.front() == mistake.reply);
        }
}

TEST_CASE(
    "two mistakes at once are named, one where the other cannot be seen, a constant as such") {
    int both = 0;
    int pairs = 0;
    for (const Exercise& exercise : exercises::all())
        for (const exercises::Variant& variant : exercise.variants) {
            if (variant.mistakes.size() != 2) continue;
            CAPTURE(exercise.words.name, variant.mistakes);
            const exercises::Judgement found = judged(exercise, variant.answer);
            ++pairs;
            both += found.mistakes == variant.mistakes;
            if (!found.passes && found.mistakes.empty()) {
                REQUIRE(!found.lines.empty());
                CHECK(found.lines.front().starts_with("It answers the same in every case"));
            }
            if (found.mistakes.size() == 1) {
                // What it is taken for answers the same in every case.
                const auto taken = std::find_if(exercise.variants.begin(), exercise.variants.end(),
                                                [&](const exercises::Variant& other) {
                                                    return other.mistakes == found.mistakes;
                                                });
                for (const Case& one : exercises::cases_of(exercise))
                    CHECK(exercises::same_answer(taken->answer(one.numbers),
                                                 variant.answer(one.numbers)));
            }
        }
    CHECK(both > pairs * 3 / 4);
}

TEST_CASE("a function that always gives one answer is told so, and no mistake is put upon it") {
    const exercises::Judgement found =
        judged(named("meet"), [](const Numbers&) { return Numbers{0}; });
    CHECK(found.mistakes.empty());
    REQUIRE(found.lines.size() == 2);
    CHECK(found.lines.front() == "It answers the same in every case: no.");
}

TEST_CASE("what a starter answers is no mistake, in any exercise") {
    for (const Exercise& exercise : exercises::all()) {
        CAPTURE(exercise.words.name);
        const Numbers none(exercise.task.truth(exercises::cases_of(exercise)[0].numbers).size(),
                           0.0);
        const exercises::Judgement found = judged(exercise, [&](const Numbers&) { return none; });
        CHECK_FALSE(found.passes);
        CHECK(found.mistakes.empty());
    }
}

TEST_CASE("a mistake is recognised although another one, unforeseen, stands beside it") {
    const Exercise& exercise = named("impulse");
    const exercises::Variant& no_gate = *std::find_if(
        exercise.variants.begin(), exercise.variants.end(), [&](const exercises::Variant& variant) {
            return variant.mistakes.size() == 1 &&
                   exercise.words.mistakes[static_cast<std::size_t>(variant.mistakes[0])].name ==
                       "no_gate";
        });
    const exercises::Judgement found = judged(exercise, [&](const Numbers& asked) {
        const Numbers answer = no_gate.answer(asked);
        return answer[0] > 3 ? Numbers{3} : answer;  // nobody foresaw a largest impulse
    });
    CHECK(mistakes_of(exercise, found) == std::vector<std::string>{"no_gate"});
}

TEST_CASE("a number that is none is said to be none where no mistake explains it") {
    const exercises::Judgement found = judged(named("contact_point"), [](const Numbers& asked) {
        return asked[0] == 0 ? Numbers{std::nan(""), 0} : Numbers{asked[0], asked[1]};
    });
    CHECK(found.mistakes.empty());
    CHECK(found.lines.front().starts_with("nan is no number"));
    CHECK(found.lines.back().find("(nan, 0)") != std::string::npos);
}

TEST_CASE("cases are the same every time, and those of a seed have its number") {
    for (const Exercise& exercise : exercises::all()) {
        const std::vector<Case> cases = exercises::cases_of(exercise);
        const std::vector<Case> again = exercises::cases_of(exercise);
        const auto edges = static_cast<std::size_t>(std::count_if(
            cases.begin(), cases.end(), [](const Case& one) { return one.seed == 0; }));
        CAPTURE(exercise.words.name);
        CHECK(edges >= 5);
        REQUIRE(cases.size() == edges + exercises::random_seeds * exercises::cases_of_a_seed);
        for (std::size_t i = 0; i < cases.size(); ++i) CHECK(cases[i].numbers == again[i].numbers);
        CHECK(cases.back().seed == 100);
    }
}

TEST_CASE("a case is told by the numbers that it is made of") {
    CHECK(exercises::told("at ({}, {}), {yes}, {yes}", {1, -2.5, 1, 0}) == "at (1, -2.5), yes, no");
    CHECK(exercises::told("{list ({}, {})}; {}", {2, 1, 2, 3, 4, 5}) == "(1, 2), (3, 4); 5");
    CHECK(exercises::told("{count {}} of {list {}}", {2, 7, 8, 0}) == "2 of none");
    CHECK(exercises::told("{skip 2}{}", {1, 2, 3}) == "3");
    CHECK(exercises::told("{list {list {}}}", {2, 1, 5, 2, 6, 7}) == "5, 6, 7");
    CHECK(exercises::told("{}, {}", {std::nan("")}) == "nan, nan");
    CHECK(exercises::told("{list {}}", {8, 1, 2, 3, 4, 5, 6, 7, 8}) == "1, 2, 3, 4, 5, 6, ...");
}

TEST_CASE("the words of an exercise that are not whole are refused with their line") {
    const auto refused = [](const std::string& text, const std::string& part) {
        try {
            static_cast<void>(exercises::read_words("meet", text));
            FAIL("not refused");
        } catch (const lod::Error& error) {
            CAPTURE(error.what());
            CHECK(std::string(error.what()).find(part) != std::string::npos);
        }
    };
    const std::string head = "# T\nlesson: l\ncase: {}\nanswer: {}\n\nDo it.\n\n";
    const std::string code =
        "## Code\n```cpp\nint meet(int a) {\n//[ return 0;\n    return a;\n//! one|    return 1;\n"
        "//]\n}\n```\n";
    const std::string hints = "## Hints\n- Think.\n";
    const std::string mistakes = "## Mistakes\n- one: It is always one.\n";
    CHECK(exercises::read_words("meet", head + code + hints + mistakes).mistakes.size() == 1);
    refused(head + code + mistakes, "a hint");
    refused(head + code + hints, "no reply names the mistake one");
    refused(head + code + hints + mistakes + "- two: No.\n",
            "no line of the code has the mistake two");
    refused(head + hints + mistakes, "a gap");
    refused(code + hints + mistakes, "a title");
    refused(head + code + hints + "## Mistakes\n- It is wrong.\n", "meet.md:20: a mistake is NAME");
}

TEST_CASE("of a compiler's errors a student reads her own, three at most") {
    const exercises::Words& words = named("meet").words;
    const auto lines = [&](std::string_view output) {
        return exercises::compiler_errors(output, words);
    };
    CHECK(lines("In file included from /tmp/x/asking.cpp:2:\n"
                "/tmp/x/meet.cpp: In function 'bool meet(int)':\n"
                "/tmp/x/meet.cpp:9:5: error: 'foo' was not declared in this scope\n"
                "    9 |     foo\n      |     ^~~\n") ==
          std::vector<std::string>{"meet.cpp:9:5: error: 'foo' was not declared in this scope"});
    std::string many;
    for (int line = 1; line < 9; ++line)
        many += "meet.cpp:" + std::to_string(line) + ":1: error: no\n";
    CHECK(lines(many).size() == 3);
    CHECK(lines("/tmp/x/asking.cpp:4:9: error: 'meet' was not declared in this scope\n").front() ==
          "the function must stay as it was: bool meet(const lod::Sphere<2>& a, const "
          "lod::Sphere<2>& b)");
    CHECK(lines("/usr/bin/ld: /tmp/cc.o: in function `meet(lod::Sphere<2>)':\n"
                "asking.cpp:(.text+0x12): undefined reference to `lod::area(lod::Sphere<2>)'\n"
                "collect2: error: ld returned 1 exit status\n")
              .front()
              .starts_with("lod::area(lod::Sphere<2>) is neither in the file"));
    CHECK(lines("/inc/lodlab/linear.hpp:80:3: error: static assertion failed\n"
                "/tmp/x/meet.cpp:7:20:   required from here\n")
              .front() == "meet.cpp:7:20: error: static assertion failed");
    CHECK(lines("") == std::vector<std::string>{"the compiler said nothing"});
}

TEST_CASE("how a program ended without an answer is said, with the case that it was asked then") {
    const Exercise& exercise = named("meet");
    const std::vector<Case> cases = exercises::cases_of(exercise);
    const auto ended = [&](Attempt::End end, int signal, std::vector<std::string> printed) {
        Attempt attempt;
        attempt.end = end;
        attempt.signal = signal;
        attempt.lines = std::move(printed);
        attempt.answers = {{1}};
        const exercises::Judgement found = exercises::judge(exercise, cases, attempt);
        CHECK_FALSE(found.passes);
        CHECK(found.lines.front().find("(0, 0) of radius 2 and at (5.25, 0)") != std::string::npos);
        return found.verdict;
    };
    using End = Attempt::End;
    CHECK(ended(End::crashed, SIGSEGV, {})
              .starts_with("it crashed, signal 11 (Segmentation fault): "
                           "it reads or writes memory that is not"));
    CHECK(ended(End::crashed, SIGFPE, {}).find("a whole number is divided by zero") !=
          std::string::npos);
    CHECK(ended(End::crashed, SIGXFSZ, {}).find("it prints without end") != std::string::npos);
    CHECK(ended(End::crashed, SIGABRT, {"asked", "x.cpp:3: Assertion `r > 0' failed."}) ==
          "it crashed, signal 6 (Aborted): Assertion `r > 0' failed.");
    CHECK(ended(End::left, 0, {}).starts_with("it ended the program"));
    CHECK(ended(End::endless, 0, {}).find("no answer") != std::string::npos);
    CHECK(ended(End::threw, 0, {"std::bad_alloc"}) == "it threw an exception: std::bad_alloc");
}

TEST_CASE("no number is infinite by rounding") {
    const double infinite = std::numeric_limits<double>::infinity();
    CHECK(exercises::same_answer({1, 2}, {1 + 1e-12, 2}));
    CHECK(exercises::same_answer({infinite}, {infinite}));
    CHECK_FALSE(exercises::same_answer({infinite}, {0}));
    CHECK_FALSE(exercises::same_answer({infinite}, {-infinite}));
    CHECK_FALSE(exercises::same_answer({1, 2}, {1}));
    CHECK_FALSE(exercises::same_answer({1}, {std::nan("")}));
    CHECK_FALSE(exercises::same_answer({1}, {1 + 1e-8}));
}
