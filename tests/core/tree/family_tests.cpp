#include "lodlab/core/tree/family_tests.hpp"

#include <algorithm>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/property.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// Makes traversals take one path, until it goes.
class Taken {
  public:
    explicit Taken(const detail::TestPath& path) { detail::take_path(path); }
    ~Taken() { detail::take_path(before_); }
    Taken(const Taken&) = delete;
    Taken& operator=(const Taken&) = delete;

  private:
    const detail::TestPath& before_ = detail::test_path();
};

/// The children of every pair of a front that meet, by plain loops in double precision: each ball
/// carried to the world, the first one's radius (of two families A's, of a leaf and a family the
/// leaf's) grown by what rounding may have moved the two.
template <int Dim>
std::vector<NodePair> next_level(const Body<Dim>& body_a, const Body<Dim>& body_b,
                                 const std::vector<NodePair>& front) {
    PosedTree<Dim> a;
    PosedTree<Dim> b;
    a.pose(body_a);
    b.pose(body_b);
    const auto family = [](const SphereTree<Dim>& tree, int node) {
        const std::size_t n = SphereTree<Dim>::index(node);
        if (tree.is_leaf(node)) return Range{node, 1};
        return Range{tree.first_child[n], tree.child_count[n]};
    };
    std::vector<NodePair> met;
    for (const NodePair& nodes : front) {
        const bool leaf_a = a.tree().is_leaf(nodes.a);
        const bool leaf_b = b.tree().is_leaf(nodes.b);
        const Range of_a = family(a.tree(), nodes.a);
        const Range of_b = family(b.tree(), nodes.b);
        for (std::int32_t i = of_a.first; i < of_a.first + of_a.count; ++i)
            for (std::int32_t k = of_b.first; k < of_b.first + of_b.count; ++k) {
                Sphere<Dim> ball_a = a.sphere(i);
                Sphere<Dim> ball_b = b.sphere(k);
                (leaf_b && !leaf_a ? ball_b : ball_a).radius += a.rounding() + b.rounding();
                if ((leaf_a && leaf_b) || overlap(ball_a, ball_b)) met.push_back({i, k});
            }
    }
    return met;
}

template <int Dim>
void check_all_paths(const Body<Dim>& a, const Body<Dim>& b) {
    for (const detail::TestPath& path : detail::test_paths()) {
        const Taken taken(path);
        const std::vector<Front> levels = traverse_levels(a, b);
        for (std::size_t k = 0; k < levels.size(); ++k) {
            INFO(path.name << ", level " << k);
            if (k > 0) CHECK(levels[k].pairs == next_level(a, b, levels[k - 1].pairs));
            const bool leaves = std::any_of(
                levels[k].pairs.begin(), levels[k].pairs.end(), [&](const NodePair& pair) {
                    return a.tree->is_leaf(pair.a) && b.tree->is_leaf(pair.b);
                });
            CHECK((levels[k].verdict == Verdict::true_collision) == leaves);
        }
    }
}

template <int Dim>
Body<Dim> placed(Random& random, double size, int depth, int branching) {
    Body<Dim> body = random_body<Dim>(random);
    body.tree = random_tree<Dim>(random, depth, branching, size);
    body.position = size * random_vector<Dim>(random, 0.8);
    return body;
}

