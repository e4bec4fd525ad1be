#include <algorithm>
#include <cmath>

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/tree/traversal.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"

namespace lessons {
namespace {

using lod::Body;
using lod::Budget;
using lod::Front;
using lod::NodePair;
using lod::PosedTree;
using Vec = lod::Vector<2>;

constexpr int depth = 4;

/// A crescent and a star, with every level of their traversal.
struct Scene {
    lod2d::Shape crescent_shape = scaled(lod2d::generate("crescent"), 2);
    lod2d::Shape star_shape = scaled(lod2d::generate("star:5"), 0.9);
    viz::Actor<2> crescent = actor("crescent", crescent_shape, tree_of(crescent_shape, depth));
    viz::Actor<2> star = actor("star", star_shape, tree_of(star_shape, depth));
    std::vector<Front> levels;
    viz::Box view;

    [[nodiscard]] std::uint64_t tests() const { return levels.back().tests; }
    [[nodiscard]] bool truly_touch() const {
        return lod2d::overlap(outline_of(crescent_shape, crescent.body),
                              outline_of(star_shape, star.body));
    }
};

std::uint64_t tests_of_level(const Scene& scene, std::size_t level) {
    return scene.levels[level].tests - (level > 0 ? scene.levels[level - 1].tests : 0);
}

viz::Figure draw_level(const Scene& scene, std::size_t level) {
    const Front& front = scene.levels[level];
    viz::Figure figure =
        viz::traversal_level(scene.crescent, scene.star, scene.levels, static_cast<int>(level));
    figure.aspect = page_aspect;
    figure.caption.clear();
    figure.panels[0].title.clear();
    figure.panels[0].view = scene.view;
    figure.numbers = {{"level", std::to_string(level)},
                      {"tests so far", shown_count(front.tests)},
                      {"verdict", in_words(front.verdict)}};
    return figure;
}

/// Stands the star at x, a little above the middle of the crescent's mouth, and traverses anew.
void place_star(Scene& scene, double x) {
    scene.star.body.position = Vec(x, 0.02);
    scene.star.body.orientation = 0.3;
    scene.levels = lod::traverse_levels<2>(scene.crescent.body, scene.star.body);
}

/// The box round every circle that a test touches.
void frame_scene(Scene& scene) {
    std::vector<lod::Sphere<2>> discs;
    for (int level = 0; level < static_cast<int>(scene.levels.size()); ++level) {
        const viz::TestedNodes tested =
            viz::tested_nodes(scene.crescent.body, scene.star.body, scene.levels, level);
        for (int node : tested.a) discs.push_back(viz::carried_node(scene.crescent.body, node));
        for (int node : tested.b) discs.push_back(viz::carried_node(scene.star.body, node));
    }
    scene.view = viz::grown(box_round(discs), 0.02);
}

constexpr double outside = 0.8;     ///< x of a star that is well within the mouth [m]
constexpr double approach = 0.005;  // [m] a try

/// The first place on the way in where the proof takes three levels.
Scene near_miss() {
    constexpr std::size_t wanted = 4;  // levels 0 to 3
    Scene scene;
    double x = outside;
    do place_star(scene, x -= approach);
    while (scene.levels.size() < wanted);
    frame_scene(scene);
    return scene;
}

/// Where the star has just gone in a little way.
Scene collision() {
    constexpr double inside = 0.03;  // [m]
    Scene scene;
    double x = outside;
    do place_star(scene, x -= approach);
    while (!scene.truly_touch());
    place_star(scene, x - inside);
    frame_scene(scene);
    return scene;
}

std::uint64_t leaves_of(const viz::Actor<2>& actor) {
    const auto& counts = actor.body.tree->child_count;
    return static_cast<std::uint64_t>(std::count(counts.begin(), counts.end(), 0));
}

/// "1 of them overlaps and forms", "4 of them overlap and form".
Number overlapping(std::size_t pairs) {
    return words(shown_count(pairs) +
                 (pairs == 1 ? " of them overlaps and forms" : " of them overlap and form"));
}

void give_levels(Lesson& lesson, const Scene& scene) {
    for (std::size_t level = 0; level < scene.levels.size(); ++level) {
        const std::size_t pairs = scene.levels[level].pairs.size();
        const std::string name = std::to_string(level);
        give(lesson, "tests " + name, count(tests_of_level(scene, level)));
        give(lesson, "tests so far " + name, count(scene.levels[level].tests));
        give(lesson, "front " + name, count(pairs, pairs == 1 ? "pair" : "pairs"));
        give(lesson, "level " + name, draw_level(scene, level));
        if (level + 1 == scene.levels.size()) continue;  // its front is empty
        give(lesson, "front " + name + " meet", words(pairs == 1 ? "intersects" : "intersect"));
        if (level > 0) give(lesson, "front " + name + " overlap", overlapping(pairs));
        if (level % 2 == 0)
            give(lesson, "front " + name + " all",
                 words(pairs == 1 ? "The only pair" : "Each pair"));
    }
    const auto children = [](const viz::Actor<2>& actor) {
        return count(actor.body.tree->child_count[0]);
    };
    give(lesson, "crescent children", children(scene.crescent));
    give(lesson, "star children", children(scene.star));
}

/// The circles of level 1 before they are tested, with a number beside each: which of them meet one
/// of the other body?
void give_level_1_untested(Lesson& lesson, const Scene& scene) {
    viz::Panel panel;
    Picks picks;
    std::vector<lod::Sphere<2>> circles;
    const std::array<const viz::Actor<2>*, 2> actors{&scene.crescent, &scene.star};
    for (std::size_t body = 0; body < actors.size(); ++body)
        add_body(panel, *actors[body], static_cast<int>(body));
    const viz::TestedNodes tested =
        viz::tested_nodes(scene.crescent.body, scene.star.body, scene.levels, 1);
    for (std::size_t body = 0; body < actors.size(); ++body) {
        const int number = static_cast<int>(body);
        const std::vector<int>& nodes = body == 0 ? tested.a : tested.b;
        viz::add_nodes<2>(panel, actors[body]->body, nodes, viz::Role::level_node, number);
        for (const int node : nodes) {
            const lod::Sphere<2> circle = viz::carried_node(actors[body]->body, node);
            circles.push_back(circle);
            const std::string name = shown_count(picks.size() + 1);
            const bool meets = std::any_of(
                scene.levels[1].pairs.begin(), scene.levels[1].pairs.end(),
                [&](const NodePair& pair) { return (body == 0 ? pair.a : pair.b) == node; });
            const bool meets_own = std::any_of(nodes.begin(), nodes.end(), [&](int other) {
                return other != node &&
                       lod::overlap(circle, viz::carried_node(actors[body]->body, other));
            });
            picks.push_back(
                {name, at(circle.centre), circle.radius, meets, meets_own ? "own" : ""});
            add_label(panel, viz::Role::body, circle.centre, name, number);
        }
    }
    panel.view = viz::grown(box_round(circles), 0.06);
    give(lesson, "level 1 untested", std::move(panel));
    give(lesson, "circles of level 1", std::move(picks));
}

/// All levels of a traversal side by side.
viz::Figure montage(const Scene& scene) {
    viz::Figure figure = viz::traversal(scene.crescent, scene.star, scene.levels);
    for (viz::Panel& panel : figure.panels) panel.view = scene.view;
    figure.columns = figure.panels.size() == 4 ? 2 : 3;
    figure.aspect = page_aspect;
    name_levels(figure, scene.levels);
    return figure;
}

void give_cost(Lesson& lesson, const Scene& scene) {
    give(lesson, "miss tests", count(scene.tests()));
    give(lesson, "leaf pairs", count(leaves_of(scene.crescent) * leaves_of(scene.star)));
    give(lesson, "edge pairs",
         count(edge_count(scene.crescent_shape.polygon) * edge_count(scene.star_shape.polygon)));
    give(lesson, "miss levels", count(scene.levels.size() - 1));
    give(lesson, "near miss", montage(scene));
}

void give_collision(Lesson& lesson, const Scene& scene) {
    give(lesson, "hit tests", count(scene.tests()));
    give(lesson, "hit pairs", count(scene.levels.back().pairs.size()));
    give(lesson, "outlines", words(scene.truly_touch() ? "do touch" : "do not touch"));
    give(lesson, "collision", montage(scene));
}

// listing: interruption
/// The front of two bodies when `quota` distance tests may be spent on them.
Front refine_within(const Body<2>& body_a, const Body<2>& body_b, std::uint64_t quota) {
    PosedTree<2> world_a, world_b;
    world_a.pose(body_a);
    world_b.pose(body_b);
    Budget budget = Budget::node_tests(quota);
    lod::FrontList list;
    lod::ListedFront front;
    lod::test_roots(world_a, world_b, front, list);  // level 0 is always done
    budget.spend(1);
    while (!front.finest)
        if (lod::refine(world_a, world_b, budget, front, list) == lod::Refinement::interrupted)
            break;  // the front is still that of the last finished level
    return list.front(front);
}
// end of listing

void give_interruption(Lesson& lesson, const Scene& scene) {
    const std::size_t cut = scene.levels.size() - 2;  // the level that is not finished
    const std::uint64_t quota = scene.levels[cut - 1].tests + (2 * tests_of_level(scene, cut)) / 3;
    const Front front = refine_within(scene.crescent.body, scene.star.body, quota);
    const auto level = static_cast<std::size_t>(front.level);
    give(lesson, "quota", count(quota));
    give(lesson, "finished level", count(level));
    give(lesson, "finished tests", count(scene.levels[level].tests));
    give(lesson, "cut level", count(cut));
    give(lesson, "tests spent", count(front.tests));
    give(lesson, "tests wasted", count(front.tests - scene.levels[level].tests));
    give(lesson, "kept pairs", words(pairs_text(front.pairs.size())));
    viz::Figure figure = draw_level(scene, level);
    figure.numbers = {{"budget", shown_count(quota) + " tests"}};
    give(lesson, "time is up", figure);
    figure.numbers = {{"budget", shown_count(quota) + " tests"},
                      {"last finished level", std::to_string(level)},
                      {"verdict", in_words(front.verdict)}};
    give(lesson, "interruption", std::move(figure));
}

/// The finished level for every budget from 0 to enough.
viz::Polyline staircase(const Scene& scene, int series, const std::string& name) {
    viz::Polyline stairs = curve(series, name);
    double level = 0;
    const std::uint64_t enough = scene.tests() + scene.tests() / 20;
    for (std::uint64_t quota = 1; quota <= enough; ++quota) {
        const Front front = refine_within(scene.crescent.body, scene.star.body, quota);
        const auto x = static_cast<double>(quota);
        if (quota == 1 || front.level != level) {
            if (quota > 1) stairs.points.push_back({x, level});
            level = front.level;
            stairs.points.push_back({x, level});
        }
    }
    stairs.points.push_back({static_cast<double>(enough), level});
    return stairs;
}

void give_budgets(Lesson& lesson, const Scene& miss, const Scene& hit) {
    viz::Panel panel;
    const double most = static_cast<double>(hit.tests()) * 1.08;
    panel.view = box(0, 0, most, static_cast<double>(hit.levels.size()) - 0.6);
    panel.axes = viz::Axes{{"budget [distance tests]", viz::Scale::linear, {}, true},
                           {"last finished level", viz::Scale::linear, {}, true}};
    panel.marks.push_back(staircase(miss, 0, "near miss"));
    panel.marks.push_back(staircase(hit, 1, "collision"));
    viz::Figure figure = figure_of(std::move(panel));
    figure.numbers = {{"proof of the miss", shown_count(miss.tests()) + " tests"},
                      {"leaves of the collision", shown_count(hit.tests()) + " tests"}};
    give(lesson, "budgets", std::move(figure));
}

void animate(Lesson& lesson, const Scene& miss, const Scene& hit) {
    const std::string proved = video_words(lesson, "apart");
    for (const Scene* scene : {&miss, &hit})
        for (std::size_t level = 0; level < scene->levels.size(); ++level) {
            const std::size_t pairs = scene->levels[level].pairs.size();
            const std::string found =
                pairs == 0 ? proved
                           : pairs_text(pairs) + (pairs == 1 ? " intersects" : " intersect");
            const auto draw = [now = *scene, level, found] {
                viz::Figure figure = draw_level(now, level);
                figure.title = "Level " + std::to_string(level) + ": " + found;
                return figure;
            };
            lesson.animation.shots.push_back({draw, level + 1 == scene->levels.size() ? 60 : 36});
        }
}

}  // namespace

void make_traversal(Lesson& lesson) {
    const Scene miss = near_miss();
    const Scene hit = collision();
    give_levels(lesson, miss);
    give_level_1_untested(lesson, miss);
    give_cost(lesson, miss);
    give_collision(lesson, hit);
    give_interruption(lesson, hit);
    give_budgets(lesson, miss, hit);
    give(lesson, to_play_with({miss.crescent, miss.star}, viz::grown(miss.view, 0.1),
                              live::Told::verdicts));
    animate(lesson, miss, hit);
}

}  // namespace lessons
