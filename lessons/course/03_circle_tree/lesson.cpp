#include <algorithm>
#include <cmath>

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/meeting.hpp"
#include "lodlab/core/builder/certify.hpp"
#include "lodlab/lod2d/builder/piece.hpp"
#include "lodlab/lod2d/builder/tree_report.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/viz/draw/draw_tree.hpp"

namespace lessons {
namespace tree {
namespace {

using lod::Sphere;
using Tree = lod::SphereTree<2>;
using Facts = std::vector<lod2d::LevelReport>;

/// The shape of the lesson with its tree and what each level is worth.
struct Crescent {
    lod2d::Shape shape;
    std::shared_ptr<const Tree> tree;
    viz::Actor<2> body;
    viz::Box view;  ///< holds every circle, so that all pictures share it
    Facts facts;
};

// listing: pieces
std::vector<lod2d::PolygonPiece> pieces_of_children(const lod2d::PolygonPiece& piece,
                                                    const Tree& tree, int node) {
    std::vector<Sphere<2>> children;
    for (int c = 0; c < tree.child_count[Tree::index(node)]; ++c)
        children.push_back(tree.sphere(tree.first_child[Tree::index(node)] + c));
    return lod::split<2>(piece, children);
}
// end of listing

Crescent make_crescent() {
    constexpr int depth = 3;
    Crescent crescent;
    crescent.shape = scaled(lod2d::generate("crescent"), 2);
    crescent.tree = tree_of(crescent.shape, depth);
    crescent.body = actor("crescent", crescent.shape, crescent.tree);
    crescent.facts = lod2d::report_tree(crescent.shape, *crescent.tree).levels;
    std::vector<Sphere<2>> discs;
    for (int node = 0; node < crescent.tree->size(); ++node)
        discs.push_back(crescent.tree->sphere(node));
    crescent.view = viz::grown(box_round(discs), 0.02);
    return crescent;
}

/// A level over the outline, in the view that all pictures share.
viz::Figure draw_level(const Crescent& crescent, int level) {
    const lod2d::LevelReport& facts = crescent.facts[static_cast<std::size_t>(level)];
    viz::Figure figure = viz::tree_level(crescent.body, level);
    figure.caption.clear();
    figure.aspect = page_aspect;
    figure.panels[0].view = crescent.view;
    figure.numbers = {{"level", std::to_string(level)},
                      {"circles", shown_count(facts.nodes)},
                      {"stand out by", shown(facts.worst_protrusion, 3) + " m"}};
    return figure;
}

double largest_radius(const Tree& tree, int level) {
    double largest = 0;
    for (const int node : tree.level_nodes(level))
        largest = std::max(largest, tree.radius[Tree::index(node)]);
    return largest;
}

void give_levels(Lesson& lesson, const Crescent& crescent) {
    for (const lod2d::LevelReport& level : crescent.facts) {
        const std::string name = std::to_string(level.level);
        give(lesson, "circles " + name, count(level.nodes));
        give(lesson, "worst " + name, number(level.worst_protrusion, 3, "m"));
        give(lesson, "mean " + name, number(level.mean_protrusion, 4, "m"));
        give(lesson, "area " + name, number(level.measure_ratio, 3));
        if (level.level == 1) continue;  // the pieces have a picture of their own
        give(lesson, "radius " + name, number(largest_radius(*crescent.tree, level.level), 3, "m"));
        give(lesson, level.level == 0 ? "root" : "level " + name,
             draw_level(crescent, level.level));
    }
    constexpr int most_children = 4;
    give(lesson, "most circles", count(most_children * most_children * most_children));
    give(lesson, "filled share", number(100 / crescent.facts[0].measure_ratio, 0, "%"));
    for (const std::size_t level : {2, 3})
        give(lesson, "gain " + std::to_string(level),
             number(crescent.facts[level - 1].worst_protrusion /
                        crescent.facts[level].worst_protrusion,
                    1));
}

void give_pieces(Lesson& lesson, const Crescent& crescent) {
    const Tree& tree = *crescent.tree;
    viz::Panel panel;
    panel.view = crescent.view;
    const auto pieces = pieces_of_children(lod2d::PolygonPiece(crescent.shape.polygon), tree, 0);
    add_ball(panel, tree.sphere(0), style(viz::Role::node, 0, 0));
    for (std::size_t c = 0; c < pieces.size(); ++c)
        add_piece(panel, pieces[c].parts(), static_cast<int>(c));
    for (int c = 0; c < tree.child_count[0]; ++c)
        add_ball(panel, tree.sphere(tree.first_child[0] + c), style(viz::Role::level_node, c, 1));
    viz::Figure figure = figure_of(std::move(panel));
    figure.numbers = {{"level", "1"},
                      {"circles", std::to_string(pieces.size())},
                      {"stand out by", lesson.numbers["worst 1"].text}};
    give(lesson, "pieces", std::move(figure));
    const auto smaller = [](const auto& a, const auto& b) { return a.measure() < b.measure(); };
    const auto [least, most] = std::minmax_element(pieces.begin(), pieces.end(), smaller);
    give(lesson, "smallest piece", number(least->measure(), 3, "m²"));
    give(lesson, "largest piece", number(most->measure(), 3, "m²"));
    const auto levels = lod::certify<2>(tree, lod2d::PolygonPiece(crescent.shape.polygon));
    give(lesson, "certified levels",
         count(std::count_if(levels.begin(), levels.end(),
                             [](const lod::LevelCertificate& level) { return level.certified; })));
}

/// How far a node reaches outside its parent [m]; 0 or less when it does not.
double beyond_parent(const Tree& tree, int node) {
    const Sphere<2> child = tree.sphere(node);
    const Sphere<2> parent = tree.sphere(tree.parent[Tree::index(node)]);
    return (child.centre - parent.centre).norm() + child.radius - parent.radius;
}

void give_outside(Lesson& lesson, const Crescent& crescent) {
    constexpr double rounding = 1e-9;  // [m]
    const Tree& tree = *crescent.tree;
    int outside = 0;
    int farthest = 1;
    for (int node = 1; node < tree.size(); ++node) {
        if (beyond_parent(tree, node) > rounding) ++outside;
        if (beyond_parent(tree, node) > beyond_parent(tree, farthest)) farthest = node;
    }
    const int parent = tree.parent[Tree::index(farthest)];
    viz::Panel panel;
    panel.view = crescent.view;
    add_body(panel, crescent.body, 0);
    add_ball(panel, tree.sphere(parent), style(viz::Role::node, 0));
    add_ball(panel, tree.sphere(farthest), style(viz::Role::meeting_node, 0));
    add_label(panel, viz::Role::note, tree.sphere(parent).centre, "parent", 0,
              tree.radius[Tree::index(parent)]);
    add_label(panel, viz::Role::note, tree.sphere(farthest).centre, "child", 0,
              tree.radius[Tree::index(farthest)]);
    give(lesson, "children outside", count(outside));
    give(lesson, "nodes with parents", count(tree.size() - 1));
    viz::Figure figure = figure_of(std::move(panel));
    figure.numbers = {
        {"reach outside", shown_count(outside) + " of " + shown_count(tree.size() - 1)}};
    give(lesson, "outside", std::move(figure));
}

void give_builders(Lesson& lesson, const Crescent& crescent) {
    constexpr int level = 3;
    viz::Figure figure;
    figure.columns = static_cast<int>(lod::choices<lod2d::Builder>().size());
    for (const lod2d::Builder builder : lod::choices<lod2d::Builder>()) {
        const std::string name(lod::name_of(builder));
        const auto tree = tree_of(crescent.shape, level, builder);
        const lod2d::LevelReport facts = lod2d::report_tree(crescent.shape, *tree).levels.back();
        viz::Figure one = viz::tree_level(actor("crescent", crescent.shape, tree), level);
        one.panels[0].view = crescent.view;
        one.panels[0].title = name + ": " + shown_count(facts.nodes) + " circles";
        figure.panels.push_back(std::move(one.panels[0]));
        give(lesson, name + " circles", count(facts.nodes));
        give(lesson, name + " worst", number(facts.worst_protrusion, 3, "m"));
        give(lesson, name + " area", number(facts.measure_ratio, 2));
    }
    give(lesson, "builders", std::move(figure));
}

/// A star whose level 1 stands out further than its root.
void give_star(Lesson& lesson) {
    const lod2d::Shape shape = scaled(lod2d::generate("star:5"), 2);
    const auto tree = tree_of(shape, 2);
    const viz::Actor<2> star = actor("star", shape, tree);
    std::vector<viz::Panel> panels;
    for (const lod2d::LevelReport& facts : lod2d::report_tree(shape, *tree).levels) {
        const std::string level = std::to_string(facts.level);
        give(lesson, "star worst " + level, number(facts.worst_protrusion, 3, "m"));
        if (facts.level == 2) break;
        give(lesson, "star area " + level, number(facts.measure_ratio, 2));
        std::vector<Sphere<2>> circles;
        for (const int node : tree->level_nodes(facts.level)) circles.push_back(tree->sphere(node));
        viz::Panel panel = viz::tree_level(star, facts.level).panels[0];
        panel.view = box(-1.35, -1.35, 1.35, 1.35);
        panel.title = "level " + level;
        add_whisker(panel, lod2d::BoundaryIndex(shape.polygon), circles, 1);
        panels.push_back(std::move(panel));
        if (facts.level == 1) give(lesson, "star circles 1", count(circles.size()));
    }
    give(lesson, "star", figure_of(std::move(panels), 2));
}

viz::Polyline curve_of(const Facts& facts, double lod2d::LevelReport::*value, int series,
                       const std::string& name) {
    viz::Polyline curve = lessons::curve(series, name);
    for (const lod2d::LevelReport& level : facts)
        curve.points.push_back({static_cast<double>(level.level), level.*value});
    return curve;
}

/// How closely each level follows the shape.
void give_plot(Lesson& lesson, const Facts& facts) {
    viz::Panel panel;
    panel.view = box(0, 0.5 * facts.back().mean_protrusion, static_cast<double>(facts.size() - 1),
                     2 * facts.front().worst_protrusion);
    panel.axes = viz::Axes{{"level", viz::Scale::linear, {}, true},
                           {"protrusion [m]", viz::Scale::logarithmic, {}, false}};
    panel.marks.push_back(curve_of(facts, &lod2d::LevelReport::worst_protrusion, 1, "worst"));
    panel.marks.push_back(curve_of(facts, &lod2d::LevelReport::mean_protrusion, 0, "mean"));
    give(lesson, "levels", std::move(panel));
}

/// Each level fades into the next.
void animate(Lesson& lesson, const Crescent& crescent) {
    constexpr int fade = 8;    // pictures
    constexpr int pause = 30;  // frames
    const std::string title = video_words(lesson, "title");
    for (int level = 0; level < crescent.tree->levels(); ++level)
        for (int i = 1; i <= fade; ++i) {
            const auto draw = [crescent, level, i, title] {
                const double share = static_cast<double>(i) / fade;
                viz::Figure figure = draw_level(crescent, level);
                figure.title = title;
                auto& marks = figure.panels[0].marks;
                for (viz::Mark& mark : marks)
                    if (auto* disc = std::get_if<viz::Disc>(&mark)) disc->style.opacity = share;
                if (level == 0) return figure;
                for (int node : crescent.tree->level_nodes(level - 1)) {
                    viz::Style faded = style(viz::Role::level_node, 1, level - 1);
                    faded.opacity = 1 - share;
                    add_ball(figure.panels[0], crescent.tree->sphere(node), faded);
                }
                return figure;
            };
            lesson.animation.shots.push_back({draw, i == fade ? pause : 2});
        }
}

}  // namespace
}  // namespace tree

void make_circle_tree(Lesson& lesson) {
    const tree::Crescent crescent = tree::make_crescent();
    tree::give_levels(lesson, crescent);
    tree::give_pieces(lesson, crescent);
    tree::give_outside(lesson, crescent);
    tree::give_builders(lesson, crescent);
    tree::give_plot(lesson, crescent.facts);
    tree::give_star(lesson);
    give(lesson, to_play_with({crescent.body}, crescent.view, live::Told::verdicts));
    tree::animate(lesson, crescent);
}

}  // namespace lessons
