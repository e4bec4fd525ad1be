#include "lessons/course/06_interruption/lesson.hpp"

#include <algorithm>

#include "lodlab/viz/draw/draw_traversal.hpp"

namespace lessons {
namespace interruption {
namespace {

using lod::Body;
using lod::Budget;
using lod::NodePair;
using lod::Priority;
using Vec = lod::Vector<2>;

constexpr double chart_aspect = 1.6;  ///< of a chart alone

/// The four bodies, with the circles of a level of each pair; -1: none.
viz::Panel draw(const Scene& scene, const std::array<int, 2>& levels) {
    viz::Panel panel;
    std::vector<lod::Sphere<2>> roots;
    for (const Body<2>& body : scene.bodies()) roots.push_back(viz::carried_node(body, 0));
    panel.view = viz::grown(box_round(roots), 0.02);
    for (std::size_t p = 0; p < scene.pairs.size(); ++p) {
        const Pair& pair = scene.pairs[p];
        add_body(panel, pair.a, 0);
        add_body(panel, pair.b, 1);
        viz::add_names(panel, pair.a, pair.b,
                       levels[p] == 0 ? viz::Beside::roots : viz::Beside::outlines);
        if (levels[p] < 0) continue;
        const auto tested = viz::tested_nodes(pair.a.body, pair.b.body, pair.levels, levels[p]);
        viz::add_nodes<2>(panel, pair.a.body, tested.a, viz::Role::node, 0);
        viz::add_nodes<2>(panel, pair.b.body, tested.b, viz::Role::node, 1);
        viz::add_meeting_nodes<2>(panel, {pair.a.body, 0}, {pair.b.body, 1},
                                  pair.levels[static_cast<std::size_t>(levels[p])].pairs);
    }
    return panel;
}

/// What counts after these turns, above the turns themselves.
viz::Figure draw_turns(const Scene& scene, const std::vector<Turn>& turns, std::uint64_t quota) {
    viz::Figure figure = figure_of(draw(scene, finished(turns)));
    figure.panels.push_back(chart(turns, scene.tests(), quota));
    figure.columns = 1;
    figure.row_weights = {1.2, 1};
    figure.aspect = 1.1;
    figure.scale_bar = false;
    return figure;
}

void give_levels(Lesson& lesson, const Scene& scene) {
    give(lesson, "bodies", draw(scene, {-1, -1}));
    give(lesson, "roots", draw(scene, {0, 0}));
    for (std::size_t p = 0; p < scene.pairs.size(); ++p) {
        const std::string name = "pair " + std::to_string(p + 1) + " ";
        for (std::size_t level = 1; level < scene.costs[p].size(); ++level)
            give(lesson, name + std::to_string(level), count(scene.costs[p][level]));
        give(lesson, name + "tests", count(scene.pairs[p].levels.back().tests));
    }
    std::uint64_t done = 0;
    for (const lod::PairRecord& pair : detect(scene, Priority::level_order, Budget::node_tests(1)))
        done += pair.tests;
    give(lesson, "least", count(done));
    give(lesson, "tests", count(scene.tests()));
    const auto turns = turns_of(scene.costs, Priority::level_order, Stop::counted, scene.tests());
    viz::Figure figure = figure_of(chart(turns, scene.tests(), 0));
    figure.aspect = chart_aspect;
    give(lesson, "turns", std::move(figure));
}

/// Just enough for pair 2 to finish what pair 1 has not enough for.
std::uint64_t quota_of(const Scene& scene) {
    return 2 + scene.costs[0][1] + scene.costs[1][1] + scene.costs[1][2];
}

void give_clock(Lesson& lesson, const Scene& scene, std::uint64_t quota) {
    const auto turns = turns_of(scene.costs, Priority::level_order, Stop::clock, quota);
    const auto records = detect_until(scene, quota);
    const Turn& cut = turns.back();
    give(lesson, "quota", count(quota));
    give(lesson, "cut level", count(cut.level));
    give(lesson, "cut cost", count(scene.costs[0][static_cast<std::size_t>(cut.level)]));
    give(lesson, "lost", count(cut.tests));
    give(lesson, "before cut", count(cut.begin));
    give(lesson, "clock 1", count(records[0].level));
    give(lesson, "clock 2", count(records[1].level));
    viz::Figure ticking = figure_of(chart(turns, scene.tests(), quota));
    ticking.aspect = chart_aspect;
    give(lesson, "clock", std::move(ticking));
    give(lesson, "kept", draw_turns(scene, turns, quota));
    give_part(lesson, scene.pairs[0], cut);
}

/// A small tree: inner circles with four leaves each, and one leaf beside them.
lod::SphereTree<2> uneven_tree() {
    constexpr int children = 4;
    std::vector<lod::TreeNode<2>> nodes(1);
    const auto add = [&](int parent) {
        const auto node = static_cast<int>(nodes.size());
        nodes.push_back({{Vec(0, 0), 1}, Vec::Zero(), {}});
        nodes[static_cast<std::size_t>(parent)].children.push_back(node);
        return node;
    };
    for (int inner = 0; inner < 2; ++inner)
        for (int parent = add(0), leaf = 0; leaf < children; ++leaf) (void)add(parent);
    (void)add(0);
    return lod::lay_out<2>(nodes);
}

void give_fits(Lesson& lesson, const Scene& scene, std::uint64_t quota) {
    const lod::SphereTree<2> tree = uneven_tree();
    const std::vector<NodePair> front{{1, 1}, {2, 2}, {3, 1}};  // node 3 is the leaf
    give(lesson, "uneven", count(lod::next_level_tests<2>(tree, tree, front)));
    const auto turns = turns_of(scene.costs, Priority::level_order, Stop::counted, quota);
    const auto records = detect(scene, Priority::level_order, Budget::node_tests(quota));
    const auto first = detect(scene, Priority::first_come, Budget::node_tests(quota));
    std::uint64_t spent = 0;
    for (const lod::PairRecord& pair : records) spent += pair.tests;
    give(lesson, "counted 1", count(records[0].level));
    give(lesson, "counted 2", count(records[1].level));
    give(lesson, "counted spent", count(spent));
    give(lesson, "fits", draw_turns(scene, turns, quota));
    give(lesson, "first 1", count(first[0].level));
    give(lesson, "first 2", count(first[1].level));
    const auto in_line = turns_of(scene.costs, Priority::first_come, Stop::counted, quota);
    give(lesson, "first come", draw_turns(scene, in_line, quota));
}

/// Just enough for pair 1 to finish what it had not enough for.
void give_larger(Lesson& lesson, const Scene& scene, std::uint64_t quota) {
    const std::uint64_t larger = quota + scene.costs[0][2] - scene.costs[1][2] + 1;
    const auto records = detect(scene, Priority::level_order, Budget::node_tests(larger));
    give(lesson, "larger", count(larger));
    give(lesson, "larger 1", count(records[0].level));
    give(lesson, "larger 2", count(records[1].level));
    const auto turns = turns_of(scene.costs, Priority::level_order, Stop::counted, larger);
    give(lesson, "larger budget", draw_turns(scene, turns, larger));
}

/// The last finished level of a pair for every budget.
viz::Polyline staircase(const Scene& scene, std::size_t pair) {
    viz::Polyline stairs = curve(static_cast<int>(pair), "pair " + std::to_string(pair + 1));
    double level = 0;
    const double lift = pair == 0 ? 0 : 0.03;  // so that one does not hide the other
    stairs.points.push_back({0, lift});
    for (std::uint64_t quota = 1; quota <= scene.tests() + 5; ++quota) {
        const auto records = detect(scene, Priority::level_order, Budget::node_tests(quota));
        const auto x = static_cast<double>(quota);
        if (records[pair].level != level) {
            stairs.points.push_back({x, level + lift});
            level = records[pair].level;
            stairs.points.push_back({x, level + lift});
        }
        if (quota == scene.tests() + 5) stairs.points.push_back({x, level + lift});
    }
    return stairs;
}

/// Every point of interruption, by the rule and by the program.
/// Both pairs, each finer while the budget lasts.
live::Scene play(const Scene& scene, std::uint64_t quota) {
    std::vector<viz::Actor<2>> actors;
    for (const Pair& pair : scene.pairs) {
        actors.push_back(pair.a);
        actors.push_back(pair.b);
    }
    live::Scene play = to_play_with(std::move(actors), viz::grown(draw(scene, {0, 0}).view, 0.05),
                                    live::Told::verdicts);
    play.settings.priority = Priority::level_order;
    play.settings.contact_model = lod::ContactModel::centre_line;
    play.budget = quota;
    return play;
}

void give_every_cut(Lesson& lesson, const Scene& scene) {
    int misses = 0;
    int differences = 0;
    int stops = 0;
    for (std::uint64_t tests = 2; tests < scene.tests(); ++tests) {
        const auto counted = detect(scene, Priority::level_order, Budget::node_tests(tests));
        const auto clocked = detect_until(scene, tests);
        for (const auto& [records, stop] :
             {std::pair{&counted, Stop::counted}, std::pair{&clocked, Stop::clock}}) {
            const auto rule = finished(turns_of(scene.costs, Priority::level_order, stop, tests));
            ++stops;
            misses += (*records)[0].verdict == lod::Verdict::apart ? 1 : 0;
            for (std::size_t p = 0; p < rule.size(); ++p)
                differences += (*records)[p].level == rule[p] ? 0 : 1;
        }
    }
    give(lesson, "stops", count(stops));
    give(lesson, "misses", count(misses));
    give(lesson, "differences", count(differences));
    viz::Panel panel;
    panel.view = box(0, 0, static_cast<double>(scene.tests()) * 1.08, depth + 0.4);
    panel.axes = viz::Axes{{"budget [tests]", viz::Scale::linear, {}, true},
                           {"last finished level", viz::Scale::linear, {}, true}};
    for (std::size_t pair = 0; pair < scene.pairs.size(); ++pair)
        panel.marks.push_back(staircase(scene, pair));
    give(lesson, "budgets", std::move(panel));
}

void animate(Lesson& lesson, const Scene& scene) {
    const std::string title = video_words(lesson, "title");
    constexpr std::uint64_t stride = 2;
    const std::uint64_t all = scene.tests();
    for (std::uint64_t quota = 2; quota <= all; quota += stride)
        lesson.animation.shots.push_back(
            {[scene, quota, title] {
                 viz::Figure figure = draw_turns(
                     scene, turns_of(scene.costs, Priority::level_order, Stop::clock, quota),
                     quota);
                 figure.title = title;
                 return figure;
             },
             quota + stride > all ? 60 : 4});
}

}  // namespace
}  // namespace interruption

void make_interruption(Lesson& lesson) {
    const interruption::Scene scene;
    const std::uint64_t quota = interruption::quota_of(scene);
    interruption::give_levels(lesson, scene);
    interruption::give_clock(lesson, scene, quota);
    interruption::give_larger(lesson, scene, quota);
    interruption::give_fits(lesson, scene, quota);
    interruption::give_every_cut(lesson, scene);
    give(lesson, interruption::play(scene, quota));
    interruption::animate(lesson, scene);
}

}  // namespace lessons
