#include "lodlab/viz/draw/draw_traversal.hpp"

#include <algorithm>
#include <set>

#include "lodlab/viz/draw/draw_tree.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

const lod::Front& front_at(const std::vector<lod::Front>& fronts, int level) {
    return fronts[static_cast<std::size_t>(level)];
}

std::uint64_t tests_of(const std::vector<lod::Front>& fronts, int level) {
    const std::uint64_t before = level > 0 ? front_at(fronts, level - 1).tests : 0;
    return front_at(fronts, level).tests - before;
}

template <int Dim>
void insert_next(const lod::SphereTree<Dim>& tree, int node, std::set<int>& nodes) {
    if (tree.is_leaf(node)) {
        nodes.insert(node);
        return;
    }
    const auto i = lod::SphereTree<Dim>::index(node);
    for (int child = 0; child < tree.child_count[i]; ++child)
        nodes.insert(tree.first_child[i] + child);
}

template <int Dim>
Panel level_panel(const Actor<Dim>& a, const Actor<Dim>& b, const std::vector<lod::Front>& fronts,
                  int level, const View<Dim>& view) {
    const lod::Front& front = front_at(fronts, level);
    Panel panel = blank_panel<Dim>(view);
    panel.title = "Level " + std::to_string(level) + ": " + verdict_words(front.verdict);
    add_body(panel, a, 0, DrawTraits<Dim>::see_through);
    add_body(panel, b, 1, DrawTraits<Dim>::see_through);
    const TestedNodes tested = tested_nodes(a.body, b.body, fronts, level);
    add_nodes<Dim>(panel, a.body, tested.a, Role::node, 0);
    add_nodes<Dim>(panel, b.body, tested.b, Role::node, 1);
    add_meeting_nodes<Dim>(panel, {a.body, 0}, {b.body, 1}, front.pairs);
    return panel;
}

/// Shows both outlines and every node that the levels show.
template <int Dim>
View<Dim> view_of_tested(const Actor<Dim>& a, const Actor<Dim>& b,
                         const std::vector<lod::Front>& fronts, const std::vector<int>& levels,
                         const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    View<Dim> view(viewpoint, way_between(a.body, b.body));
    take_in<Dim>(view, a);
    take_in<Dim>(view, b);
    for (const int level : levels) {
        const TestedNodes tested = tested_nodes(a.body, b.body, fronts, level);
        for (const int node : tested.a) take_in<Dim>(view, carried_node(a.body, node));
        for (const int node : tested.b) take_in<Dim>(view, carried_node(b.body, node));
    }
    return view;
}

template <int Dim>
std::string names_of(const Actor<Dim>& a, const Actor<Dim>& b) {
    return literal_text(shown_name<Dim>({a.visual, b.visual}, 0)) + " and " +
           literal_text(shown_name<Dim>({a.visual, b.visual}, 1));
}

std::string level_words(const std::vector<lod::Front>& fronts, int level) {
    const lod::Front& front = front_at(fronts, level);
    return "level " + std::to_string(level) + ": " +
           count_text(static_cast<long long>(tests_of(fronts, level)), "node test") + ", " +
           count_text(static_cast<long long>(front.pairs.size()), "overlapping pair") + ", " +
           verdict_words(front.verdict);
}

template <int Dim>
std::string alt_text(const Actor<Dim>& a, const Actor<Dim>& b,
                     const std::vector<lod::Front>& fronts, const std::vector<int>& levels) {
    std::string alt = std::string("The ") + DrawTraits<Dim>::ball_word + " trees of " +
                      plain_text(names_of(a, b)) + " tested against each other, one panel a level.";
    for (const int level : levels) alt += " At " + level_words(fronts, level) + ".";
    return alt;
}

