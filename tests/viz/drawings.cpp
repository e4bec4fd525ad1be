#include <set>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/shape/outline.hpp"
#include "lodlab/viz/draw/draw_contacts.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"
#include "lodlab/viz/draw/draw_tree.hpp"
#include "lodlab/viz/draw/motion/draw_backtracking.hpp"
#include "lodlab/viz/draw/motion/draw_motion.hpp"
#include "lodlab/viz/figure/number_text.hpp"
#include "tests/catch.hpp"
#include "tests/viz/sample_scene.hpp"

using namespace viz;

namespace {

int discs_of(const Panel& panel, Role role) {
    int count = 0;
    for (const Mark& mark : panel.marks)
        if (const auto* disc = std::get_if<Disc>(&mark)) count += disc->style.role == role ? 1 : 0;
    return count;
}

template <class Kind>
int marks_of(const Panel& panel, Role role) {
    int count = 0;
    for (const Mark& mark : panel.marks)
        if (const auto* held = std::get_if<Kind>(&mark)) count += held->style.role == role ? 1 : 0;
    return count;
}

/// Two discs of one node each, meeting head-on (m 1, v 2 meets m 3, v -1).
Run<2> head_on(int frames) {
    const auto disc = [](double mass, double x, double speed) {
        lod::Body<2> body;
        lod::set_mass<2>(body, mass, lod::Inertia<2>::Constant(1));
        body.tree = std::make_shared<lod::SphereTree<2>>(lod::single_sphere<2>({{0, 0}, 0.5}));
        body.position = {x, 0};
        body.velocity = {speed, 0};
        return body;
    };
    Run<2> run;
    run.name = "exact";
    run.time_step = 1.0 / 64;
    run.visuals = {{"A", {}}, {"B", {}}};
    std::vector<lod::Body<2>> bodies{disc(1, -1, 2), disc(3, 1, -1)};
    lod::FrameSettings settings;
    settings.time_step = run.time_step;
    lod::FrameStorage<2> storage;
    for (int i = 0; i < frames; ++i) {
        const std::vector<lod::Body<2>> before = bodies;
        lod::Budget budget = lod::Budget::unlimited();
        add_instant(run, before, lod::advance<2>(bodies, settings, budget, storage));
    }
    add_instant(run, bodies, {});
    return run;
}

}  // namespace

TEST_CASE("the montage of a tree has a panel a level with that level's nodes", "[drawings]") {
    const Actor<2> actor = sample::actor("L", 0, 0, 0, 3);
    const Figure figure = tree_levels(actor);
    REQUIRE(static_cast<int>(figure.panels.size()) == actor.body.tree->levels());
    for (int level = 0; level < actor.body.tree->levels(); ++level)
        CHECK(discs_of(figure.panels[static_cast<std::size_t>(level)], Role::level_node) ==
              static_cast<int>(actor.body.tree->level_nodes(level).size()));
}

TEST_CASE("a montage of many levels shows the first five and the last", "[drawings]") {
    CHECK(montage_levels(9) == std::vector<int>{0, 1, 2, 3, 4, 8});
    CHECK(montage_levels(3) == std::vector<int>{0, 1, 2});
}

TEST_CASE("a traversal's bold nodes are those of the front, the thin ones those tested",
          "[drawings]") {
    const Actor<2> a = sample::actor("box", 0, 0, 0.3, 3);
    const Actor<2> b = sample::actor("star:5", 0.95, 0.1, 0, 3);
    const auto fronts = lod::traverse_levels(a.body, b.body);
    const Figure figure = traversal(a, b, fronts);
    for (std::size_t level = 0; level < fronts.size(); ++level) {
        std::set<int> of_a;
        std::set<int> of_b;
        for (const lod::NodePair& pair : fronts[level].pairs) {
            of_a.insert(pair.a);
            of_b.insert(pair.b);
        }
        const Panel& panel = figure.panels[level];
        const int bold =
            discs_of(panel, Role::meeting_node) + discs_of(panel, Role::true_collision);
        CHECK(bold >= static_cast<int>(of_a.size() + of_b.size()));
        const TestedNodes tested = tested_nodes(a.body, b.body, fronts, static_cast<int>(level));
        CHECK(discs_of(panel, Role::node) == static_cast<int>(tested.a.size() + tested.b.size()));
        for (const int node : of_a)
            CHECK(std::find(tested.a.begin(), tested.a.end(), node) != tested.a.end());
    }
}