/// A root about the origin with these balls for children.
template <int Dim>
std::shared_ptr<const SphereTree<Dim>> one_family(const std::vector<Sphere<Dim>>& balls) {
    std::vector<TreeNode<Dim>> nodes(1);
    for (const Sphere<Dim>& ball : balls) {
        nodes[0].sphere.radius = std::max(nodes[0].sphere.radius, ball.centre.norm() + ball.radius);
        nodes[0].children.push_back(static_cast<int>(nodes.size()));
        nodes.push_back({ball, Vector<Dim>::Zero(), {}});
    }
    return std::make_shared<SphereTree<Dim>>(lay_out<Dim>(std::span(nodes)));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG(
    "every way of computing finds the pairs that plain loops find, in their order",
    "[family_tests]", ((int Dim), Dim), 2, 3) {
    // Sizes from those of molecules to those of galaxies, families from one node to dozens, leaves
    // at any level.
    check_property(61, 120, [](std::uint64_t seed) {
        Random random(seed);
        const double size = std::pow(10, random.in(-12, 12));
        const int branching = 1 + random.below(random.below(4) == 0 ? 40 : 9);
        const int depth = branching > 9 ? 2 : 3;
        check_all_paths<Dim>(placed<Dim>(random, size, depth, branching),
                             placed<Dim>(random, size * random.in(0.1, 1), depth, branching));
    });
}

TEMPLATE_TEST_CASE_SIG("balls that touch to the last bit meet on every way of computing or on none",
                       "[family_tests]", ((int Dim), Dim), 2, 3) {
    Random random(62);
    for (int trial = 0; trial < 300; ++trial) {
        Body<Dim> a = random_body<Dim>(random);
        Body<Dim> b = random_body<Dim>(random);
        const double far = trial % 3 == 0 ? 1e9 : trial % 3 == 1 ? 1 : 1e-9;
        const double size = trial % 3 == 2 ? 1e-9 : 1;
        a.position = random_vector<Dim>(random, far);
        b.position = a.position + size * random_unit<Dim>(random);
        std::vector<Sphere<Dim>> of_a;
        std::vector<Sphere<Dim>> of_b;
        // Each ball of B ends where a ball of A does, but for a few units in the last place.
        for (int i = 0; i < 8; ++i) {
            of_a.push_back({size * random_vector<Dim>(random, 1), size * random.in(0, 0.5)});
            const Vector<Dim> centre = size * random_vector<Dim>(random, 1);
            const Vector<Dim> between = (b.position - a.position) +
                                        Space<Dim>::rotation(b.orientation) * centre -
                                        Space<Dim>::rotation(a.orientation) * of_a.back().centre;
            const double radius = between.norm() - of_a.back().radius;
            of_b.push_back({centre, std::max(0.0, radius * (1 + (random.below(9) - 4) * 0x1p-53))});
        }
        a.tree = one_family<Dim>(of_a);
        b.tree = one_family<Dim>(of_b);
        check_all_paths(a, b);
    }
}

TEMPLATE_TEST_CASE_SIG("points on one another meet on every way of computing", "[family_tests]",
                       ((int Dim), Dim), 2, 3) {
    const std::vector<Sphere<Dim>> points(5, {Vector<Dim>::Zero(), 0});
    Body<Dim> body = planar_body<Dim>(1, 1);
    body.tree = one_family<Dim>(points);
    for (const detail::TestPath& path : detail::test_paths()) {
        const Taken taken(path);
        CHECK(traverse_levels(body, body).back().pairs.size() == 25);
    }
    check_all_paths(body, body);
}

TEMPLATE_TEST_CASE_SIG("a border collides truly where leaves reach it, and perhaps above them",
                       "[family_tests]", ((int Dim), Dim), 2, 3) {
    Body<Dim> wall = immovable<Dim>();
    wall.tree = std::make_shared<const SphereTree<Dim>>(half_space<Dim>(planar<Dim>(1, 0)));
    Body<Dim> box = planar_body<Dim>(1, 1);
    box.tree = box_tree<Dim>(2, 1, 2);
    const std::vector<Front> levels = traverse_levels(wall, box);
    REQUIRE(levels.size() == 3);
    CHECK(levels[0].verdict == Verdict::possible);
    CHECK(levels[1].verdict == Verdict::possible);
    CHECK(levels[2].verdict == Verdict::true_collision);
    CHECK(levels[2].finest);
}

TEMPLATE_TEST_CASE_SIG("without its copy in single precision a tree is tested in double",
                       "[family_tests]", ((int Dim), Dim), 2, 3) {
    Random random(63);
    for (int trial = 0; trial < 20; ++trial) {
        Body<Dim> a = placed<Dim>(random, 1, 3, 5);
        const Body<Dim> b = placed<Dim>(random, 1, 3, 5);
        const std::vector<Front> levels = traverse_levels(a, b);
        SphereTree<Dim> bare = *a.tree;
        bare.single.clear();
        a.tree = std::make_shared<const SphereTree<Dim>>(bare);
        const std::vector<Front> again = traverse_levels(a, b);
        REQUIRE(again.size() == levels.size());
        for (std::size_t k = 0; k < levels.size(); ++k) {
            CHECK(again[k].pairs == levels[k].pairs);
            CHECK(again[k].tests == levels[k].tests);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a quota ends every way of computing at the same test", "[family_tests]",
                       ((int Dim), Dim), 2, 3) {
    Random random(64);
    for (int trial = 0; trial < 30; ++trial) {
        const Body<Dim> a = placed<Dim>(random, 1, 3, trial % 2 ? 30 : 6);
        const Body<Dim> b = placed<Dim>(random, 1, 3, trial % 2 ? 30 : 6);
        PosedTree<Dim> world_a;
        PosedTree<Dim> world_b;
        world_a.pose(a);
        world_b.pose(b);
        const std::uint64_t quota = static_cast<std::uint64_t>(random.below(2000));
        std::vector<Front> ends;
        std::vector<std::uint64_t> spent;
        for (const detail::TestPath& path : detail::test_paths()) {
            const Taken taken(path);
            Budget budget = Budget::node_tests(quota, trial % 3 == 0 ? 2.5 : 0);
            FrontList list;
            ListedFront front;
            test_roots(world_a, world_b, front, list);
            while (!front.finest &&
                   refine(world_a, world_b, budget, front, list) == Refinement::finished) {
            }
            ends.push_back(list.front(front));
            spent.push_back(budget.spent());
        }
        for (std::size_t k = 0; k < ends.size(); ++k) {
            CHECK(ends[k].pairs == ends[0].pairs);
            CHECK(ends[k].tests == ends[0].tests);
            CHECK(spent[k] == spent[0]);
        }
    }
}
