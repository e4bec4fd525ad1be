#include <algorithm>
#include <csignal>
#include <fstream>

#include "tests/catch.hpp"
#include "tests/cli/keys.hpp"

namespace {

Outcome exercise(const Scratch& scratch, std::vector<std::string> words) {
    words.insert(words.begin(), "exercise");
    Start start;
    start.folder = scratch.path();
    return lodlab(words, start);
}

std::string read(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::string& path, const std::string& text) {
    std::ofstream(path) << text;
}

/// The student's file fails: one line says so, and the output why.
void check_fails(const Outcome& outcome, const std::string& verdict, const std::string& why) {
    INFO(outcome.out << outcome.err);
    CHECK(outcome.code == 3);
    CHECK(is_one_line(outcome.err));
    CHECK(contains(outcome.err, "exercises/meet.cpp: " + verdict));
    CHECK(contains(outcome.out, why));
    CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') <= 3);
}

}  // namespace

TEST_CASE("an exercise is begun, fails, passes, and the list knows") {
    const Scratch scratch;
    const std::string file = scratch / "exercises/meet.cpp";
    const Outcome list = exercise(scratch, {});
    CHECK(list.code == 0);
    CHECK(list.out.starts_with("Lesson 1: "));
    CHECK(contains(list.out, "   1  meet "));
    CHECK(contains(list.out, " cost_of_next_level  What "));  // the longest name
    CHECK_FALSE(contains(list.out, "fails"));
    CHECK(scratch.files().empty());

    const Outcome begun = exercise(scratch, {"1"});
    CHECK(begun.code == 0);
    CHECK(contains(begun.out, "Wrote exercises/meet.cpp"));
    const std::string starter = read(file);
    CHECK(contains(starter, "// Exercise 1: "));
    check_fails(exercise(scratch, {"meet"}), "it is as it was begun",
                "Complete the function meet in this file: bool meet(");
    write(file, starter + "\n");
    check_fails(exercise(scratch, {"meet"}), "", "It answers the same in every case: no.");
    CHECK(read(file) == starter + "\n");
    CHECK(contains(exercise(scratch, {}).out, " fails\n"));

    write(file, exercise(scratch, {"meet", "--solution"}).out);
    const Outcome passed = exercise(scratch, {"meet"});
    CHECK(passed.code == 0);
    CHECK(passed.err.empty());
    CHECK(contains(passed.out, "exercises/meet.cpp passes: it answers all 412 cases"));
    CHECK(contains(passed.out, "Next: lodlab exercise surely_apart"));
    const Json listed = Json::parse(exercise(scratch, {"--json"}).out);
    check_keys("exercise", listed);
    const Json states = listed["exercises"];
    CHECK(states[0]["state"] == "passes");
    CHECK(states[1]["state"] == "not begun");
    CHECK(exercise(scratch, {"meet", "--watch"}).code == 0);
}

TEST_CASE("a mistake is named on the terminal and to a program") {
    const Scratch scratch;
    std::filesystem::create_directory(scratch / "exercises");
    std::string code = exercise(scratch, {"meet", "--solution"}).out;
    code.erase(code.find("<=") + 1, 1);
    write(scratch / "exercises/meet.cpp", code);
    check_fails(exercise(scratch, {"meet"}), "", "you compare with < where it must be <=");
    const Outcome outcome = exercise(scratch, {"meet", "--json"});
    CHECK(outcome.code == 3);
    const Json result = Json::parse(outcome.out);
    check_keys("exercise N", result);
    CHECK(result["state"] == "fails");
    CHECK(result["mistakes"] == std::vector<std::string>{"strict"});
    CHECK(result["wrong"] > 0);
}

TEST_CASE("hints come one by one, and a reset keeps the file and begins them anew") {
    const Scratch scratch;
    CHECK(exercise(scratch, {"owner", "--hint"}).out.starts_with("Hint 1 of 3: "));
    CHECK(exercise(scratch, {"owner", "--hint"}).out.starts_with("Hint 2 of 3: "));
    CHECK(contains(exercise(scratch, {"owner", "--hint"}).out, "owner --solution"));
    CHECK(exercise(scratch, {"owner", "--hint"}).out.starts_with("Hint 3 of 3: "));
    CHECK(exercise(scratch, {"owner"}).code == 0);
    write(scratch / "exercises/owner.cpp", "// mine\n");
    CHECK(contains(exercise(scratch, {"owner", "--reset"}).out, "exercises/owner.cpp.backup-1"));
    CHECK(read(scratch / "exercises/owner.cpp.backup-1") == "// mine\n");
    CHECK(exercise(scratch, {"owner", "--hint"}).out.starts_with("Hint 1 of 3: "));
}

