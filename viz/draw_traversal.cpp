#include "viz/draw_traversal.hpp"

#include <algorithm>
#include <set>

#include "viz/draw_tree.hpp"
#include "viz/number_text.hpp"

namespace viz {
namespace {

const lod::Front& front_at(const std::vector<lod::Front>& fronts, int level) {
    return fronts[static_cast<std::size_t>(level)];
}

std::uint64_t tests_of(const std::vector<lod::Front>& fronts, int level) {
    const std::uint64_t before = level > 0 ? front_at(fronts, level - 1).tests : 0;
    return front_at(fronts, level).tests - before;
}

void insert_next(const lod::SphereTree<2>& tree, int node, std::set<int>& nodes) {
    if (tree.is_leaf(node)) {
        nodes.insert(node);
        return;
    }
    const auto i = lod::SphereTree<2>::index(node);
    for (int child = 0; child < tree.child_count[i]; ++child)
        nodes.insert(tree.first_child[i] + child);
}

Panel level_panel(const Actor& a, const Actor& b, const std::vector<lod::Front>& fronts, int level,
                  const Box& view) {
    const lod::Front& front = front_at(fronts, level);
    Panel panel;
    panel.title = "Level " + std::to_string(level) + ": " + verdict_words(front.verdict);
    panel.view = view;
    add_body(panel.marks, a, 0);
    add_body(panel.marks, b, 1);
    const TestedNodes tested = tested_nodes(a.body, b.body, fronts, level);
    add_nodes(panel.marks, a.body, tested.a, Role::node, 0);
    add_nodes(panel.marks, b.body, tested.b, Role::node, 1);
    add_meeting_nodes(panel.marks, a.body, b.body, 0, 1, front.pairs);
    return panel;
}

/// A box that holds both outlines and every node that the levels show.
Box view_of(const Actor& a, const Actor& b, const std::vector<lod::Front>& fronts,
            const std::vector<int>& levels) {
    Box view = bounds({a.look, b.look}, {a.body, b.body});
    const auto take_in = [&](const lod::Body<2>& body, const std::vector<int>& nodes) {
        for (const int node : nodes) {
            view = united(view, box_of(carried_node(body, node)));
        }
    };
    for (const int level : levels) {
        const TestedNodes tested = tested_nodes(a.body, b.body, fronts, level);
        take_in(a.body, tested.a);
        take_in(b.body, tested.b);
    }
    return view;
}

std::string names_of(const Actor& a, const Actor& b) {
    return literal_text(shown_name({a.look, b.look}, 0)) + " and " +
           literal_text(shown_name({a.look, b.look}, 1));
}

std::string level_words(const std::vector<lod::Front>& fronts, int level) {
    const lod::Front& front = front_at(fronts, level);
    return "level " + std::to_string(level) + ": " +
           count_text(static_cast<long long>(tests_of(fronts, level)), "node test") + ", " +
           count_text(static_cast<long long>(front.pairs.size()), "overlapping pair") + ", " +
           verdict_words(front.verdict);
}

std::string alt_text(const Actor& a, const Actor& b, const std::vector<lod::Front>& fronts,
                     const std::vector<int>& levels) {
    std::string alt = "The circle trees of " + plain_text(names_of(a, b)) +
                      " tested against each other, one panel a level.";
    for (const int level : levels) alt += " At " + level_words(fronts, level) + ".";
    return alt;
}

std::string title(const Actor& a, const Actor& b, const lod::Front& last) {
    switch (last.verdict) {
        case lod::Verdict::apart:
            return "At level " + std::to_string(last.level) +
                   ", no nodes intersect: " + names_of(a, b) + " do not collide";
        case lod::Verdict::true_collision:
            return "At level " + std::to_string(last.level) +
                   ", leaf meets leaf: " + names_of(a, b) + " collide";
        case lod::Verdict::possible:
            break;
    }
    return "Down to level " + std::to_string(last.level) + ", " + names_of(a, b) +
           " may still collide";
}

}  // namespace

TestedNodes tested_nodes(const lod::Body<2>& a, const lod::Body<2>& b,
                         const std::vector<lod::Front>& fronts, int level) {
    if (level == 0) return {{0}, {0}};
    std::set<int> of_a;
    std::set<int> of_b;
    for (const lod::NodePair& pair : front_at(fronts, level - 1).pairs) {
        insert_next(*a.tree, pair.a, of_a);
        insert_next(*b.tree, pair.b, of_b);
    }
    return {{of_a.begin(), of_a.end()}, {of_b.begin(), of_b.end()}};
}

Figure traversal(const Actor& a, const Actor& b, const std::vector<lod::Front>& fronts,
                 std::vector<int> levels) {
    if (levels.empty()) levels = montage_levels(static_cast<int>(fronts.size()));
    Figure figure;
    figure.title = title(a, b, front_at(fronts, levels.back()));
    figure.numbers = {{"node tests", number_text(static_cast<double>(fronts.back().tests), 9)}};
    figure.caption =
        "Bold: nodes that intersect, whose children are tested next. Thin grey: "
        "nodes tested that meet nothing.";
    figure.alt = alt_text(a, b, fronts, levels);
    const Box view = view_of(a, b, fronts, levels);
    for (const int level : levels) figure.panels.push_back(level_panel(a, b, fronts, level, view));
    add_names(figure.panels[0].marks, a, b, levels[0] == 0 ? Beside::roots : Beside::outlines);
    return figure;
}

Figure traversal_level(const Actor& a, const Actor& b, const std::vector<lod::Front>& fronts,
                       int level) {
    const lod::Front& front = front_at(fronts, level);
    Figure figure;
    figure.title = "Level " + std::to_string(level) + ": " + verdict_words(front.verdict);
    figure.numbers = {
        {"level", std::to_string(level)},
        {"tests here", number_text(static_cast<double>(tests_of(fronts, level)), 9)},
        {"tests so far", number_text(static_cast<double>(front.tests), 9)},
        {"overlapping pairs", number_text(static_cast<double>(front.pairs.size()), 9)}};
    figure.caption =
        "Bold: nodes that intersect, whose children are tested next. Thin grey: "
        "nodes tested that meet nothing.";
    figure.alt = "The circle trees of " + plain_text(names_of(a, b)) + " at " +
                 level_words(fronts, level) + ".";
    std::vector<int> every;  // so that the steps of one traversal share a view
    for (std::size_t i = 0; i < fronts.size(); ++i) every.push_back(static_cast<int>(i));
    figure.panels.push_back(level_panel(a, b, fronts, level, view_of(a, b, fronts, every)));
    figure.panels.back().title.clear();
    add_names(figure.panels.back().marks, a, b, level == 0 ? Beside::roots : Beside::outlines);
    return figure;
}

}  // namespace viz
