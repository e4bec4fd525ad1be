// The trees of the builders of space, over generated solids and over meshes from files.

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/tree_json.hpp"
#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/scenes/shapes.hpp"
#include "tests/determinism/report.hpp"

namespace {

constexpr double little_effort = 0.02;

void add_tree(const std::string& name, const lod3d::Solid& solid, lod3d::Builder builder, int depth,
              Report& report) {
    const lod3d::TreeSettings settings{.builder = builder, .depth = depth, .effort = little_effort};
    const auto tree = lod3d::build_tree(solid, settings);
    const std::string what = std::string(lod::name_of(builder)) + " tree of " + name;
    report.add(what, lod::tree_hash(tree));
    report.add_text(what + ", its file", io::tree_to_json<3>(tree));
}

}  // namespace

void add_space_trees(Report& report) {
    for (const char* name : {"tetrahedron", "L", "ring"})
        for (const lod3d::Builder builder : lod::choices<lod3d::Builder>())
            add_tree(name, lod3d::generate(name), builder, 1, report);
    for (const char* file : {"asteroid-low.3ds", "bunny.obj"}) {
        try {
            const std::string name = "package:glmark2-data/" + std::string(file);
            add_tree(file, scenes::Shapes<3>::named(name, {{}, true, 1}), lod3d::Builder::cover, 1,
                     report);
        } catch (const lod::Error& error) {
            report.leave_out("cover tree of " + std::string(file), error.what());
        }
    }
}
