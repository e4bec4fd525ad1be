#include "lodlab/core/tree/tree.hpp"

#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
TreeNode<Dim> node(double x, double radius, std::vector<int> children = {}) {
    return {{x * Vector<Dim>::Unit(0), radius}, Vector<Dim>::Zero(), std::move(children)};
}

/// Seven nodes named in a mixed order; the numbers after layout stand to the right.
template <int Dim>
std::vector<TreeNode<Dim>> sample() {
    return {
        node<Dim>(0, 9, {4, 2}),     // 0
        node<Dim>(10, 1),            // 5
        node<Dim>(20, 5, {3}),       // 2
        node<Dim>(30, 2),            // 6
        node<Dim>(40, 6, {6, 5, 1})  // 1
        ,
        node<Dim>(50, 3),  // 4
        node<Dim>(60, 4),  // 3
    };
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a tree lies level by level with siblings side by side", "[tree]",
                       ((int Dim), Dim), 2, 3) {
    const auto nodes = sample<Dim>();
    const SphereTree<Dim> tree = lay_out<Dim>(std::span(nodes));
    CHECK(tree.size() == 7);
    CHECK(tree.levels() == 3);
    CHECK(tree.radius == std::vector<double>{9, 6, 5, 4, 3, 1, 2});
    CHECK(tree.centre[0] == std::vector<double>{0, 40, 20, 60, 50, 10, 30});
    CHECK(tree.level_begin == std::vector<std::int32_t>{0, 1, 3, 7});
    CHECK(tree.child_count == std::vector<std::int32_t>{2, 3, 1, 0, 0, 0, 0});
    CHECK(tree.parent == std::vector<std::int32_t>{-1, 0, 0, 1, 1, 1, 2});
    CHECK(tree.first_child[0] == 1);
    CHECK(tree.first_child[1] == 3);
    CHECK(tree.first_child[2] == 6);
    CHECK(tree.level_of(0) == 0);
    CHECK(tree.level_of(2) == 1);
    CHECK(tree.level_of(6) == 2);
    CHECK(tree.extent == 64);  // the ball of radius 4 at 60
}

TEMPLATE_TEST_CASE_SIG("level nodes are the level's own and the leaves above it", "[tree]",
                       ((int Dim), Dim), 2, 3) {
    std::vector<TreeNode<Dim>> nodes = sample<Dim>();
    nodes[2].children.clear();  // a leaf at level 1
    nodes.erase(nodes.begin() + 3);
    nodes[3].children = {5, 4, 1};
    nodes[0].children = {3, 2};
    const SphereTree<Dim> tree = lay_out<Dim>(std::span(nodes));
    CHECK(tree.level_nodes(0) == std::vector<int>{0});
    CHECK(tree.level_nodes(1) == std::vector<int>{1, 2});
    CHECK(tree.level_nodes(2) == std::vector<int>{2, 3, 4, 5});
    CHECK(tree.level_nodes(99) == tree.level_nodes(2));
    CHECK(tree.is_leaf(2));
    CHECK_FALSE(tree.is_leaf(1));
}

TEMPLATE_TEST_CASE_SIG("a layout keeps every ball, normal and parent", "[tree]", ((int Dim), Dim),
                       2, 3) {
    Random random(11);
    for (int trial = 0; trial < 50; ++trial) {
        const auto nodes = random_nodes<Dim>(random, 4, 5);
        const SphereTree<Dim> tree = lay_out<Dim>(std::span(nodes));
        REQUIRE(tree.size() == static_cast<int>(nodes.size()));
        // Both are breadth first here, so the numbers stay.
        for (int i = 0; i < tree.size(); ++i) {
            const TreeNode<Dim>& grown = nodes[static_cast<std::size_t>(i)];
            CHECK(tree.sphere(i).centre == grown.sphere.centre);
            CHECK(tree.sphere(i).radius == grown.sphere.radius);
            CHECK(tree.mean_normal(i) == grown.mean_normal);
            for (int child : grown.children) CHECK(tree.parent[SphereTree<Dim>::index(child)] == i);
            CHECK((tree.sphere(i).centre.norm() + tree.sphere(i).radius) <= tree.extent);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("nodes that form no tree are refused", "[tree]", ((int Dim), Dim), 2, 3) {
    const auto refused = [](std::vector<TreeNode<Dim>> nodes) {
        CHECK_THROWS_AS(lay_out<Dim>(std::span<const TreeNode<Dim>>(nodes)), Error);
    };
    refused({});
    refused({node<Dim>(0, 1, {1})});                                            // no such child
    refused({node<Dim>(0, 1, {-1})});                                           //
    refused({node<Dim>(0, 1), node<Dim>(0, 1)});                                // not reached
    refused({node<Dim>(0, 1, {1, 1}), node<Dim>(0, 1)});                        // twice
    refused({node<Dim>(0, 1, {1}), node<Dim>(0, 1, {0})});                      // a circle
    refused({node<Dim>(0, 1, {1, 2}), node<Dim>(0, 1, {2}), node<Dim>(0, 1)});  // two parents
}

TEMPLATE_TEST_CASE_SIG("a ball is a tree of one leaf", "[tree]", ((int Dim), Dim), 2, 3) {
    const SphereTree<Dim> tree = single_sphere<Dim>({planar<Dim>(1, 2), 3.0});
    CHECK(tree.size() == 1);
    CHECK(tree.levels() == 1);
    CHECK(tree.is_leaf(0));
    CHECK(tree.level_nodes(5) == std::vector<int>{0});
}

TEMPLATE_TEST_CASE_SIG("a level's error is what its balls stand out of their children, added up",
                       "[tree]", ((int Dim), Dim), 2, 3) {
    // Two balls of half the radius to either side: furthest from them is the ball's top, or bottom.
    std::vector<TreeNode<Dim>> nodes(3);
    nodes[0] = {{Vector<Dim>::Zero(), 1}, Vector<Dim>::Zero(), {1, 2}};
    nodes[1].sphere = {0.5 * Vector<Dim>::Unit(0), 0.5};
    nodes[2].sphere = {-0.5 * Vector<Dim>::Unit(0), 0.5};
    const auto once = lay_out<Dim>(std::span<const TreeNode<Dim>>(nodes));
    const double excess = std::sqrt(1.25) - 0.5;
    REQUIRE(once.level_error.size() == 2);
    CHECK(once.error_at(0) == Approx(excess));
    CHECK(once.error_at(1) == 0);
    CHECK(once.error_at(2) == 0);

    // One of them has two of its own, which leave out half as much.
    nodes[1].children = {3, 4};
    for (const double side : {0.25, -0.25})
        nodes.push_back({{(0.5 + side) * Vector<Dim>::Unit(0), 0.25}, Vector<Dim>::Zero(), {}});
    const auto twice = lay_out<Dim>(std::span<const TreeNode<Dim>>(nodes));
    CHECK(twice.error_at(0) == Approx(1.5 * excess));
    CHECK(twice.error_at(1) == Approx(0.5 * excess));
    CHECK(single_sphere<Dim>({Vector<Dim>::Zero(), 1}).error_at(0) == 0);
}
