#include <algorithm>

#include "lessons/course/05_circles_to_spheres/lesson.hpp"
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

std::string spheres_text(int nodes) {
    return shown_count(nodes) + (nodes == 1 ? " sphere" : " spheres");
}

viz::Figure draw_level(const Ring& ring, std::size_t level) {
    const lod::LevelReport& facts = ring.report.levels[level];
    viz::Panel panel = viz::tree_levels<3>(ring.body, {}, from_the_front).panels[level];
    panel.title.clear();
    viz::Figure figure = figure_of(
        std::move(panel), "Level " + std::to_string(level) + ": " + spheres_text(facts.nodes),
        "A ring in space inside the " + spheres_text(facts.nodes) + " of level " +
            std::to_string(level) + " of its tree.");
    figure.numbers = {{"spheres", shown_count(facts.nodes)},
                      {"stand out by", share_of_diameter(facts.worst_protrusion_fraction).text}};
    return figure;
}

Named numbers_of_level(std::size_t level) {
    const std::string name = std::to_string(level);
    return {{"spheres", "spheres " + name},
            {"stand out by", "worst " + name},
            {"volume of the spheres / of the ring", "volume " + name}};
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
    return figure_of(std::move(panel), "What a good fit costs in the plane and in space",
                     "Four falling curves of the worst protrusion over the number of nodes: the "
                     "ring's are alike in the plane and in space, the L's is far higher in space.");
}

void name_numbers(Lesson& lesson, const Ring& ring, const std::vector<Fit>& all) {
    const std::vector<lod::LevelReport>& levels = ring.report.levels;
    for (const lod::LevelReport& level : levels) {
        const std::string name = std::to_string(level.level);
        lesson.numbers["spheres " + name] = count(level.nodes);
        lesson.numbers["worst " + name] = share_of_diameter(level.worst_protrusion_fraction);
        lesson.numbers["volume " + name] = number(level.measure_ratio, 2);
    }
    lesson.numbers["triangles"] = count(ring.solid.mesh.triangles.size());
    lesson.numbers["certified levels"] =
        count(std::count_if(levels.begin(), levels.end(),
                            [](const lod::LevelReport& level) { return level.certified; }));
    lesson.numbers["wanted"] = number(100 * wanted_fit, 0, "%");
    for (const Fit& fit : all) {
        const lod::LevelReport& level = good_enough(fit);
        lesson.numbers[fit.name] = count(level.nodes);
        lesson.numbers[fit.name + " worst"] = share_of_diameter(level.worst_protrusion_fraction);
    }
}

void steps_levels(Lesson& lesson, const Ring& ring) {
    add_step(lesson, "Level 0: one sphere round a ring",
             "Now a solid, a ring of {{number: triangles}} triangles, as it might come from a "
             "modelling program. Its root sphere stands out by {{number: worst 0}} of its own "
             "diameter, just where the ring is not: in the hole and above and below. The volume of "
             "the sphere is {{number: volume 0}} times that of the ring.\n\n"
             "**Predict:** you have eight spheres. Where do you put them?",
             draw_level(ring, 0), numbers_of_level(0));
    add_step(lesson, "Level 1: a string of beads",
             "Side by side along the ring. The builder finds them as it finds circles: cut the "
             "solid into pieces, fit a sphere to each, cut again. The cuts are *planes* now, and "
             "where two spheres cross, the plane runs through the circle in which they meet. They "
             "stand out by {{number: worst 1}}, and you can see through the hole.",
             draw_level(ring, 1), numbers_of_level(1));
    add_step(
        lesson, "Level 2: the leaves, with a certificate",
        "{{number: spheres 2}} spheres, which stand out by {{number: worst 2}}.\n\n"
        "Coverage is proved as in lesson 2, by the corners of the pieces: a ball holds a "
        "piece with flat sides exactly when it holds the corners. In space the pieces are "
        "triangles cut by planes, and the *inside* counts as well as the surface. All "
        "{{number: certified levels}} levels are certified.\n\n"
        "**Predict:** a ring of the same width in the plane needs {{number: ring, plane}} circles "
        "for a fit like this. Does space always cost so little more? Think of an L, or of a "
        "plate.",
        draw_level(ring, 2), numbers_of_level(2));
}

void step_cost(Lesson& lesson, const std::vector<Fit>& all) {
    add_step(lesson, "What the third dimension costs",
             "How many nodes until a level stands out by no more than {{number: wanted}}? The ring "
             "takes {{number: ring, plane}} circles in the plane and {{number: ring, space}} "
             "spheres in space: about as many. The L takes {{number: L, plane}} circles and "
             "{{number: L, "
             "space}} spheres.\n\n"
             "A ring is thin in both: the middle of it is a *line*, and beads on a string follow a "
             "line. The L in space is as wide as it is thick. Its surface is made of *faces*, and "
             "to halve the size of the bumps on a face takes four times as many spheres, where an "
             "outline takes twice as many circles. That is why a node may have eight children in "
             "space and four in the plane, and why most of a modern sphere tree's builder is "
             "search: every sphere that fits better saves tests in every frame.",
             plot_cost(all),
             {{"ring, plane", "ring, plane"},
              {"ring, space", "ring, space"},
              {"L, plane", "L, plane"},
              {"L, space", "L, space"}},
             "cost");
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

void steps_fit(Lesson& lesson, const Ring& ring) {
    const std::vector<Fit> all = fits(ring);
    name_numbers(lesson, ring, all);
    steps_levels(lesson, ring);
    step_cost(lesson, all);
}

}  // namespace lessons::spheres
