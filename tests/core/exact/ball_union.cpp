#include "lodlab/core/exact/ball_union.hpp"

#include <algorithm>
#include <limits>

#include "tests/catch.hpp"
#include "tests/core/exact/exact_bodies.hpp"
#include "tests/property.hpp"

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
using Balls = std::vector<Sphere<Dim>>;

template <int Dim>
Balls<Dim> some_balls(Random& random) {
    Balls<Dim> balls;
    for (int i = random.below(30); i >= 0; --i)
        balls.push_back({random_vector<Dim>(random, 2), random.in(0, 0.3)});
    return balls;
}

template <int Dim>
Body<Dim> body_of(const Balls<Dim>& balls, const Vector<Dim>& position) {
    Body<Dim> body;
    body.position = position;
    body.exact = std::make_shared<BallUnion<Dim>>(balls);
    return body;
}

/// A row of balls along the first axis, 1 m apart, whose neighbours touch.
template <int Dim>
BallUnion<Dim> row(int count) {
    Balls<Dim> balls;
    for (int i = 0; i < count; ++i) balls.push_back({i * Vector<Dim>::Unit(0), 0.5});
    return BallUnion<Dim>(balls);
}

/// Counts the pairs within reach, and what is asked to find them.
template <int Dim>
class Counting final : public PartVisitor<Dim> {
  public:
    bool skips(const ConvexPart<Dim>&, const ConvexPart<Dim>&, const Vector<Dim>&,
               double gap) const override {
        ++asked;
        return gap > 0.02;
    }
    void visit(const PartPair<Dim>&) override { ++visited; }

    mutable int asked = 0;
    int visited = 0;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("unions of balls are as far apart as their nearest two balls", "[exact]",
                       ((int Dim), Dim), 2, 3) {
    check_property(81, 100, [](std::uint64_t seed) {
        Random random(seed);
        const Balls<Dim> a = some_balls<Dim>(random);
        const Balls<Dim> b = some_balls<Dim>(random);
        const Vector<Dim> offset = random_vector<Dim>(random, 6);
        double nearest = std::numeric_limits<double>::infinity();
        for (const Sphere<Dim>& p : a)
            for (const Sphere<Dim>& q : b) {
                const double centres = (offset + q.centre - p.centre).norm();
                nearest = std::min(nearest, std::max(0.0, centres - p.radius - q.radius));
            }
        const auto body_a = body_of<Dim>(a, Vector<Dim>::Zero());
        const auto body_b = body_of<Dim>(b, offset);
        RC_ASSERT(std::abs(separation(body_a, body_b).distance - nearest) < 1e-12);
        for (int k = 0; k < 20; ++k) {
            const Vector<Dim> p = random_vector<Dim>(random, 2);
            const bool held = std::any_of(a.begin(), a.end(), [&](const Sphere<Dim>& ball) {
                return (p - ball.centre).norm() <= ball.radius;
            });
            RC_ASSERT(body_a.exact->holds(p) == held);
        }
    });
}

TEMPLATE_TEST_CASE_SIG("the pairs of balls that nearly touch are found in n steps, not n squared",
                       "[exact]", ((int Dim), Dim), 2, 3) {
    for (const int count : {256, 512, 1024}) {
        const BallUnion<Dim> a = row<Dim>(count);
        const Placement<Dim> across{Matrix<Dim>::Identity(), 1.01 * Vector<Dim>::Unit(1)};
        Counting<Dim> counting;
        a.visit_pairs(row<Dim>(count), across, counting);
        CHECK(counting.visited == count);  // each the one across
        CHECK(counting.asked <= 18 * count);
    }
}

TEMPLATE_TEST_CASE_SIG("the balls about a point are found without asking the others", "[exact]",
                       ((int Dim), Dim), 2, 3) {
    for (const int count : {256, 512, 1024}) {
        const BallUnion<Dim> balls = row<Dim>(count);
        const std::vector<Box<Dim>> boxes = boxes_of<Dim>(balls.balls());
        const BoxTree<Dim> tree(boxes);
        int asked = 0;
        for (const Vector<Dim>& p : balls.witnesses()) {
            CHECK(balls.holds(p));
            (void)tree.any_meeting({p, p}, [&](std::size_t) { return ++asked < 0; });
        }
        CHECK(asked == count);
    }
}
