#include <algorithm>
#include <cmath>

#include "lessons/engine/lessons.hpp"
#include "tests/catch.hpp"

using namespace lessons;

TEST_CASE("cover: the plank's circles are those worked out by hand, and only a hole misses",
          "[lessons]") {
    const Lesson lesson = run(find_lesson("cover")->number);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    const auto text = [&](const std::string& name) { return lesson.numbers.at(name).text; };
    // A plank of 4 m by 1 m, cut into rectangles of w by h: the radius is half their diagonal; it
    // stands out most where the plank is nearest to the circle's centre.
    const auto check_cover = [&](const std::string& name, double w, double h) {
        INFO(name);
        const double radius = std::hypot(w, h) / 2;
        CHECK(value(name + " radius") == Approx(radius).epsilon(1e-9));
        CHECK(value(name + " out") == Approx(radius - std::min(w, h) / 2).margin(1e-5));
        CHECK(value(name + " circles") == 4 / (w * h));
        CHECK(value(name + " tests") == 16 / (w * w * h * h));
    };
    check_cover("one", 4, 1);
    check_cover("four", 1, 1);
    check_cover("strips", 0.5, 1);
    check_cover("sixteen", 0.5, 0.5);
    CHECK(text("spare") == "3 and 5");
    CHECK(text("good verdict") == "they meet");
    CHECK(text("bad verdict") == "apart");
    CHECK(text("spoiled covers") == "refused");
    CHECK(text("star certified") == "certified");
    CHECK(value("uncovered") > 0);
    CHECK(value("proof tests") == 16);
    CHECK(value("pair tests") == value("crescent circles") * value("star circles"));
    CHECK(value("holding p") >= 2);
    CHECK(value("touching") > 100);
    CHECK(value("missed") == 0);
    CHECK(value("missed by spoiled") > 1);  // "were missed"
    CHECK(value("too small") == 186);       // by fractions of whole numbers, of any length
    CHECK(value("too small grown") == 0);
}

TEST_CASE("many_contacts: the energy table is the one worked out by hand", "[lessons]") {
    const Lesson lesson = run(find_lesson("many_contacts")->number);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    // One contact at x of the box (1 kg, I = 5/12): K = 1 + x^2 12/5 and j = 2 / K, so that two
    // corner contacts give 20/17 in all: the speed after is 3/17, the energy (3/17)^2 of what it
    // was.
    CHECK(value("sum 2") == Approx(9.0 / 289).epsilon(1e-12));
    CHECK(value("mean 2") == Approx(49.0 / 289).epsilon(1e-12));
    CHECK(value("sum 3") == Approx(37.0 * 37 / 289).epsilon(1e-12));
    CHECK(value("mean 3") == Approx(1.0 / 289).epsilon(1e-12));
    for (const std::string contacts : {"2", "3", "4", "16", "64"})
        CHECK(value("net " + contacts) == Approx(1).epsilon(1e-12));
    CHECK(lesson.numbers.at("sum 4").text == "11.12");
    CHECK(lesson.numbers.at("sum 16").text == "357");
    CHECK(lesson.numbers.at("sum 64").text == "6516");
    CHECK(lesson.numbers.at("mean 64").text == "0.077");
    CHECK(value("half bounce") == Approx(0.25).epsilon(1e-12));
    CHECK(value("single j") == Approx(2).epsilon(1e-12));
    CHECK(value("L energy") == Approx(1).epsilon(1e-12));
    CHECK(value("corner K") == Approx(3.4).epsilon(1e-12));
    CHECK(value("corner j") == Approx(10.0 / 17).epsilon(1e-12));
    CHECK(value("corner factor") == Approx(1.7).epsilon(1e-12));
    CHECK(value("short speed") == Approx(3.0 / 17).epsilon(1e-12));
    CHECK(value("floor change") == 0);
    CHECK(value("floor speed") == Approx(1).epsilon(1e-12));
    CHECK(value("neighbour speed") == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("many_contacts: three balls leave as worked out by hand", "[lessons]") {
    const Lesson lesson = run(find_lesson("many_contacts")->number);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    const auto text = [&](const std::string& name) { return lesson.numbers.at(name).text; };
    // The lines to B and C are 30 degrees off: each push alone is sqrt(3)/2. After that on B, A has
    // (1, -sqrt(3))/4; C then gets half of it, and A is left with (-1, -sqrt(3))/8.
    CHECK(value("first j") == Approx(std::sqrt(0.75)).epsilon(1e-12));
    CHECK(value("second closing") == Approx(std::sqrt(0.75) / 2).epsilon(1e-12));
    CHECK(text("A after one") == "(0.250, −0.433) m/s");
    CHECK(text("B first A") == "(−0.125, −0.217) m/s");
    CHECK(text("B first B") == "(0.750, 0.433) m/s");
    CHECK(text("B first C") == "(0.375, −0.217) m/s");
    CHECK(text("C first B") == "(0.375, 0.217) m/s");
    CHECK(text("C first C") == "(0.750, −0.433) m/s");
    CHECK(value("ordered energy") == Approx(value("energy start")).epsilon(1e-12));
    CHECK(value("sum share") == Approx(1.75).epsilon(1e-12));
    CHECK(value("net factor") == Approx(0.8).epsilon(1e-12));
    CHECK(value("net energy") == Approx(value("energy start")).epsilon(1e-12));
    CHECK(text("net A") == "(−0.200, 0.000) m/s");
    CHECK(text("net B") == "(0.600, 0.346) m/s");
    CHECK(text("net C") == "(0.600, −0.346) m/s");
    CHECK(text("lcp B") == text("net B"));
    CHECK(value("row net A") == Approx(0).margin(1e-12));
    CHECK(value("row net B") == Approx(0).margin(1e-12));
    CHECK(value("row net C") == Approx(1).epsilon(1e-12));
    CHECK(value("row lcp A") == Approx(-1.0 / 3).epsilon(1e-12));
    CHECK(value("row lcp B") == Approx(2.0 / 3).epsilon(1e-12));
    CHECK(value("row lcp C") == Approx(2.0 / 3).epsilon(1e-12));
}
