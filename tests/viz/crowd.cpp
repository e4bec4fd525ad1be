#include "lodlab/viz/draw/motion/draw_crowd.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/figure/json.hpp"
#include "tests/catch.hpp"
#include "tests/viz/sample_scene.hpp"

using namespace viz;
using namespace std::chrono_literals;

namespace {

/// A frame on a clock: what was left when its levels were done and at its end, and what was kept.
lod::FrameRecord<2> timed(std::chrono::nanoseconds after_levels, std::chrono::nanoseconds left,
                          std::chrono::nanoseconds reserved) {
    lod::FrameRecord<2> record;
    record.spending.time_left = left;
    record.spending.after_levels = {after_levels, reserved};
    return record;
}

lod::PairRecord pair_of(std::int32_t a, std::int32_t b, int level, lod::Verdict verdict) {
    lod::PairRecord pair;
    pair.bodies = {a, b};
    pair.level = level;
    pair.verdict = verdict;
    return pair;
}

/// Four boxes in a row and a wall. In each frame the first meets the second at level 2 and the
/// third, which was proved apart at level 1, meets the second at level 0; the fourth meets nobody.
Run<2> four_boxes(int frames) {
    Run<2> run;
    run.time_step = 0.5;
    std::vector<lod::Body<2>> bodies;
    for (int body = 0; body < 5; ++body) {
        const Actor<2> box = sample::actor("box", 2 * body, 0, 0, 2);
        run.visuals.push_back(box.visual);
        bodies.push_back(box.body);
    }
    bodies.back().inverse_mass = 0;
    for (int i = 0; i < frames; ++i) {
        Instant<2>& instant = run.instants.emplace_back();
        instant.time = i * run.time_step;
        instant.bodies = bodies;
        instant.record = timed(600us, 400us, 300us);
        instant.record.tests = 40;
        instant.record.spending.tests_left = 50;
        instant.record.pairs = {pair_of(0, 1, 2, lod::Verdict::true_collision),
                                pair_of(0, 2, 1, lod::Verdict::apart),
                                pair_of(1, 2, 0, lod::Verdict::possible)};
    }
    return run;
}

std::vector<std::string> values_of(const Panel& list) {
    std::vector<std::string> values;
    for (const Entry& entry : list.entries) values.push_back(entry.value);
    return values;
}

/// Where the parts of a bar begin and end.
std::vector<std::pair<double, double>> parts_in(const Panel& bar) {
    std::vector<std::pair<double, double>> parts;
    for (const Mark& mark : bar.marks)
        if (const auto* path = std::get_if<Path>(&mark))
            parts.emplace_back(path->rings[0][0].y, path->rings[0][2].y);
    return parts;
}

}  // namespace

TEST_CASE("the parts of a quota on a clock add up to it", "[crowd]") {
    // Of 1 ms the levels took 0.4; 0.3 were kept, of which contacts and response took 0.2.
    const auto kept = use_of(timed(600us, 400us, 300us), {.node_tests = {}, .milliseconds = 1.0});
    REQUIRE(kept);
    CHECK(kept->levels == Approx(0.4));
    CHECK(kept->response == Approx(0.2));
    CHECK(kept->reserve == Approx(0.1));
    CHECK(kept->unused == Approx(0.3));
    CHECK(kept->overrun == 0);
}

TEST_CASE("what a frame takes beyond its quota is its overrun", "[crowd]") {
    // The levels took 0.9 ms, what followed 0.5 where 0.2 were kept: 0.4 beyond the quota.
    const auto over = use_of(timed(100us, -400us, 200us), {.node_tests = {}, .milliseconds = 1.0});
    REQUIRE(over);
    CHECK(over->levels + over->response == Approx(1.4));
    CHECK(over->overrun == Approx(0.4));
    CHECK(over->reserve == 0);
    CHECK(over->unused == 0);
    // The entry levels alone were too many.
    const auto late = use_of(timed(-200us, -300us, 0us), {.node_tests = {}, .milliseconds = 1.0});
    REQUIRE(late);
    CHECK(late->levels == Approx(1.2));
    CHECK(late->overrun == Approx(0.3));
}

TEST_CASE("of node tests what is neither spent nor left is kept for the response", "[crowd]") {
    lod::FrameRecord<2> record;
    record.tests = 60;
    record.spending.tests_left = 25;
    const Quota quota{.node_tests = 100, .milliseconds = {}};
    const auto use = use_of(record, quota);
    REQUIRE(use);
    CHECK(use->levels == 60);
    CHECK(use->response == 0);
    CHECK(use->reserve == 15);
    CHECK(use->unused == 25);
    record.tests = 130;  // entry levels are done whatever the quota says
    record.spending.tests_left = 0;
    CHECK(use_of(record, quota)->overrun == 30);
    CHECK(use_of(record, quota)->unused == 0);
}

TEST_CASE("without a quota, or where a trace tells no times, there is nothing to divide",
          "[crowd]") {
    CHECK_FALSE(use_of(lod::FrameRecord<2>(), {}));
    CHECK_FALSE(use_of(lod::FrameRecord<2>(), {.node_tests = {}, .milliseconds = 1.0}));
}

