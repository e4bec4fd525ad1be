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

/// Passes on to another union what is asked of it, and counts the pairs that a question looks at.
template <int Dim>
class CountedUnion final : public ExactShape<Dim> {
  public:
    explicit CountedUnion(const Balls<Dim>& balls) : balls_(balls) {}
    double radius() const override { return balls_.radius(); }
    std::uint64_t hash() const override { return balls_.hash(); }
    std::span<const Vector<Dim>> witnesses() const override { return balls_.witnesses(); }
    bool holds(const Vector<Dim>& p) const override { return balls_.holds(p); }
    void visit_pairs(const ExactShape<Dim>& b, const Placement<Dim>& b_in_a,
                     PartVisitor<Dim>& visitor) const override {
        Looking looking(visitor);
        balls_.visit_pairs(dynamic_cast<const CountedUnion&>(b).balls_, b_in_a, looking);
        looks = looking.looks;
    }
    void keep_corners(const Vector<Dim>&, double, std::vector<Contact<Dim>>&) const override {}

    mutable int looks = 0;

  private:
    struct Looking final : PartVisitor<Dim> {
        explicit Looking(PartVisitor<Dim>& visitor) : asks(visitor) {}
        bool skips(const ConvexPart<Dim>& a, const ConvexPart<Dim>& b, const Vector<Dim>& direction,
                   double gap) const override {
            return asks.skips(a, b, direction, gap);
        }
        void visit(const PartPair<Dim>& pair) override {
            ++looks;
            asks.visit(pair);
        }
        bool is_done() const override { return asks.is_done(); }

        PartVisitor<Dim>& asks;
        int looks = 0;
    };

    BallUnion<Dim> balls_;
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

TEMPLATE_TEST_CASE_SIG("that unions overlap is known from one pair, however many do", "[exact]",
                       ((int Dim), Dim), 2, 3) {
    for (const std::size_t count : {64, 128, 256}) {
        const auto nest = std::make_shared<CountedUnion<Dim>>(
            Balls<Dim>(count, Sphere<Dim>{Vector<Dim>::Zero(), 1}));
        Body<Dim> body;
        body.exact = nest;
        CHECK(exactly_overlap(body, body));
        CHECK(nest->looks == 1);
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
