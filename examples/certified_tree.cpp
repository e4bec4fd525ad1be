// Builds the circle tree of a gear and proves that it covers the gear at every level.
#include <cstdio>

#include <lodlab/core/builder/certify.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/builder/piece.hpp>
#include <lodlab/lod2d/shape/generators.hpp>

int main() {
    const lod2d::Shape gear = lod2d::generate("gear:9");
    const lod::SphereTree<2> tree = lod2d::build_tree(gear, {.depth = 4});
    const auto certificates = lod::certify<2>(tree, lod2d::PolygonPiece(gear.polygon));

    std::printf("%s: %.4f m^2\n", gear.name.c_str(), gear.area);
    for (int level = 0; level < tree.levels(); ++level) {
        const auto nodes = tree.level_nodes(level);
        double widest = 0;
        for (const int node : nodes) widest = std::max(widest, tree.sphere(node).radius);
        const bool covered = certificates[static_cast<std::size_t>(level)].certified;
        std::printf("level %d: %4zu circles, the widest of radius %.4f m, %s\n", level,
                    nodes.size(), widest, covered ? "cover certified" : "NOT certified");
        if (!covered) return 1;
    }
}
