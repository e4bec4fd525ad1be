// Students' files, compiled and asked: a few, for each takes a second. bench/lessons/exercises.cpp
// tries every solution and mistake.
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "lessons/exercises/attempt.hpp"
#include "lessons/exercises/judge.hpp"
#include "lessons/exercises/workshop.hpp"
#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"
#include "tests/lessons/scratch.hpp"

using exercises::Attempt;
using exercises::Exercise;
using exercises::Judgement;

namespace {

const Exercise& meet() {
    return *exercises::find_exercise("meet");
}

Judgement judged(const Exercise& exercise, const std::string& code) {
    const std::vector<exercises::Case> cases = exercises::cases_of(exercise);
    return exercises::judge(exercise, cases, exercises::attempt(exercise, code, cases, "."));
}

/// The exercise meet, completed so.
Judgement met(const std::string& body, const std::string& above = "") {
    return judged(meet(), "#include <lodlab/core/math/sphere.hpp>\n" + above +
                              "bool meet(const lod::Sphere<2>& a, const lod::Sphere<2>& b) {\n" +
                              body + "\n}\n");
}

}  // namespace

TEST_CASE("a starter fails when it is compiled and asked, and a solution passes") {
    for (const char* name : {"meet", "next_front"}) {
        const Exercise& exercise = *exercises::find_exercise(name);
        CAPTURE(name);
        const Judgement begun = judged(exercise, exercises::starter_file(exercise));
        CHECK_FALSE(begun.passes);
        CHECK(begun.wrong > 0);
        const Judgement solved = judged(exercise, exercises::code_with(exercise.words, {}));
        CAPTURE(solved.verdict, solved.lines);
        CHECK(solved.passes);
    }
}

TEST_CASE("a mistake is recognised by its answers, however it is written") {
    const Judgement strict =
        met("    const auto d = a.centre - b.centre;\n"
            "    return std::sqrt(d.x() * d.x() + d.y() * d.y()) < a.radius + b.radius;",
            "#include <cmath>\n");
    CHECK(strict.lines.front().starts_with("Circles that touch in one point are called apart"));
    const Exercise& exercise = *exercises::find_exercise("impulse");
    const Judgement pulled = judged(exercise, R"(#include <lodlab/core/contact/contact.hpp>
double impulse(const lod::Body<2>& a, const lod::Body<2>& b, const lod::Contact<2>& c) {
    double push[2], give = 0, close = 0;
    for (const lod::Body<2>* one : {&a, &b}) {
        const double x = c.point.x() - one->position.x(), y = c.point.y() - one->position.y();
        const double turn = x * c.normal.y() - y * c.normal.x();
        give += one->inverse_mass + turn * one->inverse_inertia(0, 0) * turn;
        push[one == &b] = one->velocity.dot(c.normal) + one->spin[0] * turn;
    }
    close = push[1] - push[0];
    const double e = a.restitution < b.restitution ? a.restitution : b.restitution;
    return give == 0 ? 0 : -close * (1 + e) / give;
})");
    CHECK(pulled.lines.front().starts_with("Bodies that part already are pulled back"));
}

TEST_CASE("a student's file may have a main and headers of its own, and may print") {
    const Scratch scratch;
    std::ofstream(scratch.path() / "mine.hpp")
        << "inline double both(double x, double y) { return x + y; }\n";
    const std::vector<exercises::Case> cases = exercises::cases_of(meet());
    const std::string code = R"(#include "mine.hpp"
#include <iostream>
#include <lodlab/core/math/sphere.hpp>
bool meet(const lod::Sphere<2>& a, const lod::Sphere<2>& b) {
    std::cout << "asked\n";
    const double reach = both(a.radius, b.radius);
    return (a.centre - b.centre).squaredNorm() <= reach * reach;
}
int main() { return meet({{0, 0}, 1}, {{1, 0}, 1}); }
)";
    const Attempt made = exercises::attempt(meet(), code, cases, scratch.path());
    CAPTURE(made.lines);
    CHECK(made.end == Attempt::End::answered);
    CHECK(exercises::judge(meet(), cases, made).passes);
}