TEST_CASE("the scheduler's own record of a frame divides its quota of tests", "[crowd]") {
    std::vector<lod::Body<2>> bodies{sample::actor("box", 0, 0, 0).body,
                                     sample::actor("star:5", 0.6, 0.1, 0.2).body};
    lod::FrameStorage<2> storage;
    lod::Budget budget = lod::Budget::node_tests(80, 2.0);
    const auto& record = lod::detect<2>(bodies, {}, budget, storage);
    const auto use = use_of(record, {.node_tests = 80, .milliseconds = {}});
    REQUIRE(use);
    CHECK(use->levels == static_cast<double>(record.tests));
    CHECK(use->reserve > 0);
    CHECK(use->levels + use->reserve + use->unused == Approx(80));
}

TEST_CASE("a body's level is the least of its pairs that nothing proved apart", "[crowd]") {
    CHECK(body_levels<2>(four_boxes(1).instants[0].record, 5) == std::vector<int>{2, 0, 0, -1, -1});
}

TEST_CASE("a crowd's picture fills bodies by level, counts them, and divides the quota",
          "[crowd]") {
    CrowdChoice choice;
    choice.quota.milliseconds = 1;
    choice.fixation = {{3, 0, 0}};
    const Figure figure = crowd_picture<2>(four_boxes(3), 1, choice);
    REQUIRE(figure.panels.size() == 4);
    std::vector<int> levels;
    int walls = 0;
    int dots = 0;
    for (const Mark& mark : figure.panels[0].marks) {
        if (const auto* path = std::get_if<Path>(&mark)) {
            if (path->style.role == Role::reached) levels.push_back(path->style.level);
            walls += path->style.role == Role::wall ? 1 : 0;
        }
        if (const auto* dot = std::get_if<Dot>(&mark)) {
            CHECK(dot->at == Point{3, 0});
            ++dots;
        }
    }
    CHECK(levels == std::vector<int>{2, 0, 0, -1});
    CHECK(walls == 1);
    CHECK(dots == 2);
    CHECK(values_of(figure.panels[1]) == std::vector<std::string>{"1", "2", "0", "1"});
    CHECK(values_of(figure.panels[2]) ==
          std::vector<std::string>{"0.400", "0.200", "0.100", "0.300", "0.000"});
    const auto parts = parts_in(figure.panels[3]);
    REQUIRE(parts.size() == 4);  // nothing is over
    CHECK(parts[0].first == 0);
    CHECK(parts[1].first == Approx(0.4));
    CHECK(parts[2].first == Approx(0.6));
    CHECK(parts[3].first == Approx(0.7));
    CHECK(parts[3].second == Approx(1));
    CHECK(figure.title == "Frame 1 takes 0.6 of 1\u00A0ms and brings its pairs to level 1.0");
    CHECK(figure.numbers[0].value == "1 of 3");
    CHECK(figure.numbers[1].value == "0.600\u00A0ms");
    CHECK(figure.numbers[2].value == "2");
    CHECK(figure.numbers[3].value == "1.0");
    CHECK(json_text(figure).find("\"words\": \"level 2\"") != std::string::npos);
}

TEST_CASE("a crowd without a quota has no bar, one without a policy of sight no fixation point",
          "[crowd]") {
    const Figure figure = crowd_picture<2>(four_boxes(1), 0);
    CHECK(figure.panels.size() == 2);
    CHECK(figure.title == "The pairs that meet in frame 0 reach level 1.0 in the mean");
    for (const Mark& mark : figure.panels[0].marks) CHECK_FALSE(std::holds_alternative<Dot>(mark));
}

TEST_CASE("a crowd's film shows every frame, and ends on the last", "[crowd]") {
    CrowdChoice choice;
    choice.quota.node_tests = 100;
    const Animation film = crowd_motion<2>(four_boxes(7), choice);
    REQUIRE(film.shots.size() == 7);
    CHECK(film.shots[0].frames == 1);
    CHECK(film.shots[6].frames == 45);
    for (std::size_t i = 0; i < 7; ++i) {
        const Figure frame = film.shots[i].draw();
        CHECK(frame.numbers[0].value == std::to_string(i) + " of 7");
        CHECK(frame.title == "100\u00A0tests cut 0 of 7 frames, with pairs that meet at level 1.0");
    }
    CHECK_THROWS_AS(crowd_motion<2>(Run<2>()), lod::Error);
    CHECK_THROWS_AS(crowd_picture<2>(four_boxes(2), 2), lod::Error);
}

TEST_CASE("a long film takes every second frame or fewer, and stays short", "[crowd]") {
    const Animation film = crowd_motion<2>(four_boxes(2500));
    CHECK(film.shots.size() <= 1200);
    CHECK(film.shots.back().draw().numbers[0].value == "2499 of 2500");
}

TEST_CASE("the fullest frame is the one in which most pairs meet", "[crowd]") {
    Run<2> run = four_boxes(3);
    run.instants[1].record.pairs[1].verdict = lod::Verdict::possible;
    CHECK(fullest_instant(run) == 1);
}
