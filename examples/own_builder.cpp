// A builder of your own: a bar in circles side by side. Nodes in any order are laid out as a tree;
// the last step of every builder proves that it covers the shape, and gives the nodes their hulls.
#include <cmath>
#include <cstdio>
#include <vector>

#include <lodlab/core/base/error.hpp>
#include <lodlab/core/builder/complete_tree.hpp>
#include <lodlab/lod2d/builder/piece.hpp>
#include <lodlab/lod2d/shape/distance.hpp>
#include <lodlab/lod2d/shape/generators.hpp>

// `count` equal circles along the bar's longer side, below one that holds all.
lod::SphereTree<2> in_a_row(const lod2d::Shape& bar, int count, double radius) {
    const lod2d::Box box = lod2d::bounds(bar.polygon);
    std::vector<lod::TreeNode<2>> nodes(1);
    nodes[0].sphere = {box.centre(), (1 + 1e-9) * box.size().norm() / 2};
    for (int i = 0; i < count; ++i) {
        const double x = box.low.x() + (i + 0.5) / count * box.size().x();
        nodes[0].children.push_back(static_cast<int>(nodes.size()));
        nodes.push_back({.sphere = {{x, box.centre().y()}, radius}, .children = {}});
    }
    const lod2d::PolygonPiece whole(bar.polygon);
    return lod::complete_tree<2>(lod::lay_out<2>(nodes), "bar", whole,
                                 lod2d::BoundaryIndex(bar.polygon));
}

int main() {
    const lod2d::Shape bar = lod2d::generate("box:2,0.5");
    const double needed = std::hypot(0.125, 0.25);  // half the diagonal of an eighth of the bar
    const lod::SphereTree<2> tree = in_a_row(bar, 8, (1 + 1e-9) * needed);
    std::printf("%d nodes in %d levels, cover proved\n", tree.size(), tree.levels());

    try {
        in_a_row(bar, 8, 0.99 * needed);
        return 1;
    } catch (const lod::Error& error) {  // circles that are too small are refused
        std::printf("%s\n", error.what());
    }
}
