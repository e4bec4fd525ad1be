// Half-spaces: walls and floors without a tree, met exactly at every level.

#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
Body<Dim> wall(const Vector<Dim>& position, const Vector<Dim>& normal) {
    Body<Dim> body = immovable<Dim>();
    body.tree = std::make_shared<SphereTree<Dim>>(half_space<Dim>(normal));
    body.position = position;
    return body;
}

template <int Dim>
FrameRecord<Dim> frame(std::vector<Body<Dim>>& bodies, const FrameSettings& settings,
                       Budget budget = Budget::unlimited()) {
    FrameStorage<Dim> storage;
    return advance<Dim>(bodies, settings, budget, storage);
}

/// How far a node lies above a border.
template <int Dim>
double height(const Body<Dim>& body, int node, const Body<Dim>& border) {
    const Sphere<Dim> ball = body.tree->sphere(node);
    const Vector<Dim> centre = body.position + Space<Dim>::rotation(body.orientation) * ball.centre;
    const Vector<Dim> normal = Space<Dim>::rotation(border.orientation) * *border.tree->half_space;
    return normal.dot(centre - border.position) - ball.radius;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a disc on a floor, by every contact model, where worked by hand",
                       "[half_space]", ((int Dim), Dim), 2, 3) {
    const std::vector<Body<Dim>> start{disc<Dim>(2, 0.5, {3, 0.45}, {0.5, -1}),
                                       wall<Dim>(planar<Dim>(0, 0), planar<Dim>(0, 3))};
    for (const bool floor_first : {false, true})
        for (const ContactModel model :
             {ContactModel::centre_line, ContactModel::node_normal, ContactModel::hull})
            for (const PointModel point :
                 {PointModel::radius_ratio, PointModel::plane_of_intersection}) {
                auto bodies = start;
                if (floor_first) std::swap(bodies[0], bodies[1]);
                FrameSettings settings;
                settings.contact_model = model;
                settings.point_model = point;
                const FrameRecord<Dim> record = frame(bodies, settings);
                REQUIRE(record.impacts.size() == 1);
                const Contact<Dim>& contact = record.impacts[0].contact;
                // From A to B: from the disc down to the floor, or up from the floor.
                CHECK((contact.normal - planar<Dim>(0, floor_first ? 1 : -1)).norm() <= 1e-15);
                CHECK(std::abs(contact.depth - 0.05) <= 1e-15);
                const double y = point == PointModel::radius_ratio ? -0.05 : 0;
                CHECK((contact.point - planar<Dim>(3, y)).norm() <= 1e-15);
                const Body<Dim>& disc = bodies[floor_first ? 1 : 0];
                CHECK((disc.velocity - planar<Dim>(0.5, 1)).norm() <= 1e-15);
                CHECK(record.pairs[0].verdict == Verdict::true_collision);
            }
}

TEMPLATE_TEST_CASE_SIG("a half-space is a candidate of what reaches into it, and of no static body",
                       "[half_space]", ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies{disc<Dim>(1, 0.5, {1e6, 0.5}),  // touches
                                  wall<Dim>(planar<Dim>(-7, 0), planar<Dim>(0, 1)),
                                  disc<Dim>(1, 0.5, {0, 0.51}),
                                  disc<Dim>(1, 0.5, {0, -1e7}),
                                  wall<Dim>(planar<Dim>(0, 0), planar<Dim>(1, 0)),
                                  immovable<Dim>()};
    bodies[5].tree = bodies[0].tree;
    FrameStorage<Dim> storage;
    Budget budget = Budget::unlimited();
    std::vector<CandidatePair> found;
    for (const PairRecord& pair : detect<Dim>(bodies, {}, budget, storage).pairs)
        found.push_back(pair.bodies);
    CHECK(found == std::vector<CandidatePair>{{0, 1}, {1, 3}, {2, 4}, {2, 5}, {3, 4}});
}

TEMPLATE_TEST_CASE_SIG("a front with a half-space holds just the level nodes that reach into it",
                       "[half_space]", ((int Dim), Dim), 2, 3) {
    Random random(541);
    int apart = 0;
    for (int trial = 0; trial < 300; ++trial) {
        Body<Dim> body = random_body<Dim>(random);
        body.tree = random_tree<Dim>(random, 3, 4, random.in(0.2, 1));
        Body<Dim> border = wall<Dim>(random_vector<Dim>(random, 1.5), random_unit<Dim>(random));
        border.orientation = random_body<Dim>(random).orientation;
        const bool first = trial % 2 == 0;
        const auto levels =
            first ? traverse_levels<Dim>(border, body) : traverse_levels<Dim>(body, border);
        for (const Front& front : levels) {
            std::vector<NodePair> expected;
            for (const int node : body.tree->level_nodes(front.level)) {
                // Parents hold their children, so a node whose ancestors are above is above itself.
                if (height(body, node, border) <= 0)
                    expected.push_back(first ? NodePair{0, node} : NodePair{node, 0});
            }
            auto found = front.pairs;
            std::ranges::sort(found, {}, [](const NodePair& pair) { return pair.a + pair.b; });
            std::ranges::sort(expected, {}, [](const NodePair& pair) { return pair.a + pair.b; });
            CHECK(found == expected);
        }
        apart += levels.back().verdict == Verdict::apart;
    }
    CHECK(apart > 20);
    CHECK(apart < 280);
}

TEMPLATE_TEST_CASE_SIG("a half-space with a mass, or without a normal, is refused", "[half_space]",
                       ((int Dim), Dim), 2, 3) {
    Body<Dim> moving = disc<Dim>(1, 1, {0, 0});
    moving.tree = std::make_shared<SphereTree<Dim>>(half_space<Dim>(planar<Dim>(0, 1)));
    CHECK_THROWS_WITH(check_body(moving, "floor"), lodtest::contains("make it static"));
    CHECK_THROWS_AS(half_space<Dim>(Vector<Dim>(Vector<Dim>::Zero())), Error);
    CHECK_THROWS_AS(half_space<Dim>(planar<Dim>(std::nan(""), 0)), Error);
}