TEST_CASE("a file that does not compile is told by the student's own lines") {
    const Judgement found = met("    return a.center == b.centre;");
    CHECK(found.verdict == "it does not compile");
    REQUIRE_FALSE(found.lines.empty());
    CHECK(found.lines.front().starts_with("meet.cpp:3:"));
    CHECK(found.lines.front().find("center") != std::string::npos);
    CHECK(met("").verdict == "it does not compile");  // no return
    const Judgement renamed = judged(meet(), "bool touch(int, int) { return true; }\n");
    CHECK(renamed.lines.front().starts_with("the function must stay as it was: bool meet("));
    const Judgement asks = judged(*exercises::find_exercise("impulse"),
                                  "#include <lodlab/core/response/impact.hpp>\n"
                                  "double impulse(const lod::Body<2>& a, const lod::Body<2>& b,\n"
                                  "               const lod::Contact<2>& c) {\n"
                                  "    return lod::single_impulse(a, b, c);\n}\n");
    CHECK(asks.lines.front().find("single_impulse") != std::string::npos);
    CHECK(asks.lines.front().find("write it yourself") != std::string::npos);
}

TEST_CASE("a loop without end, an index beyond the end and an exception are named, with the case") {
    const auto tried = [](const std::string& body, const std::string& above = "") {
        const Judgement found = met(body, above);
        CAPTURE(found.verdict);
        CHECK_FALSE(found.passes);
        REQUIRE(found.lines.size() == 1);
        CHECK(found.lines.front() ==
              "It was asked: circles at (0, 0) of radius 2 and at (3, 4) of radius 3 (an edge "
              "case).");
        return found.verdict;
    };
    CHECK(tried("    for (double x = 1; x > 0; x += b.radius) {}\n    return true;") ==
          "it gives no answer within 2 s; does every loop end?");
    CHECK(tried("    return std::vector<int>()[0] > a.radius;", "#include <vector>\n") ==
          "it crashed, signal 6 (Aborted): an index beyond the end of a list");
    CHECK(tried("    return std::vector<int>().at(3);", "#include <vector>\n")
              .starts_with("it threw an exception: vector::_M_range_check"));
}

TEST_CASE("a student's work is never overwritten, and a reset keeps it") {
    const Scratch scratch;
    exercises::Workshop workshop(scratch.path() / "exercises");
    workshop.begin(meet());
    const auto file = workshop.file(meet());
    const std::string mine = "// mine\n";
    std::ofstream(file) << mine;
    CHECK_THROWS_AS(workshop.begin(meet()), lod::Error);
    const auto read = [](const std::filesystem::path& path) {
        std::ifstream in(path);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    CHECK(read(file) == mine);
    const auto first = workshop.reset(meet());
    CHECK(read(first) == mine);
    CHECK(read(file) == exercises::starter_file(meet()));
    std::ofstream(file) << "// more\n";
    const auto second = workshop.reset(meet());
    CHECK(first != second);
    CHECK(read(first) == mine);
    CHECK(read(second) == "// more\n");
}

TEST_CASE("progress and hints are kept from one start to the next, for the file as it was") {
    const Scratch scratch;
    const auto folder = scratch.path() / "exercises";
    using exercises::Progress;
    {
        exercises::Workshop workshop(folder);
        CHECK(workshop.progress(meet()) == Progress::not_begun);
        CHECK(workshop.next_hint(meet()) == 0);
        workshop.begin(meet());
        CHECK(workshop.progress(meet()) == Progress::fails);
        std::ofstream(workshop.file(meet())) << exercises::code_with(meet().words, {});
        CHECK(workshop.progress(meet()) == Progress::passes);
    }
    exercises::Workshop workshop(folder);
    CHECK(workshop.next_hint(meet()) == 1);
    ::setenv("CXX", "/nowhere", 1);  // what was checked is not compiled again
    CHECK(workshop.progress(meet()) == Progress::passes);
    std::ofstream(workshop.file(meet()), std::ios::app) << "\n";
    CHECK_THROWS_AS(workshop.progress(meet()), lod::Error);
    ::unsetenv("CXX");
    CHECK(workshop.progress(meet()) == Progress::passes);
    for (int i = 0; i < 5; ++i) static_cast<void>(workshop.next_hint(meet()));
    CHECK(workshop.next_hint(meet()) == meet().words.hints.size() - 1);
}