TEST_CASE("an exercise that is asked for in a wrong way is a misuse") {
    const Scratch scratch;
    const auto count = Json::parse(exercise(scratch, {"--json"}).out)["exercises"].size();
    check_failure(
        exercise(scratch, {"met"}), 2,
        "no exercise met (did you mean meet?); there are 1 to " + std::to_string(count) + ",");
    const std::string after_last = std::to_string(count + 1);
    check_failure(exercise(scratch, {after_last}), 2, "no exercise " + after_last);
    check_failure(exercise(scratch, {"0"}), 2, "no exercise 0");
    for (const char* option : {"--hint", "--solution", "--reset", "--watch"}) {
        check_failure(exercise(scratch, {option}), 2, "name one, as in lodlab exercise 1");
        check_failure(exercise(scratch, {"meet", option, "--json"}), 2, "drop --json");
    }
    check_failure(exercise(scratch, {"meet", "--hint", "--solution"}), 2, "drop --solution");
    CHECK(scratch.files().empty());
}

TEST_CASE("without a compiler an exercise is begun, and its check names the package") {
    const Scratch scratch;
    REQUIRE(exercise(scratch, {"meet"}).code == 0);
    write(scratch / "exercises/meet.cpp", "// mine\n");
    Start start;
    start.folder = scratch.path();
    start.environment = {"PATH=" + scratch.path().string()};
    check_failure(lodlab({"exercise", "meet"}, start), 6,
                  "no program c++ in $PATH; sudo apt-get install -y g++");
    start.environment = {"PATH=/usr/bin:/bin", "CXX=/no/such/compiler"};
    check_failure(lodlab({"exercise", "meet"}, start), 6, "/no/such/compiler");
    start.environment = {"PATH=/usr/bin:/bin", "TMPDIR=" + (scratch / "gone")};
    check_failure(lodlab({"exercise", "meet"}, start), 4, "set TMPDIR");
}

TEST_CASE("a folder in which no exercise can be written is said to be so") {
    const Scratch scratch;
    write(scratch / "exercises", "a file\n");
    for (const char* option : {"--hint", "--reset"})
        check_failure(exercise(scratch, {"meet", option}), 4, "exercises");
    check_failure(exercise(scratch, {"meet"}), 4, "go into a folder of your own");
    Start start;
    start.folder = "/proc";
    check_failure(lodlab({"exercise", "meet"}, start), 4, "exercises: this folder cannot be made");
    const Scratch other;
    std::filesystem::create_directories(other / "exercises/meet.cpp");
    check_failure(exercise(other, {"meet"}), 3, "meet.cpp");
}

TEST_CASE(
    "a file that does not compile, an endless loop and a number that is none each have their "
    "line") {
    const Scratch scratch;
    std::filesystem::create_directory(scratch / "exercises");
    const std::string file = scratch / "exercises/meet.cpp";
    const std::string head =
        "#include <lodlab/core/math/sphere.hpp>\n"
        "bool meet(const lod::Sphere<2>& a, const lod::Sphere<2>& b) {\n";
    write(file, head + "    return a.radius + b.radios > 1;\n}\n");
    check_fails(exercise(scratch, {"meet"}), "it does not compile", "meet.cpp:3:25: error: ");
    write(file, head + "    while (a.radius >= 0) {}\n    return b.radius > 1;\n}\n");
    check_fails(exercise(scratch, {"meet"}), "it gives no answer within 2 s",
                "It was asked: circles");
    write(scratch / "exercises/contact_point.cpp",
          "#include <lodlab/core/math/sphere.hpp>\n"
          "lod::Vector<2> contact_point(const lod::Sphere<2>& a, const lod::Sphere<2>& b) {\n"
          "    const lod::Vector<2> line = b.centre - a.centre;\n"
          "    const lod::Vector<2> n = line / line.norm();\n"
          "    return a.centre + a.radius / (a.radius + b.radius) * line.norm() * n;\n}\n");
    const Outcome none = exercise(scratch, {"contact_point"});
    CHECK(none.code == 3);
    CHECK(contains(none.out, "divided by its length, 0/0"));
    CHECK(contains(none.out, "Answered: (nan, nan)"));
}

TEST_CASE("Ctrl-C ends a watch, and nothing but the student's file is left") {
    const Scratch scratch;
    Start start;
    start.folder = scratch.path();
    start.signal = SIGINT;
    start.when_exists = scratch / "exercises/meet.cpp";
    const Outcome outcome = lodlab({"exercise", "meet", "--watch"}, start);
    CHECK(outcome.code == 130);
    CHECK(contains(outcome.out, "Wrote exercises/meet.cpp"));
    CHECK(std::filesystem::exists(scratch / "exercises/meet.cpp"));
}
