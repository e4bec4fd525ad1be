#include "lodlab/core/broad/static_bodies.hpp"

#include <set>

#include "lodlab/core/frame/broad_phase.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/property.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// Whether the ball that holds a body overlaps any leaf of another.
template <int Dim>
bool reaches_a_leaf(const Body<Dim>& mover, const Body<Dim>& wall) {
    PosedTree<Dim> posed;
    posed.pose(wall);
    for (int node = 0; node < wall.tree->size(); ++node) {
        if (!wall.tree->is_leaf(node)) continue;
        const Sphere<Dim> leaf = posed.sphere(node);
        const Vector<Dim> root =
            mover.position + Space<Dim>::rotation(mover.orientation) * mover.tree->sphere(0).centre;
        if ((leaf.centre - root).norm() <= leaf.radius + mover.tree->radius[0]) return true;
    }
    return false;
}

/// Four walls, or more in space, of 20 m around a room, each a tree of balls.
template <int Dim>
std::vector<Body<Dim>> room() {
    std::vector<Body<Dim>> walls;
    const auto tree = box_tree<Dim>(20, 0.2, 4);
    for (const double side : {-10.0, 10.0}) {
        walls.push_back(immovable<Dim>());
        walls.back().tree = tree;
        walls.back().position = planar<Dim>(0, side);
        walls.push_back(walls.back());
        walls.back().position = planar<Dim>(side, 0);
        walls.back().orientation =
            Space<Dim>::turned(Space<Dim>::unturned(), planar_spin<Dim>(std::acos(0.0)));
    }
    return walls;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("no body that reaches a leaf of a static one is missed", "[broad_phase]",
                       ((int Dim), Dim), 2, 3) {
    check_property(51, 60, [](std::uint64_t seed) {
        Random random(seed);
        std::vector<Body<Dim>> bodies;
        for (int i = 0; i < 24; ++i) {
            bodies.push_back(random_body<Dim>(random));
            const bool is_static = random.below(3) == 0;
            bodies.back().tree = random_tree<Dim>(
                random, is_static ? 5 : 2, 4, is_static ? random.in(0.5, 3) : random.in(0.05, 1));
            if (is_static) make_static(bodies.back());
        }
        BroadPhase<Dim> broad_phase;
        std::vector<CandidatePair> pairs;
        for (int frame = 0; frame < 3; ++frame) {
            const auto world_S = posed(bodies);
            broad_phase.find(bodies, world_S, pairs);
            std::set<std::pair<int, int>> found;
            for (const auto& pair : pairs) found.insert({pair.a, pair.b});
            RC_ASSERT(found.size() == pairs.size());
            for (int a = 0; a < 24; ++a)
                for (int b = a + 1; b < 24; ++b) {
                    const Body<Dim>& one = bodies[at(a)];
                    const Body<Dim>& other = bodies[at(b)];
                    const bool is_found = found.count({a, b}) == 1;
                    if (one.is_static() && other.is_static()) RC_ASSERT(!is_found);
                    const bool roots_meet =
                        box_of(world_S[at(a)], 0).meets(box_of(world_S[at(b)], 0));
                    if (is_found) RC_ASSERT(roots_meet);
                    if (one.is_static() != other.is_static() &&
                        (one.is_static() ? reaches_a_leaf(other, one) : reaches_a_leaf(one, other)))
                        RC_ASSERT(is_found);
                    if (!one.is_static() && !other.is_static()) RC_ASSERT(is_found == roots_meet);
                }
            for (auto& body : bodies)
                if (!body.is_static()) body.position += 0.1 * body.velocity;
            bodies[at(random.below(24))].position += random_vector<Dim>(random, 0.1);
        }
    });
}

TEMPLATE_TEST_CASE_SIG("a wall with a tree is a candidate of those near it, not of the whole room",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies = room<Dim>();
    Random random(52);
    for (int i = 0; i < 400; ++i) {
        bodies.push_back(disc<Dim>(1, 0.3, {random.in(-9, 9), random.in(-9, 9)}));
    }
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> pairs;
    broad_phase.find(bodies, posed(bodies), pairs);
    // At 64 nodes a wall is 8 balls long, of 1.25 m radius; and 8 times at each place.
    int with_walls = 0;
    for (const auto& [wall, body] : pairs) {
        if (wall >= 4) continue;
        ++with_walls;
        const Vector<Dim> place = bodies[at(body)].position - bodies[at(wall)].position;
        CHECK(std::abs(place[wall % 2 == 0 ? 1 : 0]) <= 1.25 + 0.1 + 0.3);
    }
    CHECK(with_walls > 40);
    CHECK(with_walls < 240);  // 1,600 by their root balls
}

TEMPLATE_TEST_CASE_SIG("a static body of like size is a candidate as its root ball is",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    // A wall of 20 m: its root ball's radius is 10 m, its nodes' at level 1 are 5 m; each is told
    // apart only where it is more than four times as large as the other.
    std::vector<Body<Dim>> bodies{room<Dim>()[0], disc<Dim>(1, 2.6, {0, -2})};
    const auto pairs_of = [&](double radius, double y) {
        bodies[1] = disc<Dim>(1, radius, {0, y});
        BroadPhase<Dim> broad_phase;
        std::vector<CandidatePair> pairs;
        broad_phase.find(bodies, posed(bodies), pairs);
        return pairs.size();
    };
    CHECK(bodies[0].position[1] == -10);
    CHECK(pairs_of(2.51, 2.4) == 1);  // root balls
    CHECK(pairs_of(2.51, 2.6) == 0);
    CHECK(pairs_of(2.49, 2.4) == 0);  // level 1, up to y = -5
    CHECK(pairs_of(2.49, -2.6) == 1);
    CHECK(pairs_of(1.24, -2.6) == 0);  // level 2, up to y = -7.5
    CHECK(pairs_of(1.24, -6.3) == 1);
}

TEMPLATE_TEST_CASE_SIG("the tree of static bodies is built once, until one of them changes",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies = room<Dim>();
    StaticBodies<Dim> standing;
    double largest = 0.3;
    std::vector<std::int32_t> numbers{0, 1, 2, 3};
    const auto built = [&] {
        standing.update(numbers, bodies, posed(bodies), largest);
        return standing.built();
    };
    CHECK(built() == 1);
    CHECK(built() == 1);
    bodies[2].position[0] += 1e-3;
    CHECK(built() == 2);
    bodies[3].orientation = Space<Dim>::turned(bodies[3].orientation, planar_spin<Dim>(1e-3));
    CHECK(built() == 3);
    bodies[0].tree = box_tree<Dim>(20, 0.3, 4);
    CHECK(built() == 4);
    numbers.pop_back();
    CHECK(built() == 5);
    largest = 0.2;
    CHECK(built() == 6);
    CHECK(built() == 6);

    std::vector<CandidatePair> pairs;
    standing.find({{planar<Dim>(0, 9), planar<Dim>(0, 9.9)}, 7}, pairs);
    CHECK(pairs == std::vector<CandidatePair>{{2, 7}});
}

TEMPLATE_TEST_CASE_SIG("many static bodies cost each body that moves log n", "[broad_phase]",
                       ((int Dim), Dim), 2, 3) {
    int logarithm = 10;
    for (const int count : {1024, 2048, 4096}) {
        Random random(53);
        std::vector<Body<Dim>> bodies;
        const double room = std::pow(count, 1.0 / Dim);
        for (int i = 0; i < 2 * count; ++i) {
            bodies.push_back(disc<Dim>(1, 0.4, {0, 0}));
            bodies.back().position = random_vector<Dim>(random, room);
            if (i % 2 == 0) make_static(bodies.back());
        }
        BroadPhase<Dim> broad_phase;
        std::vector<CandidatePair> pairs;
        broad_phase.find(bodies, posed(bodies), pairs);
        CHECK(broad_phase.steps() <= static_cast<std::uint64_t>(6 * count * logarithm));
        ++logarithm;
    }
}
