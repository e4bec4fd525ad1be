#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/builder/tree_report.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/builder/piece.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/random_pose.hpp"

using namespace lod3d;

namespace {

/// Whether a chain of spheres that all hold p leads from the node to a node of the level or to a
/// leaf: what a traversal sees. Walks the tree; knows nothing of pieces.
bool has_chain(const lod::SphereTree<3>& tree, const Point& p, int node, int levels_left) {
    const lod::Sphere<3> ball = tree.sphere(node);
    if ((p - ball.centre).norm() > ball.radius) return false;
    if (levels_left == 0 || tree.is_leaf(node)) return true;
    const auto at = tree.index(node);
    for (int c = 0; c < tree.child_count[at]; ++c)
        if (has_chain(tree, p, tree.first_child[at] + c, levels_left - 1)) return true;
    return false;
}

/// Points on the triangles and inside the solid.
std::vector<Point> points_of(const Solid& solid, int inside_count) {
    std::vector<Point> points = solid.mesh.vertices;
    lod::Random random(5);
    for (std::size_t t = 0; t < solid.mesh.triangles.size(); ++t) {
        const double u = random.next();
        const double v = random.next(0, 1 - u);
        points.push_back(solid.mesh.corner(t, 0) * (1 - u - v) + solid.mesh.corner(t, 1) * u +
                         solid.mesh.corner(t, 2) * v);
    }
    const MeshDistance distance(solid.mesh, solid.inside_rule);
    const Box box = bounding_box(solid.mesh);
    while (inside_count > 0) {
        const Point p(random.next(box.low.x(), box.high.x()),
                      random.next(box.low.y(), box.high.y()),
                      random.next(box.low.z(), box.high.z()));
        if (!distance.inside(p)) continue;
        points.push_back(p);
        --inside_count;
    }
    return points;
}

int without_chain(const lod::SphereTree<3>& tree, const std::vector<Point>& points, int level) {
    int count = 0;
    for (const Point& p : points) count += !has_chain(tree, p, 0, level);
    return count;
}

}  // namespace

TEST_CASE("both builders' trees are certified, and samples agree, level by level", "[tree]") {
    for (const char* spec : {"L", "ring:0.12,40", "gear:7,0.25,0.4"}) {
        const Solid solid = generate(spec);
        const auto points = points_of(solid, 500);
        for (const Builder builder : lod::choices<Builder>()) {
            INFO(spec << " by " << lod::name_of(builder));
            TreeSettings settings;
            settings.builder = builder;
            settings.depth = 2;
            settings.effort = 0.05;
            const auto tree = build_tree(solid, settings);
            const lod::TreeReport report = report_tree(solid, tree);
            REQUIRE(report.levels.size() == 3);
            double last = 1e9;
            int most_nodes = 1;
            for (const lod::LevelReport& level : report.levels) {
                CHECK(level.certified);
                CHECK(level.uncovered == 0);
                CHECK(without_chain(tree, points, level.level) == 0);
                CHECK(level.nodes <= most_nodes);
                CHECK(level.worst_protrusion <= last);
                CHECK(level.mean_protrusion <= level.worst_protrusion);
                CHECK(level.measure_ratio > 1);
                last = level.worst_protrusion;
                most_nodes *= 8;
            }
        }
    }
}

TEST_CASE("a tree with a sphere made smaller loses its certificate", "[tree]") {
    const Solid solid = generate("ring:0.12,40");
    TreeSettings settings;
    settings.depth = 1;
    settings.effort = 0.05;
    auto tree = build_tree(solid, settings);
    tree.radius[3] *= 0.9;
    const lod::TreeReport report = report_tree(solid, tree);
    CHECK(report.levels[0].certified);
    CHECK_FALSE(report.levels[1].certified);
    CHECK(report.levels[1].uncovered > 0);
}

TEST_CASE("one sphere about a cube is reported as worked by hand", "[tree]") {
    const Solid cube = generate("box:1,1,1");
    const double radius = std::sqrt(0.75);
    const auto tree = lod::single_sphere<3>({Point::Zero(), radius * (1 + 1e-9)});
    const lod::TreeReport report = report_tree(cube, tree);
    CHECK(report.bounding_diameter == Approx(2 * radius));
    const lod::LevelReport& level = report.levels[0];
    CHECK(level.certified);
    CHECK(level.worst_protrusion >= radius - 0.5);
    CHECK(level.worst_protrusion <= radius - 0.5 + report.tolerance + 1e-8);
    CHECK(level.measure_ratio == Approx(4.0 / 3 * 3.14159265 * radius * radius * radius));
}

TEST_CASE("the same solid and settings give the same tree", "[tree]") {
    const Solid solid = generate("gear:5,0.25,0.4");
    TreeSettings settings;
    settings.depth = 1;
    settings.effort = 0.05;
    const auto first = build_tree(solid, settings);
    const auto second = build_tree(solid, settings);
    CHECK(first.radius == second.radius);
    CHECK(first.centre == second.centre);
}

TEST_CASE("depth, nodes and an error target each end the growing", "[tree]") {
    const Solid solid = generate("ring:0.12,40");
    TreeSettings settings;
    settings.depth = 3;
    settings.effort = 0.05;
    settings.most_nodes = 100;
    CHECK(build_tree(solid, settings).levels() == 3);  // 1 + 8 + 64 nodes at most
    settings.most_nodes = 0;
    settings.least_protrusion = 0.15;
    const auto coarse = build_tree(solid, settings);
    CHECK(coarse.levels() == 2);
    CHECK(report_tree(solid, coarse).levels.back().worst_protrusion_fraction <= 0.15);
}

TEST_CASE("settings out of range are refused, and progress never falls", "[tree]") {
    const Solid solid = generate("tetrahedron");
    TreeSettings settings;
    settings.branching = 1;
    CHECK_THROWS_AS(build_tree(solid, settings), lod::Error);
    settings.branching = 4;
    settings.builder = Builder::octree;
    CHECK_THROWS_WITH(build_tree(solid, settings), lodtest::contains("branching 8"));
    CHECK_THROWS_WITH(lod::chosen<Builder>("dodo", "builder"),
                      lodtest::contains("octree or cover"));
    settings = {};
    settings.effort = -1;
    CHECK_THROWS_WITH(build_tree(solid, settings), lodtest::contains("effort"));
    settings.effort = 0.05;
    settings.depth = 2;
    double last = 0;
    settings.progress = [&](double share) {
        CHECK(share >= last);
        last = share;
    };
    static_cast<void>(build_tree(solid, settings));
    CHECK(last == 1);
}
