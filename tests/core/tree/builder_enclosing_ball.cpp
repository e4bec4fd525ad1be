#include "lodlab/core/math/enclosing_ball.hpp"

#include <vector>

#include "lodlab/core/builder/seeds.hpp"
#include "lodlab/core/math/power_diagram.hpp"
#include "tests/catch.hpp"
#include "tests/random.hpp"

using namespace lod;

namespace {

template <int Dim>
std::vector<Vector<Dim>> random_points(lodtest::Random& random, int count) {
    std::vector<Vector<Dim>> points;
    for (int i = 0; i < count; ++i) {
        Vector<Dim> p;
        for (int d = 0; d < Dim; ++d) p[d] = random.in(-1, 1);
        points.push_back(p);
    }
    return points;
}

/// Badoiu and Clarkson: steps of 1/i towards the farthest point; within R/sqrt(i) of the centre.
template <int Dim>
double radius_by_slow_steps(const std::vector<Vector<Dim>>& points, int steps) {
    Vector<Dim> centre = points[0];
    double least = farthest_distance<Dim>(centre, points);
    for (int i = 1; i <= steps; ++i) {
        Vector<Dim> far = points[0];
        for (const auto& p : points)
            if ((p - centre).squaredNorm() > (far - centre).squaredNorm()) far = p;
        centre += (far - centre) / (i + 1);
        least = std::min(least, farthest_distance<Dim>(centre, points));
    }
    return least;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the enclosing ball of a cube's corners has half its diagonal",
                       "[enclosing_ball]", ((int Dim), Dim), 2, 3) {
    std::vector<Vector<Dim>> corners;
    for (int bits = 0; bits < 1 << Dim; ++bits) {
        Vector<Dim> p;
        for (int d = 0; d < Dim; ++d) p[d] = 5.0 + (bits >> d & 1);
        corners.push_back(p);
    }
    const auto ball = enclosing_ball<Dim>(corners);
    CHECK(ball.centre.isApprox(Vector<Dim>::Constant(5.5), 1e-14));
    CHECK(ball.radius == Approx(std::sqrt(double(Dim)) / 2).epsilon(1e-13));
}

TEMPLATE_TEST_CASE_SIG("the enclosing ball holds all points and no ball by slow steps is smaller",
                       "[enclosing_ball]", ((int Dim), Dim), 2, 3) {
    lodtest::Random random(20 + Dim);
    for (int round = 0; round < 60; ++round) {
        const auto points = random_points<Dim>(random, 2 + round);
        const auto ball = enclosing_ball<Dim>(points);
        CHECK(farthest_distance<Dim>(ball.centre, points) <= ball.radius);
        const double slow = radius_by_slow_steps<Dim>(points, 2000);
        CHECK(ball.radius <= slow * (1 + 1e-12));
        CHECK(ball.radius >= slow * (1 - 1.0 / 2000));
    }
}

TEMPLATE_TEST_CASE_SIG("the enclosing ball of equal, collinear and nearly equal points is right",
                       "[enclosing_ball]", ((int Dim), Dim), 2, 3) {
    const Vector<Dim> x = Vector<Dim>::Unit(0);
    CHECK(enclosing_ball<Dim>(std::vector<Vector<Dim>>{}).radius == 0);
    CHECK(enclosing_ball<Dim>(std::vector<Vector<Dim>>(5, x)).radius == 0);

    std::vector<Vector<Dim>> line;
    for (int i = 0; i <= 10; ++i) line.push_back((i * 0.1) * x);
    CHECK(enclosing_ball<Dim>(line).radius == Approx(0.5));

    std::vector<Vector<Dim>> nearly{x, x + 1e-15 * Vector<Dim>::Unit(1), -x, -x};
    CHECK(enclosing_ball<Dim>(nearly).radius == Approx(1));
}

TEMPLATE_TEST_CASE_SIG("points on one sphere give that sphere", "[enclosing_ball]",
                       ((int Dim), Dim), 2, 3) {
    lodtest::Random random(7);
    auto points = random_points<Dim>(random, 500);
    for (auto& p : points) p = 3.0 * Vector<Dim>::Unit(0) + 2.0 * p.normalized();
    const auto ball = enclosing_ball<Dim>(points);
    CHECK(ball.radius == Approx(2).epsilon(1e-10));
    CHECK(ball.centre.isApprox(3.0 * Vector<Dim>::Unit(0), 1e-9));
}

TEMPLATE_TEST_CASE_SIG("a point lies in the power cell of the ball with the least power",
                       "[power_diagram]", ((int Dim), Dim), 2, 3) {
    lodtest::Random random(3);
    const auto centres = random_points<Dim>(random, 6);
    std::vector<Sphere<Dim>> balls;
    for (const auto& c : centres) balls.push_back({c, random.in(0, 0.8)});
    balls.push_back(balls[2]);  // equal to an earlier one: it owns nothing
    for (const auto& x : random_points<Dim>(random, 500)) {
        std::size_t least = 0;
        const auto power = [&](std::size_t i) {
            return (x - balls[i].centre).squaredNorm() - balls[i].radius * balls[i].radius;
        };
        for (std::size_t i = 0; i < balls.size(); ++i)
            if (power(i) < power(least)) least = i;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            bool within = true;
            for (const auto& side : power_cell<Dim>(std::span<const Sphere<Dim>>(balls), i))
                within = within && side.side(x) <= 0;
            CHECK(within == (i == least));
        }
    }
}

TEMPLATE_TEST_CASE_SIG("seeds spread over the points and never repeat", "[seeds]", ((int Dim), Dim),
                       2, 3) {
    std::vector<Vector<Dim>> line;
    for (int i = 0; i <= 8; ++i) line.push_back(double(i) * Vector<Dim>::Unit(1));
    const auto apart = far_apart<Dim>(line, 3);
    REQUIRE(apart.size() == 3);
    CHECK((apart[0].centre - apart[1].centre).norm() == Approx(8));
    CHECK(apart[2].centre.isApprox(4 * Vector<Dim>::Unit(1)));
    CHECK(far_apart<Dim>(std::vector<Vector<Dim>>(4, line[1]), 3).size() == 1);

    const auto slices = along_longest_axis<Dim>(line, 4);
    REQUIRE(slices.size() == 4);
    for (std::size_t i = 1; i < slices.size(); ++i)
        CHECK((slices[i].centre - slices[i - 1].centre).norm() == Approx(2));
}
