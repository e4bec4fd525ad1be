// The trees of the plane's builders, over shapes with straight and curved edges and holes.

#include "lodlab/io/tree_json.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "tests/determinism/report.hpp"

void add_plane_trees(Report& report) {
    for (const char* name : {"star:5", "gear:5", "blob:7"})
        for (const lod2d::Builder builder : lod::choices<lod2d::Builder>()) {
            const lod2d::TreeSettings settings{.builder = builder, .depth = 2};
            const auto tree = lod2d::build_tree(lod2d::generate(name), settings);
            const std::string what = std::string(lod::name_of(builder)) + " tree of " + name;
            report.add(what, lod::tree_hash(tree));
            report.add_text(what + ", its file", io::tree_to_json<2>(tree));
        }
}
