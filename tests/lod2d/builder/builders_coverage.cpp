#include "lodlab/core/builder/certify.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/builder/piece.hpp"
#include "lodlab/lod2d/builder/tree_report.hpp"
#include "tests/catch.hpp"
#include "tests/lod2d/random_shape.hpp"
#include "tests/property.hpp"
#include "tests/random.hpp"

using namespace lod2d;

namespace {

/// Whether a chain of circles that all hold p leads from the node to a node of the level or to a
/// leaf: what a traversal sees. Walks the tree; knows nothing of pieces.
bool has_chain(const lod::SphereTree<2>& tree, const Point& p, int node, int levels_left) {
    const lod::Sphere<2> disc = tree.sphere(node);
    if ((p - disc.centre).norm() > disc.radius) return false;
    if (levels_left == 0 || tree.is_leaf(node)) return true;
    const auto at = tree.index(node);
    for (int c = 0; c < tree.child_count[at]; ++c)
        if (has_chain(tree, p, tree.first_child[at] + c, levels_left - 1)) return true;
    return false;
}

/// Points of the shape: its corners, points along its edges, and points within.
std::vector<Point> points_of(const Shape& shape, int inside_count) {
    std::vector<Point> points;
    for (const Ring& ring : shape.polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            points.push_back(ring[i]);
            points.push_back(0.7 * ring[i] + 0.3 * ring[(i + 1) % ring.size()]);
        }
    const BoundaryIndex index(shape.polygon);
    const Box box = bounds(shape.polygon);
    lodtest::Random random(5);
    while (inside_count > 0) {
        const Point p(random.in(box.low.x(), box.high.x()), random.in(box.low.y(), box.high.y()));
        if (!index.inside(p)) continue;
        points.push_back(p);
        --inside_count;
    }
    return points;
}

double share_without_chain(const Shape& shape, const lod::SphereTree<2>& tree, int level) {
    const auto points = points_of(shape, 400);
    int without = 0;
    for (const Point& p : points) without += !has_chain(tree, p, 0, level);
    return without / double(points.size());
}

}  // namespace

TEST_CASE("every builder's tree is certified, and samples agree, level by level", "[coverage]") {
    check_property(21, 40, [] {
        const Shape shape = random_shape();
        const PolygonPiece whole(shape.polygon);
        for (const Builder builder : lod::choices<Builder>()) {
            TreeSettings settings;
            settings.builder = builder;
            settings.depth = *rc::gen::inRange(0, 5);
            const auto tree = build_tree(shape, settings);
            RC_ASSERT(tree.levels() <= settings.depth + 1);
            for (const auto& level : lod::certify<2>(tree, whole)) {
                RC_ASSERT(level.certified);
                RC_ASSERT(level.uncovered == 0);
            }
            for (int level = 0; level < tree.levels(); ++level)
                RC_ASSERT(share_without_chain(shape, tree, level) == 0);
        }
    });
}

TEST_CASE("slivers and thin rings are covered too", "[coverage]") {
    for (const char* spec : {"box:1,0.001", "ring:0.99", "star:40,0.05", "rod:1,0.001"}) {
        INFO(spec);
        const Shape shape = generate(spec);
        for (const Builder builder : lod::choices<Builder>()) {
            TreeSettings settings;
            settings.builder = builder;
            const auto tree = build_tree(shape, settings);
            CHECK(share_without_chain(shape, tree, tree.levels() - 1) == 0);
        }
    }
}

TEST_CASE("a tree with a shrunk or a moved circle loses its certificate from that level on",
          "[coverage]") {
    const Shape shape = generate("gear:7");
    const PolygonPiece whole(shape.polygon);
    for (const Builder builder : lod::choices<Builder>()) {
        TreeSettings settings;
        settings.builder = builder;
        settings.depth = 3;
        const auto tree = build_tree(shape, settings);
        const int node = tree.level_begin[2];  // it owns a piece, as every node built does
        const auto at = tree.index(node);
        auto shrunk = tree;
        shrunk.radius[at] *= 0.1;
        auto moved = tree;
        moved.centre[0][at] += 2 * tree.radius[0];
        for (const auto& broken : {shrunk, moved}) {
            const auto levels = lod::certify<2>(broken, whole);
            CHECK(levels[0].certified);
            CHECK(levels[1].certified);
            CHECK(levels[1].uncovered == 0);
            CHECK_FALSE(levels[2].certified);
            CHECK(levels[2].uncovered > 0);
            CHECK_FALSE(levels[3].certified);
            CHECK(levels[3].uncovered >= levels[2].uncovered);
        }
    }
}

TEST_CASE("the uncovered share is an upper bound of what samples find", "[coverage]") {
    const Shape shape = generate("star:5");
    const PolygonPiece whole(shape.polygon);
    TreeSettings settings;
    settings.depth = 2;
    auto tree = build_tree(shape, settings);
    for (int node = tree.level_begin[2]; node < tree.size(); ++node)
        tree.radius[tree.index(node)] *= 0.8;
    const auto levels = lod::certify<2>(tree, whole);
    const double sampled = share_without_chain(shape, tree, 2);
    CHECK(sampled > 0);
    CHECK(levels[2].uncovered >= sampled * 0.8);  // 400 samples: 0.05 of a share is noise
    CHECK(levels[2].uncovered < 0.5);
}

