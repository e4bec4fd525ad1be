// Times of impact of any shapes against oracles that share no code with them: in the plane the
// exact predicates of lod2d/overlap at many times on the way.

#include "lodlab/core/exact/time_of_impact.hpp"

#include <cmath>

#include "lodlab/core/response/impact.hpp"
#include "lodlab/lod2d/shape/outline.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"
#include "tests/core/bodies.hpp"
#include "tests/lod2d/random_shape.hpp"
#include "tests/property.hpp"

using namespace lod;
using lod2d::number_between;

namespace {

struct Thrown {
    lod2d::BoundaryIndex outline;
    Body<2> body;
};

Thrown thrown(double side) {
    const lod2d::Shape shape = lod2d::random_shape();
    Body<2> body;
    set_mass<2>(body, shape.area, Inertia<2>::Constant(shape.second_moment));
    body.exact = std::make_shared<lod2d::ExactOutline>(shape);
    body.position = {side * number_between(0.3, 2), number_between(-0.8, 0.8)};
    body.orientation = number_between(-3, 3);
    body.velocity = {-side * number_between(-0.5, 3), number_between(-1, 1)};
    const bool turns = *rc::gen::inRange(0, 4) > 0;
    body.spin[0] = turns ? number_between(-8, 8) : 0;
    return {lod2d::BoundaryIndex(shape.polygon), body};
}

/// The pose after free flight, by its formula.
lod2d::Pose pose_after(const Body<2>& body, double seconds) {
    return {body.position + seconds * body.velocity, body.orientation + seconds * body.spin[0]};
}

double gap_after(const Thrown& a, const Thrown& b, double seconds) {
    return lod2d::distance(a.outline.carried(pose_after(a.body, seconds)),
                           b.outline.carried(pose_after(b.body, seconds)));
}

}  // namespace

TEST_CASE("thrown shapes never pass through each other and stop within the tolerance",
          "[impact][property]") {
    check_property(411, 800, [] {
        const Thrown a = thrown(-1);
        const Thrown b = thrown(1);
        const ImpactSettings settings{.horizon = 1, .tolerance = 1e-8};
        const auto touch = time_of_impact(a.body, b.body, settings);
        RC_TAG(static_cast<int>(touch.outcome));
        if (touch.outcome == ImpactOutcome::overlapping) {
            RC_ASSERT(gap_after(a, b, 0) == 0);
            return;
        }
        RC_ASSERT(touch.outcome != ImpactOutcome::cap_reached);
        constexpr int samples = 60;
        for (int k = 0; k <= samples; ++k) {
            const double gap = gap_after(a, b, touch.time * k / samples);
            RC_ASSERT(gap > 0);
        }
        if (touch.outcome == ImpactOutcome::never) {
            RC_ASSERT(touch.time == 1);
            return;
        }
        const double gap = gap_after(a, b, touch.time);
        RC_ASSERT(gap <= settings.tolerance * 1.001);
        RC_ASSERT(std::abs(gap - touch.distance) < 1e-14);
        // Not too early: where they close, they overlap a little later.
        double closing = 0;
        for (const auto& contact : touch.contacts)
            closing = std::max(closing, -closing_velocity(touch.a, touch.b, contact));
        RC_ASSERT(closing > 0);
        if (closing > 0.05)
            RC_ASSERT(gap_after(a, b, touch.time + 3 * settings.tolerance / closing) == 0);
    });
}

TEST_CASE("the smaller tolerance stops later, and both times agree", "[impact][property]") {
    check_property(412, 400, [] {
        const Thrown a = thrown(-1);
        const Thrown b = thrown(1);
        const auto coarse = time_of_impact(a.body, b.body, {.tolerance = 1e-4});
        const auto fine = time_of_impact(a.body, b.body, {.tolerance = 1e-9});
        if (fine.outcome != ImpactOutcome::touching) return;
        RC_ASSERT(coarse.outcome == ImpactOutcome::touching);
        RC_ASSERT(coarse.time <= fine.time);
    });
}
