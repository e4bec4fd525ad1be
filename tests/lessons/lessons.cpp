#include "lessons/engine/lessons.hpp"

#include <cmath>
#include <regex>

#include "lessons/embed/source.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/viz/figure/check.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"

using namespace lessons;

TEST_CASE("there are fourteen lessons in the order in which they build on each other",
          "[lessons]") {
    const std::vector<Entry> all = list();
    REQUIRE(all.size() == 14);
    CHECK(all[0].slug == "distance_test");
    CHECK(all[1].slug == "cover");
    CHECK(all[2].slug == "circle_tree");
    CHECK(all[3].slug == "traversal");
    CHECK(all[4].slug == "possible_and_true");
    CHECK(all[5].slug == "interruption");
    CHECK(all[6].slug == "contact_and_impulse");
    CHECK(all[7].slug == "many_contacts");
    CHECK(all[8].slug == "graceful_degradation");
    CHECK(all[9].slug == "circles_to_spheres");
    CHECK(all[10].slug == "inertia");
    CHECK(all[11].slug == "scheduler");
    CHECK(all[12].slug == "beside_box2d");
    CHECK(all[13].slug == "too_early");
    for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i].number == static_cast<int>(i) + 1);
}

TEST_CASE("the README names every lesson, in order", "[lessons]") {
    const std::string readme = lod::read_text_file(LODLAB_SOURCE_DIR "/README.md", 1 << 20);
    std::size_t place = 0;
    for (const Entry& entry : list()) {
        INFO(entry.title);
        place = readme.find(std::to_string(entry.number) + ". " + entry.title, place);
        CHECK(place != std::string::npos);
    }
}

TEST_CASE("a lesson that does not exist is a usage error naming those that do", "[lessons]") {
    try {
        (void)run(99);
        FAIL("lesson 99 ran");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::usage);
        CHECK(std::string(error.what()).find("1 to " + std::to_string(list().size())) !=
              std::string::npos);
    }
}

