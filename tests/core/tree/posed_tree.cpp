#include "lodlab/core/tree/posed_tree.hpp"

#include "lodlab/core/math/eigen.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

using Wide = long double;
using WideSpin3 = Eigen::Matrix<Wide, 3, 3>;

/// The exact rotation, to extended precision: of an angle, and of a quaternion made a unit first.
Eigen::Matrix<Wide, 2, 2> wide_rotation(double angle) {
    const Wide s = std::sin(static_cast<Wide>(angle));
    const Wide c = std::cos(static_cast<Wide>(angle));
    return (Eigen::Matrix<Wide, 2, 2>() << c, -s, s, c).finished();
}
WideSpin3 wide_rotation(const Quaternion& q) {
    return to_eigen(q).cast<Wide>().normalized().toRotationMatrix();
}

template <int Dim>
Eigen::Matrix<Wide, Dim, 1> wide(const FixedMatrix<Dim, 1>& v) {
    return to_eigen(v).template cast<Wide>();
}

template <int Dim>
Eigen::Matrix<Wide, Dim, 1> wide_centre(const Body<Dim>& body, int node) {
    return wide_rotation(body.orientation) * wide(body.tree->sphere(node).centre) +
           wide(body.position);
}

template <int Dim>
Body<Dim> placed(Random& random, double far) {
    Body<Dim> body = random_body<Dim>(random);
    body.tree = random_tree<Dim>(random, 3, 4, random.in(0.1, 10));
    body.position = random_vector<Dim>(random, far);
    // A long way round, so that a quaternion has met its rounding.
    for (int i = 0; i < 20; ++i)
        body.orientation = Space<Dim>::turned(body.orientation, random_spin<Dim>(random, 3));
    return body;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("carried centres stay within the rounding bound", "[posed_tree]",
                       ((int Dim), Dim), 2, 3) {
    Random random(21);
    double worst = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Body<Dim> body = placed<Dim>(random, trial % 3 == 0 ? 1e4 : 3.0);
        PosedTree<Dim> world;
        world.pose(body);
        for (int node = 0; node < body.tree->size(); ++node) {
            const auto off = (wide(world.sphere(node).centre) - wide_centre(body, node)).norm();
            worst = std::max(worst, static_cast<double>(off) / world.rounding());
        }
    }
    // The bound also pays for the distance test; 43 of its 48 units are the centre's.
    CHECK(worst <= 43.0 / 48);
    CHECK(worst > 0.005);  // and it is a bound, not a licence
}

TEMPLATE_TEST_CASE_SIG("two turned balls that just touch are never called apart", "[posed_tree]",
                       ((int Dim), Dim), 2, 3) {
    Random random(22);
    for (int trial = 0; trial < 2000; ++trial) {
        Body<Dim> a = placed<Dim>(random, 50);
        Body<Dim> b = placed<Dim>(random, 50);
        // Put B's root at the touching distance of A's, to the last bit that doubles hold.
        const Eigen::Matrix<Wide, Dim, 1> between = wide_centre(b, 0) - wide_centre(a, 0);
        const Wide reach = static_cast<Wide>(a.tree->radius[0]) + b.tree->radius[0];
        const Wide too_far = between.norm() - reach;
        const Eigen::Matrix<Wide, Dim, 1> move = between.normalized() * too_far;
        b.position -= from_eigen(move.template cast<double>());
        if ((wide_centre(b, 0) - wide_centre(a, 0)).norm() > reach) continue;
        PosedTree<Dim> world_a;
        PosedTree<Dim> world_b;
        world_a.pose(a);
        world_b.pose(b);
        Sphere<Dim> ball = world_a.sphere(0);
        ball.radius += world_a.rounding() + world_b.rounding();
        CHECK(overlap(ball, world_b.sphere(0)));
    }
}

TEMPLATE_TEST_CASE_SIG("a posed tree may take over a larger tree and a smaller one again",
                       "[posed_tree]", ((int Dim), Dim), 2, 3) {
    Body<Dim> body = planar_body<Dim>(1, 1);
    const auto small = box_tree<Dim>(1, 1, 1);
    const auto large = box_tree<Dim>(4, 4, 4);
    PosedTree<Dim> world;
    for (const auto& tree : {small, large, small, large}) {
        body.tree = tree;
        world.pose(body);
        for (int node = 0; node < tree->size(); ++node) {
            CHECK((world.sphere(node).centre - tree->sphere(node).centre).norm() <=
                  world.rounding());
            CHECK(world.sphere(node).radius == tree->sphere(node).radius);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a node's mean normal turns with the body and keeps its length",
                       "[posed_tree]", ((int Dim), Dim), 2, 3) {
    Random random(23);
    for (int trial = 0; trial < 50; ++trial) {
        const Body<Dim> body = placed<Dim>(random, 50);
        PosedTree<Dim> world;
        world.pose(body);
        for (int node = 0; node < body.tree->size(); ++node) {
            const Vector<Dim> n = body.tree->mean_normal(node);
            const Eigen::Matrix<Wide, Dim, 1> expected = wide_rotation(body.orientation) * wide(n);
            CHECK((wide(world.mean_normal(node)) - expected).norm() < 1e-14L);
            CHECK(world.mean_normal(node).norm() == Approx(n.norm()).epsilon(1e-13));
        }
    }
}

TEMPLATE_TEST_CASE_SIG("bodies that are posed together stand as each alone", "[posed]",
                       ((int Dim), Dim), 2, 3) {
    Random random(42);
    std::vector<Body<Dim>> bodies;
    for (int i = 0; i < 70; ++i) bodies.push_back(placed<Dim>(random, 10));
    std::vector<PosedTree<Dim>> together(bodies.size());
    PosedTree<Dim>::pose_all(bodies, together);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        PosedTree<Dim> alone;
        alone.pose(bodies[i]);
        REQUIRE(together[i].rotation() == alone.rotation());
        REQUIRE(together[i].position() == alone.position());
        REQUIRE(together[i].root().centre == alone.root().centre);
        REQUIRE(together[i].rounding() == alone.rounding());
    }
}
