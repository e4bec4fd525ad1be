#include "lodlab/lod2d/shape/shape.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "tests/catch.hpp"

using namespace lod2d;
using std::numbers::pi;

namespace {
constexpr double rounding = 1e-14;

void check_integrals(const Shape& shape, double area, double second_moment) {
    CHECK(shape.area == Approx(area).epsilon(rounding));
    CHECK(shape.second_moment == Approx(second_moment).epsilon(10 * rounding));
}
}  // namespace

TEST_CASE("a box has the area and moment of the textbook", "[shape]") {
    check_integrals(generate("box"), 1, 1.0 / 6);
    check_integrals(generate("box:2,0.5"), 1, 2 * 0.5 * (4 + 0.25) / 12);
}

TEST_CASE("an equilateral triangle has the area and moment of the textbook", "[shape]") {
    check_integrals(generate("triangle"), std::sqrt(3.0) / 4, std::sqrt(3.0) / 48);
}

TEST_CASE("the integrals of a ring are those of its circle less those of its hole", "[shape]") {
    // A regular n-gon of circumradius R: area n/2 R^2 sin t, polar moment area R^2 (2 + cos t) / 6.
    const auto area = [](double r) { return 48 * r * r * std::sin(pi / 48); };
    const auto moment = [&](double r) { return area(r) * r * r * (2 + std::cos(pi / 48)) / 6; };
    const Shape ring = generate("ring:0.6");
    check_integrals(ring, area(0.5) - area(0.3), moment(0.5) - moment(0.3));
    // and within 0.2 % of the round ring
    CHECK(ring.area == Approx(pi * (0.25 - 0.09)).epsilon(2e-3));
}

TEST_CASE("an L is two rectangles by the parallel axis theorem", "[shape]") {
    // Lower arm 1 x t about (1/2, t/2), upper arm t x (1 - t) about (t/2, (1 + t)/2); t = 1/4.
    const double a1 = 0.25, a2 = 0.1875;
    const Point c1(0.5, 0.125), c2(0.125, 0.625);
    const Point c = (a1 * c1 + a2 * c2) / (a1 + a2);
    const double j1 = a1 * (1 + 0.0625) / 12 + a1 * (c1 - c).squaredNorm();
    const double j2 = a2 * (0.0625 + 0.5625) / 12 + a2 * (c2 - c).squaredNorm();

    const Shape shape = generate("L:0.25");
    check_integrals(shape, a1 + a2, j1 + j2);
    CHECK(shape.centroid.isApprox(c, rounding));
}

TEST_CASE("a star is ten triangles about its centre", "[shape]") {
    const double outer = 0.5, inner = 0.225, angle = pi / 5;
    const double area = outer * inner * std::sin(angle) / 2;
    const double moment =
        area / 6 * (outer * outer + outer * inner * std::cos(angle) + inner * inner);
    check_integrals(generate("star:5,0.45"), 10 * area, 10 * moment);
}

TEST_CASE("a shape is centred on its centre of mass", "[shape]") {
    for (const Generator& generator : generators()) {
        const Shape shape = generate(generator.name);
        INFO(generator.name);
        const Shape again = make_shape("again", shape.polygon);
        CHECK(again.centroid.norm() < 1e-15);
        CHECK(again.area == Approx(shape.area).epsilon(rounding));
    }
}

TEST_CASE("a small shape far from the origin keeps its integrals", "[shape]") {
    Polygon far = generate("box").polygon;
    for (Point& p : far.rings[0]) p += Point(1048576, -2097152);  // exact in binary
    const Shape shape = make_shape("far", far);
    check_integrals(shape, 1, 1.0 / 6);
    CHECK(shape.centroid == Point(1048576, -2097152));
}

TEST_CASE("a shape that bounds nothing is refused", "[shape]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [](const Polygon& polygon) {
        try {
            (void)make_shape("bad", polygon);
        } catch (const lod::Error& error) {
            return error.kind() == lod::ErrorKind::input_refused;
        }
        return false;
    };
    CHECK(refused({}));
    CHECK(refused({{{}}}));
    CHECK(refused({{{{1, 1}}}}));
    CHECK(refused({{{{0, 0}, {1, 0}}}}));
    CHECK(refused({{{{0, 0}, {1, 0}, {2, 0}}}}));
    CHECK(refused({{{{0, 0}, {0, 1}, {1, 0}}}}));  // clockwise: a hole in nothing
    CHECK(refused({{{{0, 0}, {1, 0}, {nan, 1}}}}));
    CHECK(refused({{{{0, 0}, {1, 0}, {0, 1 / 0.0}}}}));
    CHECK(refused({{{{0, 0}, {1e300, 0}, {0, 1e300}}}}));
    CHECK(refused({{{{0, 0}, {1e-300, 0}, {0, 1e-300}}}}));
}

TEST_CASE("an outline that runs clockwise is refused by that name") {
    const lod2d::Polygon clockwise{{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}};
    CHECK_THROWS_WITH(lod2d::make_shape("square", clockwise), lodtest::contains("clockwise"));
    const lod2d::Polygon flat{{{{0, 0}, {1, 0}, {2, 0}}}};
    CHECK_THROWS_WITH(lod2d::make_shape("line", flat), lodtest::contains("area is zero"));
}
