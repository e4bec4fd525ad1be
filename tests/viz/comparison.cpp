#include "lodlab/viz/draw/motion/draw_comparison.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/figure/check.hpp"
#include "lodlab/viz/figure/number_text.hpp"
#include "tests/catch.hpp"
#include "tests/viz/sample_scene.hpp"

using namespace viz;

namespace {

/// A star at some speed for a second, before a wall.
Run<2> flight(const std::string& name, double speed) {
    Run<2> run;
    run.name = name;
    run.time_step = 0.25;
    Actor<2> star = sample::actor("star:5", 0, 0, 0, 1);
    Actor<2> wall = sample::actor("box:0.5,3", 4, 0, 0, 1);
    lod::make_static(wall.body);
    run.visuals = {star.visual, wall.visual};
    star.body.velocity = {speed, 0};
    for (int i = 0; i <= 4; ++i) {
        add_instant(run, {star.body, wall.body}, {});
        star.body.position.x() += speed * run.time_step;
    }
    return run;
}

template <class Kind>
std::vector<const Kind*> references(const Panel& panel) {
    std::vector<const Kind*> found;
    for (const Mark& mark : panel.marks)
        if (const auto* held = std::get_if<Kind>(&mark);
            held != nullptr && held->style.role == Role::reference)
            found.push_back(held);
    return found;
}

}  // namespace

TEST_CASE("a comparison lays every run over the reference, which is named at its end",
          "[drawings]") {
    const Run<2> reference = flight("Box2D", 2);
    const Figure figure =
        comparison<2>({flight("level 0", 1), flight("level 1", 1.75)}, reference, 1);
    REQUIRE(figure.panels.size() == 2);
    CHECK(figure.shared_scale);
    for (const Panel& panel : figure.panels) {
        const auto outlines = references<Path>(panel);
        REQUIRE(outlines.size() == 1);  // of the star; walls stand where they stand
        const auto ways = references<Polyline>(panel);
        REQUIRE(ways.size() == 1);
        CHECK(ways[0]->points.front() == Point{0, 0});
        CHECK(ways[0]->points.back() == Point{2, 0});
        const auto names = references<Label>(panel);
        REQUIRE(names.size() == 1);
        CHECK(names[0]->text == "Box2D");
    }
    CHECK(figure.panels[0].title == "level 0");
    CHECK(figure.alt.find("level 0: no body more than 1\u00A0m from where Box2D has it") !=
          std::string::npos);
    CHECK(figure.alt.find("level 1: no body more than " + length_text(0.25)) != std::string::npos);
    CHECK_NOTHROW(check_figure(figure));
}

TEST_CASE("a film of a comparison shows the reference beside the runs, on one clock",
          "[drawings]") {
    ComparisonMotion choice;
    choice.seconds = 1;
    choice.frames_per_second = 5;
    const Animation film = comparison_motion<2>({flight("level 0", 1)}, flight("Box2D", 2), choice);
    REQUIRE(film.shots.size() == 5);
    const Figure middle = film.shots[2].draw();
    REQUIRE(middle.panels.size() == 2);
    CHECK(middle.panels[1].title == "Box2D");
    CHECK(references<Path>(middle.panels[0]).size() == 1);
    CHECK(references<Path>(middle.panels[1]).empty());
    CHECK(middle.numbers[0].value.starts_with("0.50"));
    CHECK_NOTHROW(check_figure(middle));
}

TEST_CASE("a comparison without instants is refused", "[drawings]") {
    CHECK_THROWS_AS(comparison<2>({}, flight("Box2D", 2), 1), lod::Error);
    CHECK_THROWS_AS(comparison<2>({flight("level 0", 1)}, Run<2>{}, 1), lod::Error);
    CHECK_THROWS_AS(comparison_motion<2>({Run<2>{}}, flight("Box2D", 2)), lod::Error);
}
