// A figure is data: a star under the circles of one level of its tree, as PNG and as SVG.
#include <string>

#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/shape/generators.hpp>
#include <lodlab/viz/paint/write.hpp>

int main() {
    const lod2d::Shape star = lod2d::generate("star:5");
    const lod::SphereTree<2> tree = lod2d::build_tree(star);
    constexpr int level = 2;

    viz::Panel panel;
    panel.view = {{-0.6, -0.6}, {0.6, 0.6}};
    viz::Path outline{{viz::Role::body}, {}};
    for (const lod2d::Ring& ring : star.polygon.rings) {
        outline.rings.emplace_back();
        for (const lod2d::Point& point : ring)
            outline.rings.back().push_back({point.x(), point.y()});
    }
    panel.marks.push_back(outline);
    for (const int node : tree.level_nodes(level)) {
        const lod::Sphere<2> circle = tree.sphere(node);
        panel.marks.push_back(viz::Disc{
            {viz::Role::node, 0, level}, {circle.centre.x(), circle.centre.y()}, circle.radius});
    }

    viz::Figure figure;
    figure.title = "How well do the circles of level 2 fit a star?";
    figure.numbers = {{"circles", std::to_string(tree.level_nodes(level).size())}};
    figure.caption = "Every point of the star lies in a circle of this level.";
    figure.alt = "A five-pointed star covered by the circles of level 2 of its tree.";
    figure.panels = {panel};
    viz::write_figure("star.png", figure);
    viz::write_figure("star.svg", figure);
}
