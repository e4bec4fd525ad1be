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

std::string pairs_text(std::size_t pairs) {
    return shown_count(pairs) + (pairs == 1 ? " pair" : " pairs");
}

viz::Figure draw_level(const Scene& scene, std::size_t level) {
    const Front& front = scene.levels[level];
    const std::string name = std::to_string(level);
    viz::Figure figure =
        viz::traversal_level(scene.crescent, scene.star, scene.levels, static_cast<int>(level));
    figure.title = front.pairs.empty()
                       ? "Level " + name + ": no circles intersect, so the bodies are apart"
                       : "Level " + name + ": " + pairs_text(front.pairs.size()) +
                             (front.pairs.size() == 1 ? " intersects" : " intersect");
    figure.aspect = page_aspect;
    figure.caption.clear();
    figure.panels[0].title.clear();
    figure.panels[0].view = scene.view;
    figure.numbers = {{"level", name},
                      {"tests so far", shown_count(front.tests)},
                      {"verdict", in_words(front.verdict)}};
    return figure;
}

void name_numbers(Lesson& lesson, const Scene& scene) {
    for (std::size_t level = 0; level < scene.levels.size(); ++level) {
        const std::size_t pairs = scene.levels[level].pairs.size();
        const std::string name = std::to_string(level);
        lesson.numbers["tests " + name] = count(tests_of_level(scene, level));
        lesson.numbers["tests so far " + name] = count(scene.levels[level].tests);
        lesson.numbers["front " + name] = count(pairs, pairs == 1 ? "pair" : "pairs");
    }
}

