#include "lessons/course/02_circle_tree/lesson.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/math/power_diagram.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/viz/draw/draw_tree.hpp"

namespace lessons {
namespace tree {

using lod::Sphere;

std::string circles_text(int nodes) {
    return shown_count(nodes) + (nodes == 1 ? " circle" : " circles");
}

viz::Panel panel_of(const Crescent& crescent) {
    viz::Panel panel;
    panel.view = crescent.view;
    add_body(panel, crescent.body, 0);
    return panel;
}

// listing: pieces
std::vector<lod2d::PolygonPiece> pieces_of_children(const lod2d::PolygonPiece& piece,
                                                    const Tree& tree, int node) {
    std::vector<Sphere<2>> children;
    for (int c = 0; c < tree.child_count[Tree::index(node)]; ++c)
        children.push_back(tree.sphere(tree.first_child[Tree::index(node)] + c));
    std::vector<lod2d::PolygonPiece> pieces;
    for (std::size_t c = 0; c < children.size(); ++c)
        pieces.push_back(piece.within(lod::power_cell<2>(children, c)));
    return pieces;
}
// end of listing

void add_piece(viz::Panel& panel, const lod2d::PolygonPiece& piece, int index) {
    const lod2d::ConvexParts& parts = piece.parts();
    for (std::size_t part = 0; part < parts.count(); ++part) {
        viz::Ring ring;
        for (std::int32_t i = parts.begin[part]; i < parts.begin[part + 1]; ++i)
            ring.push_back(at(parts.corners[static_cast<std::size_t>(i)]));
        panel.marks.push_back(viz::Path{style(viz::Role::band, index), {ring}});
    }
}

namespace {

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
viz::Figure draw_level(const Crescent& crescent, int level, const std::string& title) {
    const lod2d::LevelReport& facts = crescent.facts[static_cast<std::size_t>(level)];
    viz::Figure figure = viz::tree_level(crescent.body, level);
    figure.title = title;
    figure.caption.clear();
    figure.aspect = page_aspect;
    figure.panels[0].view = crescent.view;
    figure.alt += " They stand out by at most " + shown(facts.worst_protrusion, 3) + " m.";
    figure.numbers = {{"level", std::to_string(level)},
                      {"circles", shown_count(facts.nodes)},
                      {"stand out by", shown(facts.worst_protrusion, 3) + " m"}};
    return figure;
}

void name_numbers(Lesson& lesson, const Facts& facts) {
    for (const lod2d::LevelReport& level : facts) {
        const std::string name = std::to_string(level.level);
        lesson.numbers["circles " + name] = count(level.nodes);
        lesson.numbers["worst " + name] = number(level.worst_protrusion, 3, "m");
        lesson.numbers["mean " + name] = number(level.mean_protrusion, 4, "m");
        lesson.numbers["area " + name] = number(level.measure_ratio, 3);
    }
}

void step_root(Lesson& lesson, const Crescent& crescent) {
    lesson.numbers["filled share"] = number(100 / crescent.facts[0].measure_ratio, 0, "%");
    add_step(lesson, "Level 0: the root",
             "The root is the smallest circle that holds the whole crescent. Only {{number: filled "
             "share}} of it is filled: a body in the crescent's mouth meets the circle long before "
             "it meets the crescent. The farthest point of the circle is {{number: worst 0}} away "
             "from the shape. We call this the *protrusion*; it bounds the gap at which bodies may "
             "seem to collide.\n\n"
             "**Predict:** you may use four circles instead of one. Where do you put them?",
             draw_level(crescent, 0, "Level 0: one circle holds it all"),
             {{"filled", "filled share"}, {"protrusion", "worst 0"}});
}

void step_pieces(Lesson& lesson, const Crescent& crescent) {
    const Tree& tree = *crescent.tree;
    viz::Panel panel;
    panel.view = crescent.view;
    const auto pieces = pieces_of_children(lod2d::PolygonPiece(crescent.shape.polygon), tree, 0);
    add_ball(panel, tree.sphere(0), style(viz::Role::node, 0, 0));
    for (std::size_t c = 0; c < pieces.size(); ++c)
        add_piece(panel, pieces[c], static_cast<int>(c));
    for (int c = 0; c < tree.child_count[0]; ++c)
        add_ball(panel, tree.sphere(tree.first_child[0] + c), style(viz::Role::level_node, c, 1));
    const std::string pieces_count = std::to_string(pieces.size());
    viz::Figure figure =
        figure_of(std::move(panel), "Each child owns a piece, and its circle holds that piece",
                  "The crescent cut into " + pieces_count +
                      " pieces by straight lines, each piece inside a circle of its own.");
    figure.numbers = {{"level", "1"},
                      {"circles", pieces_count},
                      {"stand out by", lesson.numbers["worst 1"].text}};
    double least = crescent.shape.area;
    double most = 0;
    for (const auto& piece : pieces) {
        least = std::min(least, piece.measure());
        most = std::max(most, piece.measure());
    }
    lesson.numbers["smallest piece"] = number(least, 3, "m²");
    lesson.numbers["largest piece"] = number(most, 3, "m²");
    add_step(lesson, "Level 1: cut the shape, then fit a circle to each piece",
             "Every node *owns a piece* of the shape. The pieces of the children together are "
             "exactly the piece of their parent: nothing is lost, nothing is owned twice. Each "
             "child gets a circle that holds its piece. The cuts are straight; where two circles "
             "cross, the cut runs through both crossing points.\n\n"
             "The builder starts from a guess, cuts, fits the circles, cuts again with the new "
             "circles, and repeats while the fit improves.",
             std::move(figure),
             {{"smallest piece", "smallest piece"}, {"largest piece", "largest piece"}}, "pieces");
}

/// How far a node reaches outside its parent [m]; 0 or less when it does not.
double beyond_parent(const Tree& tree, int node) {
    const Sphere<2> child = tree.sphere(node);
    const Sphere<2> parent = tree.sphere(tree.parent[Tree::index(node)]);
    return (child.centre - parent.centre).norm() + child.radius - parent.radius;
}

void step_outside(Lesson& lesson, const Crescent& crescent) {
    constexpr double rounding = 1e-9;  // [m]
    const Tree& tree = *crescent.tree;
    int outside = 0;
    int farthest = 1;
    for (int node = 1; node < tree.size(); ++node) {
        if (beyond_parent(tree, node) > rounding) ++outside;
        if (beyond_parent(tree, node) > beyond_parent(tree, farthest)) farthest = node;
    }
    const int parent = tree.parent[Tree::index(farthest)];
    viz::Panel panel = panel_of(crescent);
    add_ball(panel, tree.sphere(parent), style(viz::Role::node, 0));
    add_ball(panel, tree.sphere(farthest), style(viz::Role::meeting_node, 0));
    add_label(panel, viz::Role::note, tree.sphere(parent).centre, "parent", 0,
              tree.radius[Tree::index(parent)]);
    add_label(panel, viz::Role::note, tree.sphere(farthest).centre, "child", 0,
              tree.radius[Tree::index(farthest)]);
    lesson.numbers["children outside"] = count(outside);
    lesson.numbers["nodes in all"] = count(tree.size());
    viz::Figure figure = figure_of(std::move(panel), "A child may reach outside its parent",
                                   "A node of the crescent's tree and one of its children. The "
                                   "child's circle reaches outside its parent's.");
    figure.numbers = {
        {"reach outside", shown_count(outside) + " of " + shown_count(tree.size() - 1)}};
    add_step(lesson, "What a parent promises, and what not",
             "**Predict:** must a child's circle lie inside its parent's?\n\n"
             "No. {{number: children outside}} circles of this tree reach outside their parent's, "
             "out of {{number: nodes in all}}. Nothing is wrong with that: a circle must hold its "
             "*piece*, and every circle holds some empty space besides. What counts is that the "
             "pieces of the children lie in the parent's circle, for then every point of the shape "
             "lies in a whole chain of circles, from the root down.",
             std::move(figure), {{"reach outside", "children outside"}});
}

/// How a level compares with the one above it, whichever way it went.
std::string compared(const lod2d::LevelReport& above, const lod2d::LevelReport& level) {
    const double gain = above.worst_protrusion / level.worst_protrusion;
    if (gain >= 1.05) return shown(gain, 1) + " times less than the level above";
    return gain > 0.95 ? "as far as the level above" : "more than the level above";
}

void steps_levels(Lesson& lesson, const Crescent& crescent) {
    for (std::size_t k = 2; k < crescent.facts.size(); ++k) {
        const lod2d::LevelReport& facts = crescent.facts[k];
        const std::string name = std::to_string(k);
        std::string text = "The same again, inside every piece: cut, fit, repeat. The " +
                           circles_text(facts.nodes) + " now stand out by at most " +
                           lesson.numbers["worst " + name].text + ", " +
                           compared(crescent.facts[k - 1], facts) + ", and by " +
                           lesson.numbers["mean " + name].text + " in the mean.";
        if (k == 2)
            text +=
                "\n\n**Predict:** the next level has up to four times as many circles. How far "
                "will it stand out?";
        if (k == 3)
            text +=
                " Along a smooth stretch of outline, four circles side by side follow it far more "
                "closely than one.";
        if (k + 1 == crescent.facts.size())
            text +=
                "\n\nThe circles without children are the *leaves*. A traversal that gets this far "
                "sees the crescent to within that distance, and no better.";
        add_step(lesson, "Level " + name, text,
                 draw_level(crescent, static_cast<int>(k),
                            "Level " + name + ": " + circles_text(facts.nodes)),
                 {{"circles", "circles " + name},
                  {"worst protrusion", "worst " + name},
                  {"mean protrusion", "mean " + name}});
    }
}

void step_builders(Lesson& lesson, const Crescent& crescent) {
    constexpr int level = 3;
    viz::Figure figure;
    figure.title = "Three builders, the same level";
    figure.columns = static_cast<int>(lod::choices<lod2d::Builder>().size());
    std::string text =
        "Every one of these trees is certified; they differ in how closely they follow the shape "
        "at the same level. At level 3:\n\n";
    for (const lod2d::Builder builder : lod::choices<lod2d::Builder>()) {
        const std::string name(lod::name_of(builder));
        const auto tree = tree_of(crescent.shape, level, builder);
        const lod2d::LevelReport facts = lod2d::report_tree(crescent.shape, *tree).levels.back();
        viz::Figure one = viz::tree_level(actor("crescent", crescent.shape, tree), level);
        one.panels[0].view = crescent.view;
        one.panels[0].title = name + ": " + circles_text(facts.nodes);
        figure.panels.push_back(std::move(one.panels[0]));
        lesson.numbers[name + " circles"] = count(facts.nodes);
        lesson.numbers[name + " worst"] = number(facts.worst_protrusion, 3, "m");
        text += "- " + name + ": " + circles_text(facts.nodes) + ", standing out by at most " +
                lesson.numbers[name + " worst"].text + ", area × " + shown(facts.measure_ratio, 2) +
                "\n";
    }
    text +=
        "\nThe quadtree halves squares and never looks at the shape. The others fit their circles "
        "to the pieces. Tighter circles overlap less often, so the same proof needs fewer tests.";
    figure.alt =
        "The crescent covered by the circles of level 3 of three trees: quadtree, pieces and "
        "medial. The quadtree's circles stand out most.";
    add_step(lesson, "Good trees and better ones", text, std::move(figure), {}, "builders");
}

viz::Polyline curve_of(const Facts& facts, double lod2d::LevelReport::*value, int series,
                       const std::string& name) {
    viz::Polyline curve{style(viz::Role::curve, series), {}, 1, name};
    for (const lod2d::LevelReport& level : facts)
        curve.points.push_back({static_cast<double>(level.level), level.*value});
    return curve;
}

/// How closely each level follows the shape.
void plot_levels(Lesson& lesson, const Facts& facts) {
    viz::Panel panel;
    panel.view = box(0, 0.5 * facts.back().mean_protrusion, static_cast<double>(facts.size() - 1),
                     2 * facts.front().worst_protrusion);
    panel.axes = viz::Axes{{"level", viz::Scale::linear, {}, true},
                           {"protrusion [m]", viz::Scale::logarithmic, {}, false}};
    panel.marks.push_back(curve_of(facts, &lod2d::LevelReport::worst_protrusion, 1, "worst"));
    panel.marks.push_back(curve_of(facts, &lod2d::LevelReport::mean_protrusion, 0, "mean"));
    lesson.figures["levels"] = figure_of(
        std::move(panel), "Each level follows the crescent more closely",
        "Two falling curves over the levels 0 to " + std::to_string(facts.size() - 1) +
            ": the mean protrusion falls from " + shown(facts.front().mean_protrusion, 3) +
            " m to " + shown(facts.back().mean_protrusion, 4) + " m, the worst from " +
            shown(facts.front().worst_protrusion, 3) + " m to " +
            shown(facts.back().worst_protrusion, 3) + " m.");
}

/// Each level fades into the next.
void animate(Lesson& lesson, const Crescent& crescent) {
    constexpr int fade = 8;    // pictures
    constexpr int pause = 30;  // frames
    lesson.animation.title = "The crescent's tree, level by level";
    for (int level = 0; level < crescent.tree->levels(); ++level)
        for (int i = 1; i <= fade; ++i) {
            const auto draw = [crescent, level, i] {
                const double share = static_cast<double>(i) / fade;
                viz::Figure figure =
                    draw_level(crescent, level, "The crescent's tree, level by level");
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
    tree::name_numbers(lesson, crescent.facts);
    tree::step_root(lesson, crescent);
    tree::step_pieces(lesson, crescent);
    tree::step_outside(lesson, crescent);
    tree::steps_levels(lesson, crescent);
    tree::step_hole(lesson, crescent);
    tree::step_certificate(lesson, crescent);
    tree::step_builders(lesson, crescent);
    tree::plot_levels(lesson, crescent.facts);
    tree::animate(lesson, crescent);
}

}  // namespace lessons
