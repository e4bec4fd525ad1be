#include <algorithm>

#include "lessons/engine/lessons.hpp"
#include "tests/catch.hpp"

using namespace lessons;

namespace {

Lesson lesson_named(const std::string& slug) {
    for (const Entry& entry : list())
        if (entry.slug == slug) return run(entry.number);
    FAIL("there is no lesson " << slug);
    return {};
}

}  // namespace

TEST_CASE("possible and true: circles err to one side only, and never further than they stand out",
          "[lessons]") {
    const Lesson lesson = lesson_named("possible_and_true");
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    // The reach falls with every level, though the star's own share of it rises once.
    for (int level = 0; level < 3; ++level)
        CHECK(value("reach " + std::to_string(level)) >
              value("reach " + std::to_string(level + 1)));
    CHECK(value("star out 1") > value("star out 0"));
    CHECK(value("reach 2") == Approx(value("L out 2") + value("star out 2")).epsilon(1e-12));
    // The square round an L of two metres has its corners on the root, and the L's notch is 1.3 m.
    CHECK(value("L out 0") == Approx(1.3).epsilon(1e-3));
    const auto latest = static_cast<int>(value("latest"));
    CHECK(value("reach " + std::to_string(latest)) < value("near gap"));
    CHECK(value("reach " + std::to_string(latest - 1)) >= value("near gap"));
    CHECK(value("proof level") <= latest);
    CHECK(lesson.numbers.at("false verdict").text == "true collision");
    CHECK(lesson.numbers.at("deep verdict").text == "apart");
    CHECK(value("false gap") > 0);
    CHECK(value("false gap") <= value("reach 3"));
    CHECK(value("levels with p") == value("levels"));
    CHECK(value("touching") + value("apart") == value("placements"));
    CHECK(value("misses") == 0);
    CHECK(value("deep misses") == 0);
    CHECK(value("over reach") == 0);
    CHECK(value("risen") == 0);
    CHECK(value("false collisions") == value("alarms 3"));
    CHECK(value("widest") <= value("reach 3"));
    CHECK(value("deep widest") <= value("deep reach"));
    CHECK(value("deep false collisions") < value("false collisions"));
    CHECK(value("alarms 0") > value("alarms 1"));
    CHECK(value("alarms 1") > value("alarms 2"));
    CHECK(value("alarms 2") > value("alarms 3"));
}

TEST_CASE("interruption: each pair keeps its last whole level, and a part of a level would mislead",
          "[lessons]") {
    const Lesson lesson = lesson_named("interruption");
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    CHECK(value("least") == 2);
    CHECK(value("tests") == value("pair 1 tests") + value("pair 2 tests"));
    // The sums of the worked example: level 0 and 1 of both, then pair 1's level 2, cut short.
    CHECK(value("before cut") == value("least") + value("pair 1 1") + value("pair 2 1"));
    CHECK(value("cut level") == 2);
    CHECK(value("cut cost") == value("pair 1 2"));
    CHECK(value("lost") == value("quota") - value("before cut"));
    CHECK(value("lost") < value("cut cost"));
    CHECK(value("clock 1") == 1);
    CHECK(value("clock 2") == 1);
    // The part met nothing, though the bodies touch: the last test of the level says so.
    CHECK(value("met in part") == 0);
    CHECK(lesson.numbers.at("outlines").text == "touch");
    CHECK(value("first overlap") == value("cut cost"));
    CHECK(value("uneven") == 2 * 4 * 4 + 4);
    // Counted: pair 2 uses what pair 1 cannot; with a few tests more pair 1 can.
    CHECK(value("counted 1") == 1);
    CHECK(value("counted 2") == 2);
    CHECK(value("counted spent") <= value("quota"));
    CHECK(value("counted spent") == value("before cut") + value("pair 2 2"));
    CHECK(value("first 1") == 3);
    CHECK(value("first 2") == 0);
    CHECK(value("larger") > value("quota"));
    CHECK(value("larger 1") == 2);
    CHECK(value("larger 2") < value("counted 2"));
    CHECK(value("stops") == 2 * (value("tests") - 2));
    CHECK(value("misses") == 0);
    CHECK(value("differences") == 0);
}

TEST_CASE("scheduler: the reserve is kept, levels follow the look, and perceptual errs least there",
          "[lessons]") {
    const Lesson lesson = lesson_named("scheduler");
    const auto value = [&](const std::string& name) { return lesson.numbers.at(name).value; };
    CHECK(value("quota") < value("wanted"));
    CHECK(value("spent") + value("reserved") + value("left") == value("quota"));
    CHECK(value("reserved") > 0);
    CHECK(value("first come leaves") > value("level order leaves"));
    CHECK(value("first come roots") > 0);
    CHECK(value("first come mean") < value("level order mean"));
    CHECK(value("first offer fall") > value("second offer fall"));
    CHECK(value("first offer value") < value("second offer value"));
    CHECK(value("first offer value") * value("first offer tests") ==
          Approx(value("first offer fall")).epsilon(1e-12));
    CHECK(value("trade differs") == 0);
    CHECK(value("look left, left half") > value("look left, right half"));
    CHECK(value("look right, right half") > value("look right, left half"));
    double least = 1;
    double most = 0;
    double tight_least = 1;
    double tight_most = 0;
    for (const std::string name :
         {"level_order", "closing_speed", "perceptual", "best_gain", "trade", "first_come"}) {
        INFO(name);
        least = std::min(least, value(name + " error"));
        most = std::max(most, value(name + " error"));
        tight_least = std::min(tight_least, value(name + " tight"));
        tight_most = std::max(tight_most, value(name + " tight"));
        CHECK(value(name + " tight") > value(name + " error"));
        if (name != "perceptual")
            CHECK(value("perceptual attended") < value(name + " attended") - 0.05);
        if (name != "first_come") CHECK(value(name + " error") < value("first_come error") - 0.1);
    }
    CHECK(value("perceptual attended") < value("perceptual error"));
    CHECK(tight_most - tight_least < most - least);
    CHECK(value("first_come error") == most);
}
