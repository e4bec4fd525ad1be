#include "lodlab/core/tree/traversal.hpp"

#include <algorithm>

#include "lodlab/core/frame/schedule.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/property.hpp"

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
Body<Dim> with_tree(std::shared_ptr<const SphereTree<Dim>> tree, Planar place = {0, 0},
                    double angle = 0) {
    Body<Dim> body = planar_body<Dim>(1, 1, place);
    body.orientation = Space<Dim>::turned(body.orientation, planar_spin<Dim>(angle));
    body.tree = std::move(tree);
    return body;
}

template <int Dim>
Body<Dim> random_placed(Random& random, int depth, int branching, double room) {
    Body<Dim> body = random_body<Dim>(random);
    body.tree = random_tree<Dim>(random, depth, branching);
    body.position = random_vector<Dim>(random, room);
    return body;
}

/// One of several that overlap as a rule, each with a tree of its own depth.
template <int Dim>
Body<Dim> random_near(Random& random) {
    const int depth = 1 + random.below(4);
    const int branching = 1 + random.below(5);
    return random_placed<Dim>(random, depth, branching, 0.6);
}

bool by_numbers(const NodePair& x, const NodePair& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
}

std::vector<NodePair> sorted(std::vector<NodePair> pairs) {
    std::sort(pairs.begin(), pairs.end(), by_numbers);
    return pairs;
}

template <int Dim>
Sphere<Dim> in_world(const Body<Dim>& body, int node) {
    const Sphere<Dim> local = body.tree->sphere(node);
    return {body.position + Space<Dim>::rotation(body.orientation) * local.centre, local.radius};
}

/// Every overlapping pair of the nodes that two bodies stand for at a level, found without trees.
template <int Dim>
std::vector<NodePair> brute_force(const Body<Dim>& a, const Body<Dim>& b, int level) {
    std::vector<NodePair> pairs;
    for (const int i : a.tree->level_nodes(level))
        for (const int k : b.tree->level_nodes(level))
            if (overlap(in_world(a, i), in_world(b, k))) pairs.push_back({i, k});
    return sorted(pairs);
}

template <int Dim>
std::uint64_t tests_of_next_level(const Body<Dim>& a, const Body<Dim>& b, const Front& front) {
    std::uint64_t tests = 0;
    for (const auto& [i, k] : front.pairs) {
        const int n = a.tree->child_count[SphereTree<Dim>::index(i)];
        const int m = b.tree->child_count[SphereTree<Dim>::index(k)];
        if (n > 0 || m > 0) tests += static_cast<std::uint64_t>(std::max(n, 1) * std::max(m, 1));
    }
    return tests;
}

