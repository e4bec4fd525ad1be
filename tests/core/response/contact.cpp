#include "lodlab/core/contact/contact.hpp"

#include <cmath>
#include <optional>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
Sphere<Dim> ball_at(double x, double radius) {
    return {x * Vector<Dim>::Unit(0), radius};
}

template <int Dim>
double point_along(const Sphere<Dim>& a, const Sphere<Dim>& b, PointModel model,
                   const Vector<Dim>& fallback = Vector<Dim>::Unit(0)) {
    const auto contact = model_contact<Dim>(a, b, model, fallback);
    REQUIRE(contact);
    return contact->point[0];
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the contact point divides the centre line by the radii", "[contact]",
                       ((int Dim), Dim), 2, 3) {
    const Vector<Dim> along = Vector<Dim>::Unit(0);
    const Sphere<Dim> coarse{Vector<Dim>::Zero(), 3.0};
    const Sphere<Dim> fine{3.5 * along, 1.0};

    const auto contact = model_contact(coarse, fine);
    REQUIRE(contact);
    CHECK(contact->point.isApprox(3.5 * (3.0 / 4.0) * along));
    CHECK(contact->depth == Approx(0.5));
}

TEMPLATE_TEST_CASE_SIG("the contact normal runs from A to B and turns round with them", "[contact]",
                       ((int Dim), Dim), 2, 3) {
    const Sphere<Dim> a{planar<Dim>(1, 2), 3.0};
    const Sphere<Dim> b{planar<Dim>(4, 6), 2.5};  // 3, 4, 5
    const auto forward = model_contact(a, b);
    const auto backward = model_contact(b, a);
    REQUIRE(forward);
    REQUIRE(backward);
    CHECK((forward->normal - planar<Dim>(0.6, 0.8)).norm() < 1e-15);
    CHECK((forward->normal + backward->normal).norm() == 0);
    CHECK((forward->point - backward->point).norm() < 1e-15);
}

TEMPLATE_TEST_CASE_SIG("equation 5 and the plane of intersection are two points", "[contact]",
                       ((int Dim), Dim), 2, 3) {
    const Sphere<Dim> a = ball_at<Dim>(0, 2);
    const Sphere<Dim> b = ball_at<Dim>(2, 1);
    CHECK(point_along(a, b, PointModel::radius_ratio) == Approx(4.0 / 3).epsilon(1e-15));
    CHECK(point_along(a, b, PointModel::plane_of_intersection) == Approx(1.75).epsilon(1e-15));
}

TEMPLATE_TEST_CASE_SIG("both contact points agree for equal radii and at tangency", "[contact]",
                       ((int Dim), Dim), 2, 3) {
    for (const auto& [r_a, r_b, d] : {std::tuple{1.5, 1.5, 2.0}, {2.0, 1.0, 3.0}}) {
        const Sphere<Dim> a = ball_at<Dim>(0, r_a);
        const Sphere<Dim> b = ball_at<Dim>(d, r_b);
        CHECK(point_along(a, b, PointModel::radius_ratio) ==
              Approx(point_along(a, b, PointModel::plane_of_intersection)).epsilon(1e-15));
    }
}

TEMPLATE_TEST_CASE_SIG("balls that are apart have no contact, touching ones have", "[contact]",
                       ((int Dim), Dim), 2, 3) {
    CHECK_FALSE(model_contact(ball_at<Dim>(0, 1), ball_at<Dim>(2.001, 1)));
    const auto touching = model_contact(ball_at<Dim>(0, 1), ball_at<Dim>(2, 1));
    REQUIRE(touching);
    CHECK(touching->depth == 0);
    CHECK(touching->point[0] == 1);
}

TEMPLATE_TEST_CASE_SIG("one centre for both balls leaves the normal to the fallback", "[contact]",
                       ((int Dim), Dim), 2, 3) {
    const Sphere<Dim> a{planar<Dim>(3, 4), 2.0};
    const Sphere<Dim> b{planar<Dim>(3, 4), 1.0};
    for (const PointModel model : {PointModel::radius_ratio, PointModel::plane_of_intersection}) {
        const auto by_bodies = model_contact<Dim>(a, b, model, planar<Dim>(0, -5));
        REQUIRE(by_bodies);
        CHECK(by_bodies->normal == planar<Dim>(0, -1));
        CHECK(by_bodies->depth == 3);

        const auto by_axis = model_contact<Dim>(a, b, model);
        REQUIRE(by_axis);
        CHECK(by_axis->normal == Vector<Dim>::Unit(0));
        CHECK((by_axis->point - a.centre).norm() <= 1.0);
    }
    const auto points = model_contact<Dim>({planar<Dim>(1, 1), 0.0}, {planar<Dim>(1, 1), 0.0});
    REQUIRE(points);  // two points in one place
    CHECK(points->point == planar<Dim>(1, 1));
}

