#include "lodlab/viz/draw/draw_tree.hpp"

#include <algorithm>

#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

constexpr int most_panels = 6;

/// Shows the outline and every node of the levels.
template <int Dim>
View<Dim> view_of(const Actor<Dim>& actor, const std::vector<int>& levels,
                  const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    View<Dim> view(viewpoint);
    take_in<Dim>(view, actor);
    for (const int level : levels)
        for (const int node : actor.body.tree->level_nodes(level))
            take_in<Dim>(view, carried_node(actor.body, node));
    return view;
}

template <int Dim>
Panel level_panel(const Actor<Dim>& actor, int level, const View<Dim>& view) {
    const std::vector<int> nodes = actor.body.tree->level_nodes(level);
    Panel panel = blank_panel<Dim>(view);
    panel.title = "Level " + std::to_string(level) + ": " +
                  count_text(static_cast<long long>(nodes.size()), DrawTraits<Dim>::ball_word);
    add_body(panel, actor, 0);
    add_nodes<Dim>(panel, actor.body, nodes, Role::level_node, 1);
    return panel;
}

template <int Dim>
std::string alt_text(const Actor<Dim>& actor, const std::vector<int>& levels) {
    const std::string ball = DrawTraits<Dim>::ball_word;
    std::string alt = "The " + ball + " tree of " + actor.visual.name + " drawn over its " +
                      DrawTraits<Dim>::outline_word + ".";
    for (const int level : levels) {
        const std::vector<int> nodes = actor.body.tree->level_nodes(level);
        double largest = 0;
        for (const int node : nodes)
            largest = std::max(largest, actor.body.tree->sphere(node).radius);
        alt += " Level " + std::to_string(level) + ": " +
               count_text(static_cast<long long>(nodes.size()), ball) +
               ", the largest with radius " + length_text(largest) + ".";
    }
    return alt;
}

}  // namespace

std::vector<int> montage_levels(int count) {
    std::vector<int> levels;
    for (int level = 0; level < std::min(count, most_panels); ++level) levels.push_back(level);
    if (count > most_panels) levels.back() = count - 1;
    return levels;
}

template <int Dim>
Figure tree_levels(const Actor<Dim>& actor, std::vector<int> levels,
                   const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    const std::string balls = std::string(DrawTraits<Dim>::ball_word) + "s";
    if (levels.empty()) levels = montage_levels(actor.body.tree->levels());
    Figure figure;
    figure.title = "How closely do the " + balls + " of each level fit " +
                   literal_text(actor.visual.name) + "?";
    figure.numbers = {{"levels", std::to_string(actor.body.tree->levels())},
                      {balls + " in all", number_text(actor.body.tree->size(), 9)}};
    figure.caption = "The " + balls + " of every level together cover the whole " +
                     DrawTraits<Dim>::solid_word + ".";
    figure.alt = alt_text(actor, levels);
    const View<Dim> view = view_of(actor, levels, viewpoint);
    for (const int level : levels) figure.panels.push_back(level_panel<Dim>(actor, level, view));
    return figure;
}

template <int Dim>
Figure tree_level(const Actor<Dim>& actor, int level,
                  const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    const std::string ball = DrawTraits<Dim>::ball_word;
    Figure figure;
    figure.title = "Level " + std::to_string(level) + " of the " + ball + " tree of " +
                   literal_text(actor.visual.name);
    const std::vector<int> nodes = actor.body.tree->level_nodes(level);
    figure.numbers = {{ball + "s", number_text(static_cast<double>(nodes.size()), 9)}};
    figure.caption =
        "The " + ball + "s together cover the whole " + DrawTraits<Dim>::solid_word + ".";
    figure.alt = alt_text(actor, {level});
    figure.panels.push_back(level_panel<Dim>(actor, level, view_of(actor, {level}, viewpoint)));
    figure.panels.back().title.clear();
    return figure;
}

template Figure tree_levels<2>(const Actor<2>&, std::vector<int>, const DrawTraits<2>::Viewpoint&);
template Figure tree_levels<3>(const Actor<3>&, std::vector<int>, const DrawTraits<3>::Viewpoint&);
template Figure tree_level<2>(const Actor<2>&, int, const DrawTraits<2>::Viewpoint&);
template Figure tree_level<3>(const Actor<3>&, int, const DrawTraits<3>::Viewpoint&);

}  // namespace viz
