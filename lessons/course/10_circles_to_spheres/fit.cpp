#include <algorithm>

#include "lessons/course/10_circles_to_spheres/lesson.hpp"
#include "lodlab/lod2d/builder/tree_report.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/builder/tree_report.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/viz/draw/draw_tree.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"

namespace lessons::spheres {
namespace {

constexpr double effort = 0.05;  ///< of the search: a little worse than a patient one

viz::Figure draw_level(const Ring& ring, std::size_t level) {
    const lod::LevelReport& facts = ring.report.levels[level];
    viz::Panel panel = viz::tree_levels<3>(ring.body, {}, from_the_front).panels[level];
    panel.title.clear();
    viz::Figure figure = figure_of(std::move(panel));
    figure.numbers = {{"spheres", shown_count(facts.nodes)},
                      {"stand out by", share_of_diameter(facts.worst_protrusion_fraction).text}};
    return figure;
}

/// A tree's levels for the comparison.
struct Fit {
    std::string name;
    std::vector<lod::LevelReport> levels;
};

/// The same two bodies in the plane and in space.
std::vector<Fit> fits(const Ring& ring) {
    constexpr int depth = 3;
    std::vector<Fit> all;
    for (const std::string name : {"ring", "L"}) {
        const lod2d::Shape shape = lod2d::generate(name == "L" ? "L:0.3" : "ring:0.52");
        const auto tree = tree_of(shape, depth);
        all.push_back({name + ", plane", lod2d::report_tree(shape, *tree).levels});
    }
    all.push_back({"ring, space", ring.report.levels});
    const lod3d::Solid l = lod3d::generate("L:0.3");
    const auto tree = lod3d::build_tree(l, {.depth = depth, .effort = effort});
    all.push_back({"L, space", lod3d::report_tree(l, tree).levels});
    return all;
}

constexpr double wanted_fit = 0.03;  ///< of the diameter

/// The first level that stands out no more than wanted; the last where none does.
const lod::LevelReport& good_enough(const Fit& fit) {
    for (const lod::LevelReport& level : fit.levels)
        if (level.worst_protrusion_fraction <= wanted_fit) return level;
    return fit.levels.back();
}

viz::Figure plot_cost(const std::vector<Fit>& all) {
    std::vector<viz::Curve> curves;
    for (const Fit& fit : all) {
        viz::Curve curve;
        curve.name = fit.name;
        curve.series = fit.name.ends_with("plane") ? 0 : 1;
        curve.dots = true;
        for (const lod::LevelReport& level : fit.levels)
            curve.points.push_back(
                {static_cast<double>(level.nodes), 100 * level.worst_protrusion_fraction});
        curves.push_back(std::move(curve));
    }
    const viz::Axes axes{{"circles or spheres of the level", viz::Scale::logarithmic, {}, true},
                         {"standing out [% of the diameter]", viz::Scale::logarithmic, {}, false}};
    viz::Panel panel = viz::plot_panel("", axes, curves);
    return figure_of(std::move(panel));
}

void give_ring(Lesson& lesson, const Ring& ring) {
    const std::vector<lod::LevelReport>& levels = ring.report.levels;
    for (const lod::LevelReport& level : levels) {
        const std::string name = std::to_string(level.level);
        give(lesson, "spheres " + name, count(level.nodes));
        give(lesson, "worst " + name, share_of_diameter(level.worst_protrusion_fraction));
        give(lesson, "volume " + name, number(level.measure_ratio, 2));
        give(lesson, "level " + name, draw_level(ring, static_cast<std::size_t>(level.level)));
    }
    give(lesson, "triangles", count(ring.solid.mesh.triangles.size()));
    give(lesson, "certified levels",
         count(std::count_if(levels.begin(), levels.end(),
                             [](const lod::LevelReport& level) { return level.certified; })));
}

void give_cost(Lesson& lesson, const std::vector<Fit>& all) {
    give(lesson, "wanted", number(100 * wanted_fit, 0, "%"));
    for (const Fit& fit : all) {
        const lod::LevelReport& level = good_enough(fit);
        give(lesson, fit.name, count(level.nodes));
        give(lesson, fit.name + " worst", share_of_diameter(level.worst_protrusion_fraction));
    }
    give(lesson, "cost", plot_cost(all));
}

}  // namespace

Number share_of_diameter(double fraction) {
    return number(100 * fraction, 2, "%");
}

Ring make_ring() {
    Ring ring;
    // listing: ring
    ring.solid = lod3d::generate("ring:0.12,24");
    const lod3d::TreeSettings settings{.branching = 8, .depth = 2, .effort = effort};
    const lod::SphereTree<3> tree = lod3d::build_tree(ring.solid, settings);
    ring.report = lod3d::report_tree(ring.solid, tree);
    // end of listing
    ring.tree = std::make_shared<const lod::SphereTree<3>>(tree);
    ring.body = actor("ring", ring.solid, ring.tree);
    return ring;
}

void give_fit(Lesson& lesson, const Ring& ring) {
    give_ring(lesson, ring);
    give_cost(lesson, fits(ring));
}

}  // namespace lessons::spheres