TEST_CASE("a level that is only just too small is uncovered by a little, not by a piece",
          "[coverage]") {
    // A circle through the corners of a square, less a thousandth: four tips stand out.
    const Shape shape = generate("box");
    const auto tree = lod::single_sphere<2>({{0, 0}, std::sqrt(0.5) * 0.999});
    const auto levels = lod::certify<2>(tree, PolygonPiece(shape.polygon));
    CHECK_FALSE(levels[0].certified);
    CHECK(levels[0].uncovered > 0);
    CHECK(levels[0].uncovered < 0.02);
}

TEST_CASE("the same shape and settings give the same tree to the last bit", "[builders]") {
    const Shape shape = generate("blob:3");
    for (const Builder builder : lod::choices<Builder>()) {
        TreeSettings settings;
        settings.builder = builder;
        const auto first = build_tree(shape, settings);
        const auto second = build_tree(shape, settings);
        CHECK(first.radius == second.radius);
        CHECK(first.centre == second.centre);
        CHECK(first.parent == second.parent);
        CHECK(first.normal == second.normal);
    }
}

TEST_CASE("settings out of range are refused by name, and progress runs from 0 to 1",
          "[builders]") {
    const Shape shape = generate("L");
    const auto refused = [&](int branching, int depth, Builder builder) {
        TreeSettings settings;
        settings.builder = builder;
        settings.branching = branching;
        settings.depth = depth;
        CHECK_THROWS_AS(build_tree(shape, settings), lod::Error);
    };
    refused(1, 4, Builder::pieces);
    refused(65, 1, Builder::pieces);
    refused(4, -1, Builder::pieces);
    refused(4, 13, Builder::quadtree);
    refused(4, 11, Builder::medial);
    refused(8, 3, Builder::quadtree);
    CHECK(lod::chosen<Builder>("pieces", "builder") == Builder::pieces);
    CHECK_THROWS_WITH(lod::chosen<Builder>("octree", "builder"),
                      lodtest::contains("quadtree, pieces or medial"));

    for (const Builder builder : lod::choices<Builder>()) {
        std::vector<double> shares;
        TreeSettings settings;
        settings.builder = builder;
        settings.depth = 3;
        settings.progress = [&](double share) { shares.push_back(share); };
        (void)build_tree(shape, settings);
        REQUIRE(!shares.empty());
        CHECK(std::is_sorted(shares.begin(), shares.end()));
        CHECK(shares.back() == Approx(1).margin(1e-12));
    }
}

TEST_CASE("a builder stops when it is asked to", "[builders]") {
    TreeSettings settings;
    settings.progress = [](double) { lod::stop_requested = true; };
    for (const Builder builder : lod::choices<Builder>()) {
        settings.builder = builder;
        CHECK_THROWS_AS(build_tree(generate("gear:9"), settings), lod::Interrupted);
        lod::stop_requested = false;
    }
}

TEST_CASE("node normals have length 1 on a flat side and none on the whole", "[builders]") {
    const Shape shape = generate("box");
    for (const Builder builder : lod::choices<Builder>()) {
        TreeSettings settings;
        settings.builder = builder;
        const auto tree = build_tree(shape, settings);
        CHECK(tree.mean_normal(0).norm() < 1e-12);
        int flat = 0;
        for (int node = 0; node < tree.size(); ++node) {
            const Point normal = tree.mean_normal(node);
            CHECK(normal.norm() <= 1 + 1e-12);
            if (normal.norm() < 1 - 1e-12) continue;
            ++flat;
            CHECK(std::max(std::abs(normal.x()), std::abs(normal.y())) == Approx(1));
            CHECK(normal.dot(tree.sphere(node).centre) > 0);  // outward
        }
        CHECK(flat > 4);
    }
}

TEST_CASE("without a weight on the normals the medial fit is closer, and circles touch two sides",
          "[builders]") {
    const Shape shape = generate("box");
    TreeSettings settings;
    const auto facing = build_tree(shape, settings);
    settings.normal_weight = 0;
    const auto close = build_tree(shape, settings);
    const auto flat_leaves = [](const lod::SphereTree<2>& tree) {
        int flat = 0;
        for (int node = 0; node < tree.size(); ++node)
            flat += tree.is_leaf(node) && tree.mean_normal(node).norm() > 0.99;
        return flat;
    };
    CHECK(flat_leaves(facing) > 50);
    CHECK(flat_leaves(close) < flat_leaves(facing) / 2);
    CHECK(report_tree(shape, close).levels.back().worst_protrusion <
          report_tree(shape, facing).levels.back().worst_protrusion);
    settings.normal_weight = -1;
    CHECK_THROWS_AS(build_tree(shape, settings), lod::Error);
}