/// What a step shows of a level.
Named numbers_of_level(std::size_t level) {
    const std::string name = std::to_string(level);
    return {{"tests at this level", "tests " + name},
            {"tests so far", "tests so far " + name},
            {"front", "front " + name}};
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

void step_roots(Lesson& lesson, const Scene& scene) {
    add_step(lesson, "Level 0: the two roots",
             "One distance test, crescent's root against star's root. They intersect, so the pair "
             "(root, root) goes on. The list of node pairs that go on is called the *front*; its "
             "circles are drawn bold. The verdict is *possible*: nothing is known yet.\n\n"
             "**Predict:** the crescent's root has " +
                 std::to_string(scene.crescent.body.tree->child_count[0]) +
                 " children, the star's has " +
                 std::to_string(scene.star.body.tree->child_count[0]) +
                 ". How many tests does level 1 take? Which of them will find an overlap?",
             draw_level(scene, 0), numbers_of_level(0));
}

std::string text_of_level(const Scene& scene, std::size_t level) {
    const std::size_t before = scene.levels[level - 1].pairs.size();
    const std::size_t now = scene.levels[level].pairs.size();
    std::string text =
        (before == 1 ? std::string("The only pair of the front is")
                     : "The " + pairs_text(before) + " of the front are") +
        " replaced: every child of the one node is tested against every child of the other, " +
        shown_count(tests_of_level(scene, level)) + " tests. ";
    if (now == 0)
        return text +
               "**None of them overlap.** Every point of the crescent lies in a circle of this "
               "level, every point of the star too, and no two of these circles share a point. So "
               "the bodies do not touch. This is proof, and the work on the pair is over; deeper "
               "levels are never looked at.";
    text += shown_count(now) + " of them overlap and form the new front. ";
    if (level == 1)
        text +=
            "Grey circles were tested and met nothing. None of what lies below them will be "
            "touched again: that is where the method saves its time.\n\n"
            "**Predict:** will the next level have more pairs, or fewer?";
    else if (now < before)
        text +=
            "The front has become smaller: closer circles hold less empty space, and what is left "
            "is the region where the bodies come nearest.";
    else
        text +=
            "The front has grown in number, but it covers a smaller part of the picture: finer "
            "circles, nearer to the place that matters.";
    return text;
}

void steps_near_miss(Lesson& lesson, const Scene& scene) {
    step_roots(lesson, scene);
    for (std::size_t level = 1; level < scene.levels.size(); ++level)
        add_step(lesson, "Level " + std::to_string(level), text_of_level(scene, level),
                 draw_level(scene, level), numbers_of_level(level));
}

/// All levels of a traversal side by side.
viz::Figure montage(const Scene& scene, const std::string& title) {
    viz::Figure figure = viz::traversal(scene.crescent, scene.star, scene.levels);
    for (std::size_t level = 0; level < figure.panels.size(); ++level) {
        const std::size_t pairs = scene.levels[level].pairs.size();
        figure.panels[level].view = scene.view;
        figure.panels[level].title = "Level " + std::to_string(level) + ": " +
                                     (pairs == 0 ? "no pairs, apart" : pairs_text(pairs));
    }
    figure.columns = figure.panels.size() == 4 ? 2 : 3;
    figure.aspect = page_aspect;
    figure.title = title;
    figure.numbers = {{"tests", shown_count(scene.tests())},
                      {"verdict", in_words(scene.levels.back().verdict)}};
    return figure;
}

void step_cost(Lesson& lesson, const Scene& scene) {
    const std::uint64_t all = leaves_of(scene.crescent) * leaves_of(scene.star);
    const std::uint64_t edges =
        edge_count(scene.crescent_shape.polygon) * edge_count(scene.star_shape.polygon);
    lesson.numbers["miss tests"] = count(scene.tests());
    lesson.numbers["leaf pairs"] = count(all);
    lesson.numbers["edge pairs"] = count(edges);
    lesson.numbers["miss levels"] = count(scene.levels.size() - 1);
    add_step(lesson, "What it cost",
             "The whole proof took {{number: miss tests}} distance tests. Trying every leaf of the "
             "crescent against every leaf of the star would take {{number: leaf pairs}}, every "
             "edge against every edge {{number: edge pairs}} dearer ones. And where the bodies are "
             "far apart, one test is enough.",
             montage(scene, "The star in the crescent's mouth: every level until the proof"),
             {{"tests", "miss tests"},
              {"pairs of leaves", "leaf pairs"},
              {"pairs of edges", "edge pairs"}},
             "near miss");
}

void step_collision(Lesson& lesson, const Scene& scene) {
    lesson.numbers["hit tests"] = count(scene.tests());
    lesson.numbers["hit pairs"] = count(scene.levels.back().pairs.size());
    const std::string truly = scene.truly_touch() ? "do touch" : "do not touch";
    add_step(
        lesson, "A true collision",
        "Now the star has moved over until one of its points reaches the crescent. The fronts "
        "never run empty, and the last of them holds {{number: hit pairs}} pairs of *leaves*. A "
        "leaf has no children, so there is nothing finer to ask: the verdict is *true collision*. "
        "(The outlines themselves " +
            truly +
            ", says an exact test. Leaves stand out of the shape a little, so a true collision of "
            "the trees may be a gap of the outlines, of no more than the two protrusions.)\n\n"
            "Three verdicts, then. **Apart** is proof at any level. **Possible** is the answer of "
            "every level above the leaves. **True** is what the leaves say.",
        montage(scene, "The star touches: every level down to the leaves"),
        {{"tests", "hit tests"}, {"pairs of leaves", "hit pairs"}}, "collision");
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

void step_interruption(Lesson& lesson, const Scene& scene) {
    const std::size_t cut = scene.levels.size() - 2;  // the level that is not finished
    const std::uint64_t quota = scene.levels[cut - 1].tests + (2 * tests_of_level(scene, cut)) / 3;
    const Front front = refine_within(scene.crescent.body, scene.star.body, quota);
    const auto level = static_cast<std::size_t>(front.level);
    lesson.numbers["quota"] = count(quota);
    lesson.numbers["finished level"] = count(level);
    lesson.numbers["cut level"] = count(cut);
    lesson.numbers["tests spent"] = count(front.tests);
    lesson.numbers["tests wasted"] = count(front.tests - scene.levels[level].tests);
    lesson.numbers["kept pairs"] = count(front.pairs.size());
    viz::Figure figure = draw_level(scene, level);
    figure.title = "Interrupted after " + shown_count(front.tests) + " tests: level " +
                   std::to_string(level) + " counts";
    figure.numbers = {{"budget", shown_count(quota) + " tests"},
                      {"last finished level", std::to_string(level)},
                      {"verdict", in_words(front.verdict)}};
    add_step(
        lesson, "Time is up: an interruption",
        "A frame of animation has a *budget*. Here it is {{number: quota}} distance tests. Level " +
            std::to_string(level) + " is finished after " + shown_count(scene.levels[level].tests) +
            " of them, level " + std::to_string(cut) +
            " is two thirds done when the budget ends.\n\n"
            "**Predict:** what should the program do with the two thirds?\n\n"
            "Throw them away. Half a level is a likeness of half the body: it could call bodies "
            "apart that touch in the other half. The result is the front of level " +
            std::to_string(level) + ", the last one that was **finished**, with " +
            pairs_text(front.pairs.size()) +
            ". What was *possible* there is now treated as a true collision. The answer is coarse, "
            "but it is there on time, and it never lets bodies through.",
        std::move(figure),
        {{"budget", "quota"},
         {"last finished level", "finished level"},
         {"tests without effect", "tests wasted"}},
        "interruption");
}

/// The finished level for every budget from 0 to enough.
viz::Polyline staircase(const Scene& scene, int series, const std::string& name) {
    viz::Polyline stairs{style(viz::Role::curve, series), {}, 1, name};
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

void step_budgets(Lesson& lesson, const Scene& miss, const Scene& hit) {
    viz::Panel panel;
    const double most = static_cast<double>(hit.tests()) * 1.08;
    panel.view = box(0, 0, most, static_cast<double>(hit.levels.size()) - 0.6);
    panel.axes = viz::Axes{{"budget [distance tests]", viz::Scale::linear, {}, true},
                           {"last finished level", viz::Scale::linear, {}, true}};
    panel.marks.push_back(staircase(miss, 0, "near miss"));
    panel.marks.push_back(staircase(hit, 1, "collision"));
    viz::Figure figure =
        figure_of(std::move(panel), "A larger budget buys whole levels",
                  "Two staircases over the budget in tests: the near miss reaches its proof at " +
                      shown_count(miss.tests()) + " tests, the collision its leaves at " +
                      shown_count(hit.tests()) + ".");
    figure.numbers = {{"proof of the miss", shown_count(miss.tests()) + " tests"},
                      {"leaves of the collision", shown_count(hit.tests()) + " tests"}};
    add_step(
        lesson, "What a budget buys",
        "The same two scenes, run again for every budget. Each stair is a level, its length is "
        "what the level costs. The answer changes only at the edge of a stair, so a budget that "
        "ends within one gives the answer of its beginning. The near miss is settled after " +
            shown_count(miss.tests()) +
            " tests, and a larger budget is simply not used. Tests that one pair leaves over go to "
            "the next.",
        std::move(figure), {}, "budgets");
}

void animate(Lesson& lesson, const Scene& miss, const Scene& hit) {
    lesson.animation.title = "A near miss and a collision, level by level";
    for (const Scene* scene : {&miss, &hit})
        for (std::size_t level = 0; level < scene->levels.size(); ++level) {
            const bool last = level + 1 == scene->levels.size();
            lesson.animation.shots.push_back(
                {[now = *scene, level] { return draw_level(now, level); }, last ? 60 : 36});
        }
}

}  // namespace

void make_traversal(Lesson& lesson) {
    const Scene miss = near_miss();
    const Scene hit = collision();
    name_numbers(lesson, miss);
    steps_near_miss(lesson, miss);
    step_cost(lesson, miss);
    step_collision(lesson, hit);
    step_interruption(lesson, hit);
    step_budgets(lesson, miss, hit);
    animate(lesson, miss, hit);
}

}  // namespace lessons