TEST_CASE("every lesson runs and draws figures that can be drawn", "[lessons]") {
    for (const Entry& entry : list()) {
        INFO(entry.slug);
        const Lesson lesson = run(entry.number);
        CHECK(lesson.steps.size() >= 5);
        for (const Step& step : lesson.steps) CHECK(lesson.figures.count(step.figure) == 1);
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
        if (lodtest::sanitized && entry.number > 2) break;
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
        if (lodtest::sanitized && entry.number > 4) break;  // another test runs them there
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

TEST_CASE("distance_test: three and four make five, and 0.1 + 0.7 falls short of 0.8",
          "[lessons]") {
    const Lesson lesson = run(find_lesson("distance_test")->number);
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

TEST_CASE("circle_tree: deeper levels of the crescent stand out less, a star's first level more",
          "[lessons]") {
    const Lesson lesson = run(find_lesson("circle_tree")->number);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    for (int level = 1; level <= 3; ++level) {
        const std::string now = std::to_string(level);
        const std::string before = std::to_string(level - 1);
        CHECK(value("worst " + now) < value("worst " + before));
        CHECK(value("circles " + now) > value("circles " + before));
        CHECK(value("circles " + now) <= std::pow(4.0, level));
    }
    CHECK(value("certified levels") == 4);
    CHECK(value("star worst 1") > value("star worst 0"));
    CHECK(value("star worst 2") < value("star worst 0"));
    CHECK(value("star area 1") < value("star area 0"));
}

TEST_CASE("traversal: the near miss ends in proof, the interruption keeps a finished level",
          "[lessons]") {
    const Lesson lesson = run(find_lesson("traversal")->number);
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

TEST_CASE("contact_and_impulse: the two points are those worked out by hand, and energy is kept",
          "[lessons]") {
    const Lesson lesson = run(find_lesson("contact_and_impulse")->number);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    CHECK(value("ratio point") == Approx(4.0 / 3).epsilon(1e-12));
    CHECK(value("plane point") == Approx(1.75).epsilon(1e-12));
    CHECK(value("v_c") < 0);
    CHECK(value("v_c after") == Approx(-value("v_c")).epsilon(1e-12));
    CHECK(value("energy after") == Approx(value("energy before")).epsilon(1e-12));
    CHECK(value("second j") == 0);
    CHECK(value("K") ==
          Approx(value("K mass a") + value("K mass b") + value("K turn a") + value("K turn b"))
              .epsilon(1e-12));
}

TEST_CASE(
    "circles_to_spheres: plane and space agree, and linked rings are apart though all shadows "
    "overlap",
    "[lessons]") {
    const Lesson lesson = run(find_lesson("circles_to_spheres")->number);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    CHECK(value("d") == Approx(std::sqrt(1.2 * 1.2 + 0.5 * 0.5 + 1.2 * 1.2)).epsilon(1e-12));
    CHECK(value("disagreements") == 0);
    CHECK(value("differing fronts") == 0);
    CHECK(value("flat tests") == value("lifted tests"));
    CHECK(value("flat pairs") > 10);
    CHECK(value("contact difference") < 1e-12);
    CHECK(value("certified levels") == 3);
    CHECK(value("worst 1") < value("worst 0"));
    CHECK(value("worst 2") < value("worst 1"));
    CHECK(value("spheres 1") <= 8);
    CHECK(value("spheres 2") <= 64);
    CHECK(value("volume 2") >= 1);
    CHECK(value("ring, space worst") <= 3);
    CHECK(value("L, space worst") <= 3);
    CHECK(value("L, space") > 4 * value("L, plane"));
    CHECK(value("ring, space") < 2 * value("ring, plane"));
    CHECK(value("link pairs 2") == 0);
    CHECK(value("overlapping shadows") == 3);
    CHECK(value("pulled pairs") > 0);
    // Radii 2 and 1, centres 2 apart: the plane is (4 + 4 - 1) / 4 from the first centre.
    CHECK(value("to plane") == Approx(1.75).epsilon(1e-12));
    CHECK(value("to ratio") == Approx(4.0 / 3).epsilon(1e-12));
    CHECK(value("circle radius") == Approx(std::sqrt(15.0) / 4).epsilon(1e-12));
    CHECK(value("off circle") < 1e-12);
}

TEST_CASE("inertia: the crate's numbers are those worked out by hand, and the spin flips",
          "[lessons]") {
    const Lesson lesson = run(find_lesson("inertia")->number);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    CHECK(value("I x") == Approx(0.40).epsilon(1e-12));
    CHECK(value("I y") == Approx(1.04).epsilon(1e-12));
    CHECK(value("I z") == Approx(1.36).epsilon(1e-12));
    CHECK(value("I xx") == Approx(0.75 * 0.40 + 0.25 * 1.04).epsilon(1e-12));
    CHECK(value("I yy") == Approx(0.25 * 0.40 + 0.75 * 1.04).epsilon(1e-12));
    CHECK(value("I xy") == Approx(std::sqrt(3.0) / 4 * (0.40 - 1.04)).epsilon(1e-12));
    CHECK(value("I zz") == Approx(1.36).epsilon(1e-12));
    const double degree = std::acos(-1.0) / 180;
    CHECK(std::tan(value("tilt") * degree) == Approx(-value("I xy") / 0.56).epsilon(1e-12));
    const double angle = std::atan2(0.1 / 0.40, 0.5 / 1.36) - std::atan2(0.1, 0.5);
    CHECK(value("push angle") == Approx(angle / degree).epsilon(1e-12));
    const double K = 1.0 / 12 + 0.01 / 0.40 + 0.25 / 1.36;
    CHECK(value("K") == Approx(K).epsilon(1e-12));
    CHECK(value("K flat") == Approx(1.0 / 12 + 0.25 / 1.36).epsilon(1e-12));
    CHECK(value("j") == Approx(2 / K).epsilon(1e-12));
    CHECK(value("corner speed") == Approx(2 / K / 12 - 1).epsilon(1e-12));
    CHECK(value("energy before") == Approx(6).epsilon(1e-12));
    CHECK(value("energy after") == Approx(6).epsilon(1e-12));
    // Ten thousand steps: kept to a millionth and far better; explicit steps are off by a half.
    CHECK(value("sound energy") < 1e-9);
    CHECK(value("momentum drift") < 1e-9);
    CHECK(value("naive energy") > 1.5);
    CHECK(value("spin angle") > 20);
    CHECK(value("flips") >= 2);
    CHECK(value("wobble x") < 0.1);
    CHECK(value("wobble z") < 0.1);
}

TEST_CASE(
    "graceful_degradation: levels push in time, across gaps within their bound, and the median "
    "falls",
    "[lessons]") {
    const Lesson lesson = run(find_lesson("graceful_degradation")->number);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    for (const std::string level : {"0", "1", "2", "3", "4"})
        CHECK(value("time " + level) <= value("time exact") + 1 / value("frames"));
    for (int level = 1; level <= 4; ++level) {
        const std::string now = std::to_string(level);
        const std::string before = std::to_string(level - 1);
        CHECK(value("time " + now) >= value("time " + before));
        CHECK(value("line " + now) < value("line " + before));
        CHECK(value("tests " + now) > value("tests " + before));
        CHECK(value("hull " + now) < value("line " + now));
        if (level < 4) CHECK(value("gap " + now) <= value("gap " + before));
    }
    CHECK(value("gap 1") <= value("bound"));
    CHECK(value("bound") == Approx(value("e_a") + value("e_b")).epsilon(1e-12));
    CHECK(value("gap 3") == 0);
    // By hand from what the step shows.
    CHECK(value("error by hand") == Approx(value("J difference") / value("J size")).epsilon(1e-12));
    CHECK(value("error by hand") == Approx(value("error 2")).epsilon(1e-12));
    CHECK(lesson.numbers.at("J level").value ==
          Approx(value("m_b") * (value("v_b level") - value("v_b"))).epsilon(1e-12));
    CHECK(value("error 1") > value("error 0"));
    CHECK(value("error 3") < value("error 2"));
    CHECK(value("no push") == 1);
    CHECK(value("hull widest gap") > 0);
}

TEST_CASE("beside_box2d: two programs agree on one impact, and differ by skin, step and law",
          "[lessons]") {
    const Lesson lesson = run(find_lesson("beside_box2d")->number);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    // Two unit boxes with levers of 0.2 m, closing at 2 m/s.
    CHECK(value("K") == Approx(2 + 2 * 0.04 * 6).epsilon(1e-12));
    CHECK(value("j") == Approx(4 / 2.48).epsilon(1e-12));
    CHECK(value("spin") == Approx(0.2 * 6 * 4 / 2.48).epsilon(1e-12));
    CHECK(value("j difference") < 1e-6);
    // Two skins, less what a step of 1/960 s covers at 2 m/s; without skins worth a step, no gap.
    CHECK(value("gap") <= 2.0001);
    CHECK(value("gap") > 2 - 200.0 / 960);
    CHECK(value("small gap") < 200.0 / 960);
    CHECK(value("way") == Approx(200.0 / 60).epsilon(1e-12));
    for (const std::string program : {"lodlab", "Box2D"}) {
        CHECK(value(program + " 60") / value(program + " 960") > 10);
        CHECK(value(program + " 60") / value(program + " 960") < 40);
    }
    CHECK(value("lodlab 60") < value("Box2D 60"));
    CHECK(value("lodlab 960") > value("Box2D 960"));
    CHECK(value("net 3") == Approx(1).epsilon(1e-12));
    CHECK(value("net 2") == Approx(0).margin(1e-12));
    CHECK(value("box2d 1") == Approx(-1.0 / 3).epsilon(1e-6));
    CHECK(value("box2d 3") == Approx(2.0 / 3).epsilon(1e-6));
    CHECK(value("law apart") < 1e-6);
    CHECK(value("energy lodlab") == Approx(0.5).epsilon(1e-12));
    CHECK(value("energy box2d") == Approx(0.5).epsilon(1e-6));
    CHECK(value("error leaves") < 0.01);
    CHECK(value("error box2d") < 0.01);
    CHECK(value("error level 1") > 10);
    CHECK(value("finer 3") > 10 * value("finer 2"));
}

TEST_CASE("too_early: circles are early at every level, and half a crowd's budget errs little",
          "[lessons]") {
    const Lesson lesson = run(find_lesson("too_early")->number);
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    const double up = value("up");
    const double reach = value("reach");
    CHECK(value("touch by hand") ==
          Approx((value("across") - std::sqrt(reach * reach - up * up)) / value("speed"))
              .epsilon(1e-12));
    CHECK(value("touch") == Approx(value("touch by hand")).epsilon(1e-6));
    CHECK(value("least gap") > 0);
    CHECK(value("gap") >= value("least gap"));
    for (int level = 0; level <= 4; ++level) CHECK(value("early " + std::to_string(level)) > 0);
    for (int level = 1; level <= 4; ++level)
        CHECK(value("early " + std::to_string(level)) <
              value("early " + std::to_string(level - 1)));
    CHECK(value("fastest") == Approx(value("closing") + value("L spin") * value("arm")));
    CHECK(value("safe") == Approx(value("start gap") / value("fastest")).epsilon(1e-12));
    CHECK(value("safe") < value("impact"));
    CHECK(value("rounds") > 1);
    CHECK(value("last distance") < 1e-8);
    // The quota is kept, and nobody is left out.
    CHECK(value("spent") <= value("quota"));
    CHECK(value("least") >= 0);
    CHECK(value("half error") < value("tenth error"));
    CHECK(value("tenth error") < value("least error"));
    CHECK(value("least error") < 100);
}