TEST_CASE("the first tests of a level touch ever more of its nodes", "[drawings]") {
    const Actor<2> a = sample::actor("star:5", 0, 0, 0, 4);
    const Actor<2> b = sample::actor("star:5", 0.5, 0.3, 0.2, 4);
    const auto fronts = lod::traverse_levels(a.body, b.body);
    for (std::size_t level = 1; level < fronts.size(); ++level) {
        const lod::Front& before = fronts[level - 1];
        const std::uint64_t tests = fronts[level].tests - before.tests;
        std::size_t touched = 0;
        for (std::uint64_t some = 0; some <= tests; ++some) {
            const TestedNodes of = tested_nodes(a.body, b.body, before, some);
            CHECK(of.a.size() + of.b.size() >= touched);
            CHECK(of.a.size() * of.b.size() >= some / before.pairs.size());
            touched = of.a.size() + of.b.size();
            if (some == 1) CHECK(touched == 2);
        }
        CHECK(touched > 2);
        // More tests than there are: leaves that are carried on untested are not touched.
        CHECK(tested_nodes(a.body, b.body, before, tests + 1).a.size() ==
              tested_nodes(a.body, b.body, before, tests).a.size());
    }
    CHECK(tested_nodes(a.body, b.body, fronts[0], 0).a.empty());
}

TEST_CASE("a traversal of bodies that are apart says so", "[drawings]") {
    const Actor<2> a = sample::actor("star:5", 0, 0, 0, 4);
    const Actor<2> b = sample::actor("star:5", 0.9, 0.4, 0.2, 4);
    const auto fronts = lod::traverse_levels(a.body, b.body);
    REQUIRE(fronts.back().verdict == lod::Verdict::apart);
    const Figure figure = traversal(a, b, fronts);
    CHECK_THAT(figure.title, lodtest::contains("do not collide"));
    CHECK_THAT(figure.alt, lodtest::contains("not colliding"));
    CHECK(discs_of(figure.panels.back(), Role::meeting_node) == 0);
}

TEST_CASE("the construction of a contact states both points", "[drawings]") {
    // R = 2 and 1 at distance 2: 1.3333 by the radii, 1.75 on the plane.
    const Figure figure = contact_construction({{0, 0}, 2}, {{2, 0}, 1});
    CHECK(figure.numbers[1].value == "1.33\u00A0m");
    CHECK(figure.numbers[2].value == "1.75\u00A0m");
    CHECK_THROWS_AS(contact_construction({{0, 0}, 1}, {{5, 0}, 1}), lod::Error);
    CHECK_THROWS_AS(contact_construction({{0, 0}, 1}, {{0, 0}, 2}), lod::Error);
}

TEST_CASE("a strip shows start, detection and after of every run", "[drawings]") {
    const Run<2> run = head_on(64);
    const Figure figure = strips<2>({run, run});
    REQUIRE(figure.panels.size() == 6);
    CHECK(figure.row_titles == std::vector<std::string>{"exact", "exact"});
    // One true collision of two leaves, one contact, one impulse of j = 4.5.
    const Panel& detection = figure.panels[1];
    CHECK(discs_of(detection, Role::true_collision) == 2);
    CHECK(marks_of<Dot>(detection, Role::contact) == 1);
    REQUIRE(marks_of<Arrow>(detection, Role::impulse) == 1);
    for (const Mark& mark : detection.marks) {
        const auto* arrow = std::get_if<Arrow>(&mark);
        if (arrow && arrow->style.role == Role::impulse) {
            CHECK(arrow->label == "*j* = 4.5\u00A0N s");
        }
    }
    CHECK_THAT(figure.alt, lodtest::contains("A at 2.5\u00A0m/s"));
    CHECK_THAT(figure.alt, lodtest::contains("B at 0.5\u00A0m/s"));
}