template <int Dim>
std::string title(const Actor<Dim>& a, const Actor<Dim>& b, const lod::Front& last) {
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

template <int Dim>
TestedNodes tested_nodes(const lod::Body<Dim>& a, const lod::Body<Dim>& b,
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

template <int Dim>
TestedNodes tested_nodes(const lod::Body<Dim>& a, const lod::Body<Dim>& b, const lod::Front& front,
                         std::uint64_t tests) {
    std::set<int> of_a;
    std::set<int> of_b;
    for (const lod::NodePair& pair : front.pairs) {
        if (a.tree->is_leaf(pair.a) && b.tree->is_leaf(pair.b)) continue;
        std::set<int> next_a;
        std::set<int> next_b;
        insert_next(*a.tree, pair.a, next_a);
        insert_next(*b.tree, pair.b, next_b);
        for (const int node_a : next_a)
            for (const int node_b : next_b) {
                if (tests-- == 0) return {{of_a.begin(), of_a.end()}, {of_b.begin(), of_b.end()}};
                of_a.insert(node_a);
                of_b.insert(node_b);
            }
    }
    return {{of_a.begin(), of_a.end()}, {of_b.begin(), of_b.end()}};
}

template <int Dim>
Figure traversal(const Actor<Dim>& a, const Actor<Dim>& b, const std::vector<lod::Front>& fronts,
                 const TraversalChoice& choice,
                 const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    const bool proved_apart = choice.proved_apart;
    const std::vector<int> levels =
        choice.levels.empty() ? montage_levels(static_cast<int>(fronts.size())) : choice.levels;
    Figure figure;
    figure.title = proved_apart ? names_of(a, b) + " do not collide: their " +
                                      DrawTraits<Dim>::ball_word + "s meet, what they hold does not"
                                : title(a, b, front_at(fronts, levels.back()));
    figure.numbers = {{"node tests", number_text(static_cast<double>(fronts.back().tests), 9)}};
    figure.caption =
        "Bold: nodes that intersect, whose children are tested next. Thin grey: "
        "nodes tested that meet nothing.";
    figure.alt = alt_text(a, b, fronts, levels);
    const View<Dim> view = view_of_tested(a, b, fronts, levels, viewpoint);
    for (const int level : levels)
        figure.panels.push_back(level_panel<Dim>(a, b, fronts, level, view));
    if (proved_apart)
        figure.panels.back().title =
            "Level " + std::to_string(levels.back()) + ": " + verdict_words(lod::Verdict::apart);
    add_names(figure.panels[0], a, b, levels[0] == 0 ? Beside::roots : Beside::outlines);
    return figure;
}

template <int Dim>
Figure traversal_level(const Actor<Dim>& a, const Actor<Dim>& b,
                       const std::vector<lod::Front>& fronts, int level,
                       const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
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
    figure.alt = std::string("The ") + DrawTraits<Dim>::ball_word + " trees of " +
                 plain_text(names_of(a, b)) + " at " + level_words(fronts, level) + ".";
    std::vector<int> every;  // so that the steps of one traversal share a view
    for (std::size_t i = 0; i < fronts.size(); ++i) every.push_back(static_cast<int>(i));
    figure.panels.push_back(
        level_panel<Dim>(a, b, fronts, level, view_of_tested(a, b, fronts, every, viewpoint)));
    figure.panels.back().title.clear();
    add_names(figure.panels.back(), a, b, level == 0 ? Beside::roots : Beside::outlines);
    return figure;
}

template TestedNodes tested_nodes<2>(const lod::Body<2>&, const lod::Body<2>&,
                                     const std::vector<lod::Front>&, int);
template TestedNodes tested_nodes<3>(const lod::Body<3>&, const lod::Body<3>&,
                                     const std::vector<lod::Front>&, int);
template TestedNodes tested_nodes<2>(const lod::Body<2>&, const lod::Body<2>&, const lod::Front&,
                                     std::uint64_t);
template TestedNodes tested_nodes<3>(const lod::Body<3>&, const lod::Body<3>&, const lod::Front&,
                                     std::uint64_t);
template Figure traversal<2>(const Actor<2>&, const Actor<2>&, const std::vector<lod::Front>&,
                             const TraversalChoice&, const DrawTraits<2>::Viewpoint&);
template Figure traversal<3>(const Actor<3>&, const Actor<3>&, const std::vector<lod::Front>&,
                             const TraversalChoice&, const DrawTraits<3>::Viewpoint&);
template Figure traversal_level<2>(const Actor<2>&, const Actor<2>&, const std::vector<lod::Front>&,
                                   int, const DrawTraits<2>::Viewpoint&);
template Figure traversal_level<3>(const Actor<3>&, const Actor<3>&, const std::vector<lod::Front>&,
                                   int, const DrawTraits<3>::Viewpoint&);

}  // namespace viz
