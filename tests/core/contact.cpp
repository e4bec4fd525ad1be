#include "core/contact.hpp"

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