TEMPLATE_TEST_CASE_SIG("a ball inside the other keeps the point in both, without a jump",
                       "[contact]", ((int Dim), Dim), 2, 3) {
    constexpr auto plane = PointModel::plane_of_intersection;
    // From outside to the middle and beyond: the point moves as smoothly as the ball.
    for (const auto& [r_a, r_b] : {std::pair{2.0, 0.5}, {0.5, 2.0}}) {
        double before = point_along(ball_at<Dim>(0, r_a), ball_at<Dim>(1.5, r_b), plane);
        CHECK(before == Approx(r_a > r_b ? 2.0 : -0.5));  // where they touch from inside
        for (double d = 1.499; d > 0; d -= 0.001) {
            const double x = point_along(ball_at<Dim>(0, r_a), ball_at<Dim>(d, r_b), plane);
            CHECK(std::abs(x) <= r_a * (1 + 1e-15));
            CHECK(std::abs(x - d) <= r_b * (1 + 1e-15));
            CHECK(std::abs(x - before) < 0.0011);
            before = x;
        }
    }
    const Sphere<Dim> same = ball_at<Dim>(1, 1);
    CHECK(point_along(same, same, plane) == 1);
}

TEMPLATE_TEST_CASE_SIG("huge and tiny balls have finite contacts", "[contact]", ((int Dim), Dim), 2,
                       3) {
    const auto tiny = model_contact(ball_at<Dim>(0, 1e-200), ball_at<Dim>(1e-200, 1e-200));
    REQUIRE(tiny);
    CHECK(tiny->normal == Vector<Dim>::Unit(0));
    CHECK(tiny->point.allFinite());
    for (const PointModel model : {PointModel::radius_ratio, PointModel::plane_of_intersection}) {
        const auto huge = model_contact<Dim>(ball_at<Dim>(0, 1e150), ball_at<Dim>(1, 1e-3), model);
        REQUIRE(huge);
        CHECK(huge->point.allFinite());
        CHECK(huge->normal == Vector<Dim>::Unit(0));
    }
}