template <int Dim>
std::shared_ptr<const SphereTree<Dim>> flat_family(int children) {
    std::vector<TreeNode<Dim>> nodes(1);
    nodes[0].sphere.radius = 1;
    for (int c = 0; c < children; ++c) {
        nodes[0].children.push_back(c + 1);
        nodes.push_back(
            {{planar<Dim>(-0.9 + 1.8 * c / children, 0), 0.1}, Vector<Dim>::Zero(), {}});
    }
    return std::make_shared<SphereTree<Dim>>(lay_out<Dim>(std::span(nodes)));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("every level holds what brute force finds among its nodes", "[traversal]",
                       ((int Dim), Dim), 2, 3) {
    // The balls nest, so no overlapping pair hides below one that is apart. Depths differ.
    check_property(71, 200, [](std::uint64_t seed) {
        Random random(seed);
        const auto a = random_near<Dim>(random);
        const auto b = random_near<Dim>(random);
        const std::vector<Front> levels = traverse_levels(a, b);
        for (std::size_t level = 0; level < levels.size(); ++level) {
            RC_ASSERT(levels[level].level == static_cast<int>(level));
            RC_ASSERT(sorted(levels[level].pairs) == brute_force(a, b, static_cast<int>(level)));
        }
        // The finest level is that of the deeper tree, unless they part before.
        const Front& finest = levels.back();
        RC_ASSERT(finest.finest);
        if (finest.verdict == Verdict::apart)
            RC_ASSERT(finest.pairs.empty());
        else
            RC_ASSERT(sorted(finest.pairs) == brute_force(a, b, 100));
    });
}

TEMPLATE_TEST_CASE_SIG("many levels in one go end at the front of that level", "[traversal]",
                       ((int Dim), Dim), 2, 3) {
    check_property(74, 200, [](std::uint64_t seed) {
        Random random(seed);
        const auto a = random_near<Dim>(random);
        const auto b = random_near<Dim>(random);
        const std::vector<Front> levels = traverse_levels(a, b);
        const int last = random.below(7);
        PosedTree<Dim> posed_a;
        PosedTree<Dim> posed_b;
        posed_a.pose(a);
        posed_b.pose(b);
        FrontList list;
        ListedFront front;
        test_roots(posed_a, posed_b, front, list);
        const std::uint64_t tests = refine_to(posed_a, posed_b, last, front, list);
        const std::size_t end = std::min(at(last), levels.size() - 1);
        RC_ASSERT(front.level == static_cast<int>(end));
        RC_ASSERT(front.verdict == levels[end].verdict);
        RC_ASSERT(front.finest == levels[end].finest);
        RC_ASSERT(front.tests == levels[end].tests);
        RC_ASSERT(tests == (end > 0 ? levels[end].tests - levels[end - 1].tests : 0));
        RC_ASSERT(sorted(list.front(front).pairs) == sorted(levels[end].pairs));
    });
}

TEMPLATE_TEST_CASE_SIG("the traversal counts one test for each pair of nodes it compares",
                       "[traversal]", ((int Dim), Dim), 2, 3) {
    Random random(72);
    for (int trial = 0; trial < 100; ++trial) {
        const auto a = random_placed<Dim>(random, 3, 6, 0.5);
        const auto b = random_placed<Dim>(random, 4, 3, 0.5);
        const std::vector<Front> levels = traverse_levels(a, b);
        CHECK(levels[0].tests == 1);
        for (std::size_t k = 0; k + 1 < levels.size(); ++k)
            CHECK(levels[k + 1].tests - levels[k].tests == tests_of_next_level(a, b, levels[k]));
    }
}

TEMPLATE_TEST_CASE_SIG("exchanging the bodies exchanges the node pairs", "[traversal]",
                       ((int Dim), Dim), 2, 3) {
    Random random(73);
    for (int trial = 0; trial < 100; ++trial) {
        const auto a = random_placed<Dim>(random, 3, 4, 0.5);
        const auto b = random_placed<Dim>(random, 2, 5, 0.5);
        const auto forward = traverse_levels(a, b);
        const auto backward = traverse_levels(b, a);
        REQUIRE(forward.size() == backward.size());
        for (std::size_t k = 0; k < forward.size(); ++k) {
            std::vector<NodePair> turned;
            for (const auto& [i, j] : backward[k].pairs) turned.push_back({j, i});
            CHECK(sorted(turned) == sorted(forward[k].pairs));
            CHECK(forward[k].tests == backward[k].tests);
            CHECK(forward[k].verdict == backward[k].verdict);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("families of every size are tested whole", "[traversal]", ((int Dim), Dim),
                       2, 3) {
    // Around the blocks of the distance test and the questions to the budget.
    for (const int n : {1, 2, 3, 4, 5, 7, 8, 9, 31, 63, 64, 65, 130}) {
        const auto one = with_tree<Dim>(flat_family<Dim>(n));
        const auto ball = disc<Dim>(1, 0.35, {0.3, 0.3});
        for (const bool swapped : {false, true}) {
            const auto& a = swapped ? ball : one;
            const auto& b = swapped ? one : ball;
            const auto levels = traverse_levels(a, b);
            REQUIRE(levels.size() == 2);
            CHECK(sorted(levels[1].pairs) == brute_force(a, b, 1));
            CHECK(levels[1].tests == 1 + static_cast<std::uint64_t>(n));
            CHECK(levels[1].finest);
        }
        const auto other = with_tree<Dim>(flat_family<Dim>(5), {0.2, 0.1}, 1.1);
        CHECK(sorted(traverse_levels(one, other)[1].pairs) == brute_force(one, other, 1));
    }
}

TEMPLATE_TEST_CASE_SIG("a leaf stays and meets the other side's children", "[traversal]",
                       ((int Dim), Dim), 2, 3) {
    const auto ball = disc<Dim>(1, 0.5, {1.2, 0.1});
    const auto box = with_tree<Dim>(box_tree<Dim>(2, 2, 3));
    const auto levels = traverse_levels(ball, box);
    REQUIRE(levels.size() == 4);
    for (const Front& front : levels)
        for (const NodePair& pair : front.pairs) {
            CHECK(pair.a == 0);
            CHECK(box.tree->level_of(pair.b) == front.level);
        }
    CHECK(levels[2].verdict == Verdict::possible);
    CHECK_FALSE(levels[2].finest);
    CHECK(levels[3].verdict == Verdict::true_collision);
    CHECK(levels[3].finest);
}

TEMPLATE_TEST_CASE_SIG("two leaves are carried on without a test", "[traversal]", ((int Dim), Dim),
                       2, 3) {
    // A root with a leaf and a family; the leaf pair of level 1 must still be there at level 2.
    const std::vector<TreeNode<Dim>> nodes{{{planar<Dim>(0, 0), 3}, Vector<Dim>::Zero(), {1, 2}},
                                           {{planar<Dim>(-1, 0), 1}, Vector<Dim>::Zero(), {}},
                                           {{planar<Dim>(1, 0), 1}, Vector<Dim>::Zero(), {3, 4}},
                                           {{planar<Dim>(1, 0.3), 0.5}, Vector<Dim>::Zero(), {}},
                                           {{planar<Dim>(1, -0.3), 0.5}, Vector<Dim>::Zero(), {}}};
    const auto tree = std::make_shared<SphereTree<Dim>>(lay_out<Dim>(std::span(nodes)));
    const auto levels = traverse_levels(with_tree<Dim>(tree), with_tree<Dim>(tree, {0, 0.1}));
    REQUIRE(levels.size() == 3);
    const auto leaf_pair = [](const Front& front) {
        return std::count(front.pairs.begin(), front.pairs.end(), NodePair{1, 1});
    };
    CHECK(leaf_pair(levels[1]) == 1);
    CHECK(leaf_pair(levels[2]) == 1);
    CHECK(levels[1].verdict == Verdict::true_collision);
    CHECK_FALSE(levels[1].finest);
}

TEMPLATE_TEST_CASE_SIG("bodies that are apart are proved apart at the first level that shows it",
                       "[traversal]", ((int Dim), Dim), 2, 3) {
    const auto box = box_tree<Dim>(2, 2, 4);
    const auto a = with_tree<Dim>(box);
    const auto far = traverse_levels(a, with_tree<Dim>(box, {5, 0}));
    REQUIRE(far.size() == 1);
    CHECK(far[0].verdict == Verdict::apart);
    CHECK(far[0].finest);
    // Boxes 0.5 apart: a level's circles stand out by (sqrt 2 - 1) / 2 of its squares' width.
    // 2 at the root, so 0.41 on either side; 0.21 at level 1, which is less than half the gap.
    const auto near = traverse_levels(a, with_tree<Dim>(box, {2.5, 0}));
    REQUIRE(near.size() == 2);
    CHECK(near[0].verdict == Verdict::possible);
    CHECK(near[1].verdict == Verdict::apart);
}

TEMPLATE_TEST_CASE_SIG("the deepest level asked for is the last one", "[traversal]",
                       ((int Dim), Dim), 2, 3) {
    const auto a = with_tree<Dim>(box_tree<Dim>(2, 2, 4));
    const auto b = with_tree<Dim>(box_tree<Dim>(2, 2, 4), {1.5, 0.2}, 0.3);
    CHECK(traverse_levels(a, b).size() == 5);
    CHECK(traverse_levels(a, b, 2).size() == 3);
    CHECK(traverse_levels(a, b, 0).size() == 1);
}

TEMPLATE_TEST_CASE_SIG("every budget ends at the last level that it could finish", "[traversal]",
                       ((int Dim), Dim), 2, 3) {
    Random random(74);
    FrontList list;
    for (int trial = 0; trial < 40; ++trial) {
        const auto a = random_placed<Dim>(random, 3, 4, 0.4);
        const auto b = random_placed<Dim>(random, 3, 4, 0.4);
        const auto levels = traverse_levels(a, b);
        PosedTree<Dim> world_a;
        PosedTree<Dim> world_b;
        for (std::uint64_t quota = 0; quota <= levels.back().tests; ++quota) {
            world_a.pose(a);
            world_b.pose(b);
            Budget budget = Budget::node_tests(quota);
            list.clear();
            ListedFront front;
            test_roots(world_a, world_b, front, list);
            budget.spend(1);
            while (!front.finest &&
                   refine(world_a, world_b, budget, front, list) == Refinement::finished) {
            }
            std::size_t last = 0;
            while (last + 1 < levels.size() && levels[last + 1].tests <= quota) ++last;
            CHECK(front.level == static_cast<int>(last));
            CHECK(list.front(front).pairs == levels[last].pairs);
            CHECK(front.verdict == levels[last].verdict);
            CHECK(front.finest == levels[last].finest);
            CHECK(front.tests == std::max<std::uint64_t>(1, quota));
        }
    }
}

TEMPLATE_TEST_CASE_SIG("trees whose radii overflow are not called apart", "[traversal]",
                       ((int Dim), Dim), 2, 3) {
    std::vector<TreeNode<Dim>> nodes(2);
    nodes[0] = {{Vector<Dim>::Zero(), 1e200}, Vector<Dim>::Zero(), {1}};
    nodes[1] = {{Vector<Dim>::Zero(), 1e200}, Vector<Dim>::Zero(), {}};
    const auto tree = std::make_shared<SphereTree<Dim>>(lay_out<Dim>(std::span(nodes)));
    Body<Dim> b = with_tree<Dim>(tree);
    b.position[0] = 1e180;
    const auto levels = traverse_levels(with_tree<Dim>(tree), b);
    CHECK(levels.back().verdict == Verdict::true_collision);
}

TEMPLATE_TEST_CASE_SIG("whether nodes of a level overlap is what the front of that level says",
                       "[traversal]", ((int Dim), Dim), 2, 3) {
    Random random(67);
    FrontList room;
    int apart = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Body<Dim> a = random_placed<Dim>(random, 4, trial % 10 == 0 ? 12 : 4, 1.2);
        Body<Dim> b = random_placed<Dim>(random, 3, 4, 1.2);
        if (trial % 7 == 0)
            b.tree =
                std::make_shared<const SphereTree<Dim>>(half_space<Dim>(random_unit<Dim>(random)));
        PosedTree<Dim> world_a;
        PosedTree<Dim> world_b;
        world_a.pose(a);
        world_b.pose(b);
        const std::vector<Front> levels = traverse_levels(a, b);
        for (int level = 0; level < 7; ++level) {
            const auto last = std::min(static_cast<std::size_t>(level), levels.size() - 1);
            CHECK(overlap_at(world_a, world_b, level, room) == !levels[last].pairs.empty());
            CHECK(room.size() == 0);
        }
        apart += levels.back().pairs.empty();
    }
    CHECK(apart > 30);
    CHECK(apart < 270);
}

TEMPLATE_TEST_CASE_SIG("a ball that is changed counts once its tree is renewed", "[traversal]",
                       ((int Dim), Dim), 2, 3) {
    // Two leaves of radius 1 in a root of 2; the left one grows to 1.5, so that it now reaches a
    // ball of 1 whose centre is 2.4 further left.
    const std::vector<TreeNode<Dim>> nodes{{{Vector<Dim>::Zero(), 3}, Vector<Dim>::Zero(), {1, 2}},
                                           {{-Vector<Dim>::Unit(0), 1}, Vector<Dim>::Zero(), {}},
                                           {{Vector<Dim>::Unit(0), 1}, Vector<Dim>::Zero(), {}}};
    auto tree = std::make_shared<SphereTree<Dim>>(lay_out<Dim>(nodes));
    const auto ball =
        std::make_shared<SphereTree<Dim>>(single_sphere<Dim>({Vector<Dim>::Zero(), 1}));
    const auto at_leaves = [&] {
        return traverse_levels(with_tree<Dim>(tree), with_tree<Dim>(ball, {-3.4, 0}))
            .back()
            .pairs.size();
    };
    CHECK(at_leaves() == 0);
    tree->radius[1] = 1.5;
    renew(*tree);
    CHECK(at_leaves() == 1);
    CHECK(tree->extent == Approx(3));
}
