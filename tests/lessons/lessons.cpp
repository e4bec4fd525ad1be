#include "lessons/lessons.hpp"

#include <cmath>
#include <regex>

#include "core/error.hpp"
#include "lessons/source.hpp"
#include "tests/catch.hpp"
#include "viz/write.hpp"

using namespace lessons;

TEST_CASE("there are four lessons in the order in which they build on each other", "[lessons]") {
    const std::vector<Entry> all = list();
    REQUIRE(all.size() == 4);
    CHECK(all[0].slug == "distance_test");
    CHECK(all[1].slug == "circle_tree");
    CHECK(all[2].slug == "traversal");
    CHECK(all[3].slug == "contact_and_impulse");
    for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i].number == static_cast<int>(i) + 1);
}

TEST_CASE("a lesson that does not exist is a usage error naming those that do", "[lessons]") {
    try {
        (void)run(99);
        FAIL("lesson 99 ran");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::usage);
        CHECK(std::string(error.what()).find("1 to 4") != std::string::npos);
    }
}

TEST_CASE("every lesson runs, asks for a prediction, and draws figures that can be drawn",
          "[lessons]") {
    for (const Entry& entry : list()) {
        INFO(entry.slug);
        const Lesson lesson = run(entry.number);
        CHECK(lesson.steps.size() >= 5);
        bool asks = false;
        for (const Step& step : lesson.steps) {
            asks = asks || step.text.find("**Predict:**") != std::string::npos;
            CHECK_NOTHROW(viz::check_figure(step.figure));
        }
        CHECK(asks);
        CHECK(lesson.steps.back().text.find("**Predict:**") == std::string::npos);
        for (const auto& [name, figure] : lesson.figures) {
            INFO(name);
            CHECK_NOTHROW(viz::check_figure(figure));
        }
        CHECK(viz::frame_count(lesson.animation) > 0);
        for (const viz::Shot& shot : lesson.animation.shots)
            CHECK_NOTHROW(viz::check_figure(shot.draw()));
    }
}

TEST_CASE("running a lesson twice gives the same texts and numbers", "[lessons]") {
    for (const Entry& entry : list()) {
        const Lesson one = run(entry.number);
        const Lesson two = run(entry.number);
        REQUIRE(one.steps.size() == two.steps.size());
        for (std::size_t i = 0; i < one.steps.size(); ++i)
            CHECK(one.steps[i].text == two.steps[i].text);
        for (const auto& [name, number] : one.numbers)
            CHECK(two.numbers.at(name).text == number.text);
    }
}

TEST_CASE("a number's words agree with its value", "[lessons]") {
    const std::regex leading("^[−-]?[0-9.\u202f]+");
    for (const Entry& entry : list()) {
        const Lesson lesson = run(entry.number);
        for (const auto& [name, number] : lesson.numbers) {
            std::string words;
            for (std::size_t i = 0; i < number.text.size(); ++i) {
                if (number.text.compare(i, 3, "−") == 0)
                    words += '-', i += 2;
                else if (number.text.compare(i, 3, "\u202f") == 0)
                    i += 2;
                else if (number.text.compare(i, 2, "\u00a0") == 0)
                    break;
                else
                    words += number.text[i];
            }
            if (words.find_first_not_of("-.0123456789") != std::string::npos) continue;  // a word
            const std::size_t point = words.find('.');
            const auto decimals =
                point == std::string::npos ? 0 : static_cast<int>(words.size() - point - 1);
            INFO(entry.slug << ": " << name << " = " << number.text);
            CHECK(std::abs(std::stod(words) - number.value) <= 0.5001 * std::pow(10.0, -decimals));
        }
    }
}

TEST_CASE("lesson 1: three and four make five, and 0.1 + 0.7 falls short of 0.8", "[lessons]") {
    const Lesson lesson = run(1);
    CHECK(lesson.numbers.at("touching d²").value == 25);
    CHECK(lesson.numbers.at("touching reach²").value == 25);
    CHECK(lesson.numbers.at("rounded reach").value < 0.8);
    CHECK(lesson.numbers.at("tangent pairs").value == 400);
    CHECK(lesson.numbers.at("lost pairs").value > 0);
    CHECK(lesson.numbers.at("lost with bound").value == 0);
    // Near: the circles meet, the outlines do not. Apart: d exceeds the reach.
    CHECK(lesson.numbers.at("near distance").value < lesson.numbers.at("reach").value);
    CHECK(lesson.numbers.at("apart distance").value > lesson.numbers.at("reach").value);
    CHECK(lesson.numbers.at("gap").value > 0);
    // The gear reaches 1 m from its centre and the star 0.65 m: half of the sizes that they were
    // given.
    CHECK(lesson.numbers.at("R_a").value == Approx(1).epsilon(0.01));
    CHECK(lesson.numbers.at("R_b").value == Approx(0.65).epsilon(0.01));
}

TEST_CASE("lesson 2: deeper levels stand out less, and only the sound tree is certified",
          "[lessons]") {
    const Lesson lesson = run(2);
    for (int level = 1; level <= 3; ++level) {
        const std::string now = std::to_string(level);
        const std::string before = std::to_string(level - 1);
        CHECK(lesson.numbers.at("worst " + now).value < lesson.numbers.at("worst " + before).value);
        CHECK(lesson.numbers.at("circles " + now).value >
              lesson.numbers.at("circles " + before).value);
        CHECK(lesson.numbers.at("circles " + now).value <= std::pow(4.0, level));
    }
    CHECK(lesson.numbers.at("certified levels").value == 4);
    CHECK(lesson.numbers.at("uncovered").value > 0);
    CHECK(lesson.numbers.at("bad verdict").text == "apart");
    CHECK(lesson.numbers.at("good verdict").text == "true collision");
    CHECK(lesson.numbers.at("visitor").value > 0);
}

TEST_CASE("lesson 3: the near miss ends in proof, the interruption keeps a finished level",
          "[lessons]") {
    const Lesson lesson = run(3);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    const auto last = static_cast<int>(value("miss levels"));
    CHECK(last >= 3);
    double tests = 0;
    for (int level = 0; level <= last; ++level) tests += value("tests " + std::to_string(level));
    CHECK(tests == value("miss tests"));
    CHECK(value("tests 0") == 1);
    CHECK(value("front " + std::to_string(last)) == 0);
    CHECK(value("miss tests") < value("leaf pairs"));
    CHECK(value("hit pairs") > 0);
    CHECK(value("finished level") == value("cut level") - 1);
    CHECK(value("tests wasted") > 0);
    CHECK(value("tests spent") <= value("quota"));
}

TEST_CASE("lesson 4: the two points and the energy table are those worked out by hand",
          "[lessons]") {
    const Lesson lesson = run(4);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    CHECK(value("ratio point") == Approx(4.0 / 3).epsilon(1e-12));
    CHECK(value("plane point") == Approx(1.75).epsilon(1e-12));
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
    CHECK(value("v_c") < 0);
    CHECK(value("v_c after") == Approx(-value("v_c")).epsilon(1e-12));
    CHECK(value("energy after") == Approx(value("energy before")).epsilon(1e-12));
    CHECK(value("second j") == 0);
    CHECK(value("K") ==
          Approx(value("K mass a") + value("K mass b") + value("K turn a") + value("K turn b"))
              .epsilon(1e-12));
}
