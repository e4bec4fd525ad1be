// Time of the tree builders, and what it buys: nodes and worst protrusion of the last level.
//
// bench_builders [DEPTH]

#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/timing.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/builder/tree_report.hpp"
#include "lodlab/lod2d/shape/generators.hpp"

int main(int argc, char** argv) {
    const int depth = argc > 1 ? std::atoi(argv[1]) : 4;
    std::printf(
        "depth %d; milliseconds of the processor (median of 3), nodes, worst protrusion in "
        "%% of the diameter\n%-10s %6s",
        depth, "shape", "edges");
    for (const lod2d::Builder builder : lod::choices<lod2d::Builder>())
        std::printf("  %27s", std::string(lod::name_of(builder)).c_str());
    std::puts("");
    for (const char* spec :
         {"box", "L", "star:5", "gear:9", "ring", "disc:200", "blob:1", "spiral"}) {
        const lod2d::Shape shape = lod2d::generate(spec);
        std::size_t edges = 0;
        for (const auto& ring : shape.polygon.rings) edges += ring.size();
        std::printf("%-10s %6zu", spec, edges);
        for (const lod2d::Builder builder : lod::choices<lod2d::Builder>()) {
            lod2d::TreeSettings settings;
            settings.builder = builder;
            settings.depth = depth;
            lod::SphereTree<2> tree;
            const double time =
                bench::medians(3, [&] { tree = lod2d::build_tree(shape, settings); })[0];
            const auto report = lod2d::report_tree(shape, tree);
            std::printf("  %8.1f ms %5d %7.3f %%", 1e3 * time, tree.size(),
                        100 * report.levels.back().worst_protrusion_fraction);
            std::fflush(stdout);
        }
        std::puts("");
    }
    std::puts(
        "Limits, by a profile: the quadtree, clipping squares; the other two, for about half of\n"
        "their time, the nearest point of the outline, asked for again and again by the fit of\n"
        "each circle; medial also the choice of circles that cover a piece.");
}
