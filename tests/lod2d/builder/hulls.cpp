// The hulls of circle trees: each holds its piece, and hollows stay free from the entry level on.

#include "lodlab/core/builder/node_hulls.hpp"
#include "lodlab/io/tree_json.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/builder/piece.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "tests/catch.hpp"
#include "tests/lod2d/random_shape.hpp"
#include "tests/property.hpp"
#include "tests/sanitized.hpp"

using namespace lod2d;

namespace {

lod::SphereTree<2> tree_of(const char* spec, int depth = 3) {
    TreeSettings settings;
    settings.depth = depth;
    return build_tree(generate(spec), settings);
}

}  // namespace

TEST_CASE("every builder's hulls hold the pieces of their nodes", "[hulls]") {
    check_property(22, lodtest::sanitized ? 3 : 25, [] {
        const Shape shape = random_shape();
        const PolygonPiece whole(shape.polygon);
        for (const Builder builder : lod::choices<Builder>()) {
            TreeSettings settings;
            settings.builder = builder;
            settings.depth = 3;
            const lod::SphereTree<2> tree = build_tree(shape, settings);
            const auto certified = lod::certify_hulls<2>(tree, whole);
            RC_ASSERT(certified == std::vector<char>(certified.size(), 1));
        }
    });
}

TEST_CASE("a hull that is cut by a hair is not certified", "[hulls]") {
    const Shape shape = generate("star:5");
    const PolygonPiece whole(shape.polygon);
    lod::SphereTree<2> tree = tree_of("star:5");
    const lod::HullView<2> root = tree.hulls.of(0);
    lod::Hull<2> shrunk{{root.corners.begin(), root.corners.end()}, {}, {}, {}, false};
    for (std::size_t face = 0; face < root.normals.size(); ++face)
        shrunk.faces.push_back({root.loop(face).begin(), root.loop(face).end()});
    lod::NodeHulls<2> hulls;
    for (Point& corner : shrunk.corners) corner = corner * (1 - 1e-9);
    hulls.add(shrunk);
    for (int node = 1; node < tree.size(); ++node) hulls.add({});
    hulls.find_best(tree.parent);
    tree.hulls = hulls;
    CHECK(lod::certify_hulls<2>(tree, whole)[0] == 0);
}

TEST_CASE("a convex shape's hull is the shape, and no node below has one", "[hulls]") {
    for (const char* spec : {"box:2,1", "polygon:7"}) {
        const lod::SphereTree<2> tree = tree_of(spec);
        CHECK(tree.hulls.is_tight(0));
        for (int node = 1; node < tree.size(); ++node) {
            CHECK(tree.hulls.of(node).empty());
            CHECK(tree.hulls.best(node) == 0);
        }
    }
}

TEST_CASE("a body enters at the first level whose hulls leave its hollows free", "[hulls]") {
    CHECK(tree_of("box").hulls.entry_level == 0);
    CHECK(tree_of("gear:9").hulls.entry_level == 0);
    CHECK(tree_of("star:5").hulls.entry_level == 0);
    CHECK(tree_of("U").hulls.entry_level == 1);
    CHECK(tree_of("ring").hulls.entry_level == 1);
}