TEST_CASE("the panels of a strip share one view, which holds all that moves", "[drawings]") {
    const Run<2> run = head_on(64);
    const Figure figure = strips<2>({run});
    const Box& view = figure.panels[0].view;
    for (const Panel& panel : figure.panels) {
        CHECK(panel.view.low == view.low);
        CHECK(panel.view.high == view.high);
    }
    CHECK(view.low.x <= -1.5);
    CHECK(view.high.x >= 1.5);
}

TEST_CASE("a run that never collides says so in its strip", "[drawings]") {
    const Run<2> run = head_on(5);
    const Figure figure = strips<2>({run});
    CHECK(figure.panels[1].title == "no collision");
    CHECK_THAT(figure.alt, lodtest::contains("no collision"));
    CHECK_THROWS_AS(strips<2>({Run<2>{}}), lod::Error);
}

TEST_CASE("bodies between two instants stand on the straight way between them", "[drawings]") {
    const Run<2> run = head_on(64);
    const auto bodies = bodies_at(run, 2.5 * run.time_step);
    CHECK(bodies[0].position.x() == Approx(-1 + 2 * 2.5 / 64));
    CHECK(bodies_at(run, 1e9)[0].position == run.instants.back().bodies[0].position);
}

TEST_CASE("the video of a collision pauses at the detection and ends where it begins",
          "[drawings]") {
    const Run<2> run = head_on(64);
    const Animation animation = impact_motion<2>({run});
    int with_contact = 0;
    for (const Shot& shot : animation.shots)
        with_contact += marks_of<Dot>(shot.draw().panels[0], Role::contact) > 0 ? 1 : 0;
    CHECK(with_contact >= 0.5 * animation.frames_per_second);
    const auto position = [](const Figure& figure) {
        for (const Mark& mark : figure.panels[0].marks)
            if (const auto* disc = std::get_if<Disc>(&mark)) return disc->centre;
        return Point{};
    };
    CHECK(position(animation.shots.back().draw()) == position(animation.shots.front().draw()));
}

TEST_CASE("a simulation's picture tells time and energy", "[drawings]") {
    const Run<2> run = head_on(64);
    const Figure figure = simulation_picture(run, 0.5);
    REQUIRE(figure.panels.size() == 3);
    CHECK(figure.numbers[0].value == "0.50\u00A0s");
    CHECK(figure.numbers[1].value == "3.5\u00A0J");  // 1/2 1 2^2 + 1/2 3 1^2
    const Animation animation =
        simulation_motion(run, {.frames_per_second = 30, .title = {}, .caption = {}});
    CHECK(frame_count(animation) == 31);
}

TEST_CASE("inappropriate backtracking shows both moments and the bodies apart", "[drawings]") {
    const auto passing = [](double x, double y, double speed) {
        Actor<2> actor = sample::actor("rod:2,0.2", x, y, 0, 3);
        actor.body.exact = std::make_shared<lod2d::ExactOutline>(lod2d::generate("rod:2,0.2"));
        actor.body.velocity = {speed, 0};
        return actor;
    };
    const Actor<2> a = passing(-2, 0, 1);
    const Figure figure =
        inappropriate_backtracking<2>(a, passing(2, 0.6, -1), {.level = 0, .horizon = 4});
    REQUIRE(figure.panels.size() == 3);
    CHECK(discs_of(figure.panels[0], Role::meeting_node) == 2);
    CHECK(discs_of(figure.panels[1], Role::meeting_node) == 0);
    CHECK(marks_of<Dot>(figure.panels[1], Role::contact) == 1);
    CHECK(discs_of(figure.panels[2], Role::node) == 0);
    CHECK(figure.numbers[1].value == length_text(0.4));
    CHECK(figure.alt.find("never touch") != std::string::npos);
    // Nothing is inappropriate where the bodies collide, or where the nodes don't.
    CHECK_THROWS_AS(
        (inappropriate_backtracking<2>(a, passing(2, 0.1, -1), {.level = 0, .horizon = 4})),
        lod::Error);
    CHECK_THROWS_AS(
        (inappropriate_backtracking<2>(a, passing(2, 5, -1), {.level = 0, .horizon = 4})),
        lod::Error);
}