namespace {

/// A ball of radius 1 whose surface faces `normal`.
template <int Dim>
SurfaceNode<Dim> facing(const Vector<Dim>& centre, const Vector<Dim>& normal) {
    return {{centre, 1.0}, normal};
}

/// A on the left, B on the right and a little higher: the centre line is (0.6, 0.8).
template <int Dim>
Vector<Dim> normal_of(const Vector<Dim>& normal_a, const Vector<Dim>& normal_b) {
    const auto contact = model_surface_contact<Dim>(facing<Dim>(planar<Dim>(0, 0), normal_a),
                                                    facing<Dim>(planar<Dim>(0.9, 1.2), normal_b));
    REQUIRE(contact);
    CHECK(contact->normal.norm() == Approx(1).epsilon(1e-15));
    return contact->normal;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a flat face decides the contact normal, whichever body has it", "[contact]",
                       ((int Dim), Dim), 2, 3) {
    const Vector<Dim> none = Vector<Dim>::Zero();
    CHECK(normal_of<Dim>(planar<Dim>(1, 0), none) == planar<Dim>(1, 0));
    CHECK(normal_of<Dim>(none, planar<Dim>(-1, 0)) == planar<Dim>(1, 0));
    CHECK(normal_of<Dim>(planar<Dim>(1, 0), planar<Dim>(-1, 0)) == planar<Dim>(1, 0));
    // A square's corner, 0.7071 coherent: 0.7071^16 = 1/256 beside a face's 1.
    const Vector<Dim> corner = planar<Dim>(0.5, 0.5);
    const Vector<Dim> expected = planar<Dim>(1 + std::sqrt(0.5) / 256, std::sqrt(0.5) / 256);
    CHECK((normal_of<Dim>(corner, planar<Dim>(-1, 0)) - expected.normalized()).norm() < 1e-15);
}

TEMPLATE_TEST_CASE_SIG("where nothing is known of the surfaces the centre line is the normal",
                       "[contact]", ((int Dim), Dim), 2, 3) {
    const Vector<Dim> none = Vector<Dim>::Zero();
    const Vector<Dim> line = planar<Dim>(0.6, 0.8);
    CHECK((normal_of<Dim>(none, none) - line).norm() < 1e-15);
    CHECK(
        normal_of<Dim>(none, none) ==
        model_contact<Dim>({planar<Dim>(0, 0), 1.0}, {planar<Dim>(0.9, 1.2), 1.0}).value().normal);
    // What rounding leaves of a closed surface's mean normal says nothing.
    CHECK(normal_of<Dim>(planar<Dim>(1e-17, 0), planar<Dim>(0, 1e-300)) ==
          normal_of<Dim>(none, none));
}

TEMPLATE_TEST_CASE_SIG("between corner and face the normal blends the surfaces and the line",
                       "[contact]", ((int Dim), Dim), 2, 3) {
    // coherence 2^(-1/16): weight 1/2, so the line has (1 - 1/2)^2 = 1/4.
    const double half = std::sqrt(std::sqrt(std::sqrt(std::sqrt(0.5))));
    const Vector<Dim> of_one = normal_of<Dim>(planar<Dim>(half, 0), Vector<Dim>::Zero());
    CHECK((of_one - planar<Dim>(0.5 + 0.15, 0.2).normalized()).norm() < 1e-14);
    const Vector<Dim> of_both = normal_of<Dim>(planar<Dim>(half, 0), planar<Dim>(0, -half));
    CHECK((of_both - planar<Dim>(0.5 + 0.15, 0.5 + 0.2).normalized()).norm() < 1e-14);
}

TEMPLATE_TEST_CASE_SIG("surfaces that face the same way leave the normal to the centre line",
                       "[contact]", ((int Dim), Dim), 2, 3) {
    const Vector<Dim> line = planar<Dim>(0.6, 0.8);
    CHECK((normal_of<Dim>(planar<Dim>(0, 1), planar<Dim>(0, 1)) - line).norm() < 1e-15);
    // Nor does rounding decide: a hair's difference is not a direction.
    const Vector<Dim> turned = planar<Dim>(1e-9, 1).normalized();
    CHECK((normal_of<Dim>(planar<Dim>(0, 1), turned) - line).norm() < 1e-15);
}

TEMPLATE_TEST_CASE_SIG("nodes with one centre still have the normal of their surfaces", "[contact]",
                       ((int Dim), Dim), 2, 3) {
    const auto at = facing<Dim>(planar<Dim>(1, 1), planar<Dim>(0, 1));
    const auto both =
        model_surface_contact<Dim>(at, facing<Dim>(planar<Dim>(1, 1), planar<Dim>(0, -1)));
    REQUIRE(both);
    CHECK(both->normal == planar<Dim>(0, 1));
    CHECK(both->depth == 2);
}

TEMPLATE_TEST_CASE_SIG(
    "by surfaces too, the normal turns round with A and B and point and depth stay", "[contact]",
    ((int Dim), Dim), 2, 3) {
    Random random(31);
    for (int trial = 0; trial < 200; ++trial) {
        const SurfaceNode<Dim> a{{random_vector<Dim>(random, 1), random.in(0.1, 2)},
                                 random.in(0.8, 1) * random_unit<Dim>(random)};
        const SurfaceNode<Dim> b{{random_vector<Dim>(random, 1), random.in(0.1, 2)},
                                 random.in(0.8, 1) * random_unit<Dim>(random)};
        const auto forward = model_surface_contact<Dim>(a, b);
        const auto backward = model_surface_contact<Dim>(b, a);
        const auto by_line = model_contact<Dim>(a.ball, b.ball);
        REQUIRE(forward.has_value() == by_line.has_value());
        if (!forward) continue;
        CHECK((forward->normal + backward->normal).norm() < 1e-14);
        CHECK(forward->point == by_line->point);
        CHECK(forward->depth == by_line->depth);
    }
}
