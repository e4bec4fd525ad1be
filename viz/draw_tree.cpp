#include "viz/draw_tree.hpp"

#include <algorithm>

#include "viz/number_text.hpp"

namespace viz {
namespace {

constexpr int most_panels = 6;

/// A box that holds the outline and every node shown.
Box view_of(const Actor& actor, const std::vector<int>& levels) {
    Box view = bounds({actor.look}, {actor.body});
    for (const int level : levels) {
        for (const int node : actor.body.tree->level_nodes(level)) {
            view = united(view, box_of(carried_node(actor.body, node)));
        }
    }
    return view;
}

Panel level_panel(const Actor& actor, int level, const Box& view) {
    const std::vector<int> nodes = actor.body.tree->level_nodes(level);
    Panel panel;
    panel.title = "Level " + std::to_string(level) + ": " +
                  count_text(static_cast<long long>(nodes.size()), "circle");
    panel.view = view;
    add_body(panel.marks, actor, 0);
    add_nodes(panel.marks, actor.body, nodes, Role::level_node, 1);
    return panel;
}

std::string alt_text(const Actor& actor, const std::vector<int>& levels) {
    std::string alt = "The circle tree of " + actor.look.name + " drawn over its outline.";
    for (const int level : levels) {
        const std::vector<int> nodes = actor.body.tree->level_nodes(level);
        double largest = 0;
        for (const int node : nodes)
            largest = std::max(largest, actor.body.tree->sphere(node).radius);
        alt += " Level " + std::to_string(level) + ": " +
               count_text(static_cast<long long>(nodes.size()), "circle") +
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

Figure tree_levels(const Actor& actor, std::vector<int> levels) {
    if (levels.empty()) levels = montage_levels(actor.body.tree->levels());
    Figure figure;
    figure.title =
        "How closely do the circles of each level fit " + literal_text(actor.look.name) + "?";
    figure.numbers = {{"levels", std::to_string(actor.body.tree->levels())},
                      {"circles in all", number_text(actor.body.tree->size(), 9)}};
    figure.caption =
        "The circles of every level together cover the whole shape.";
    figure.alt = alt_text(actor, levels);
    const Box view = view_of(actor, levels);
    for (const int level : levels) figure.panels.push_back(level_panel(actor, level, view));
    return figure;
}

Figure tree_level(const Actor& actor, int level) {
    Figure figure;
    figure.title = "Level " + std::to_string(level) + " of the circle tree of " +
                   literal_text(actor.look.name);
    const std::vector<int> nodes = actor.body.tree->level_nodes(level);
    figure.numbers = {{"circles", number_text(static_cast<double>(nodes.size()), 9)}};
    figure.caption = "The circles together cover the whole shape.";
    figure.alt = alt_text(actor, {level});
    figure.panels.push_back(level_panel(actor, level, view_of(actor, {level})));
    figure.panels.back().title.clear();
    return figure;
}

}  // namespace viz
