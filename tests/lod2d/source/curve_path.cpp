#include "lodlab/lod2d/source/paths/curve_path.hpp"

#include <cmath>
#include <numbers>

#include "lodlab/lod2d/source/svg/text.hpp"
#include "tests/lod2d/random_shape.hpp"
#include "tests/property.hpp"

using namespace lod2d;
using std::numbers::pi;

namespace {

/// Signed area of the closed subpaths, flattened finely. Frame of SVG: y down, so the sign is that
/// of the picture turned over; the tests below draw so that it is positive.
double area_of(const CurvePath& path, double tolerance = 1e-9) {
    return polygon_area({path.flatten(tolerance)});
}

double area_of(std::string_view d) {
    return area_of(parse_svg_path(d), 1e-6);
}

Ring points_of(std::string_view d) {
    const CurvePath path = parse_svg_path(d);
    REQUIRE(path.subpaths().size() == 1);
    return path.flatten(1e-3)[0];
}

std::size_t failing_place(std::string_view d) {
    try {
        (void)parse_svg_path(d);
    } catch (const SvgTextError& error) {
        CHECK(!error.expected.empty());
        return error.place;
    }
    FAIL("accepted: " << d);
    return 0;
}

}  // namespace

TEST_CASE("every straight command draws the same square, absolute and relative", "[svg]") {
    const Ring square = {{1, 2}, {4, 2}, {4, 5}, {1, 5}};
    CHECK(points_of("M 1 2 L 4 2 L 4 5 L 1 5 Z") == square);
    CHECK(points_of("M1,2 4,2 4,5 1,5z") == square);
    CHECK(points_of("m1,2 3,0 0,3 -3,0z") == square);
    CHECK(points_of("M1 2H4V5H1Z") == square);
    CHECK(points_of("m1 2h3v3h-3z") == square);
    CHECK(points_of("M1 2l3 0 0 3-3 0") == square);
    CHECK(points_of(" M+1.0e0,.2e1L40e-1 2.L4 5 1 5 L1 2 Z ") == square);
    CHECK(points_of("M1 2h1 2v3h-3z") == Ring{{1, 2}, {2, 2}, {4, 2}, {4, 5}, {1, 5}});
}

TEST_CASE("numbers need no separator where a sign or a dot begins the next", "[svg]") {
    CHECK(points_of("M0 0L1.5.5-1-2") == Ring{{0, 0}, {1.5, 0.5}, {-1, -2}});
    CHECK(points_of("M0-0L.5.5.25.25") == Ring{{0, 0}, {0.5, 0.5}, {0.25, 0.25}});
}

TEST_CASE("a new subpath begins where the last one closed", "[svg]") {
    const CurvePath path = parse_svg_path("M1 1h2v2zl-1 0 0-1zm5 5h1v1z");
    REQUIRE(path.subpaths().size() == 3);
    CHECK(path.subpaths()[1].points[0] == Point(1, 1));
    CHECK(path.subpaths()[1].points[1] == Point(0, 1));
    CHECK(path.subpaths()[2].points[0] == Point(6, 6));
    CHECK(path.subpaths()[2].closed);
}

TEST_CASE("the area under curves is that of their integrals", "[svg]") {
    // Under the parabola from (0,0) by (1,2) to (2,0): 2/3 of 2 x 1.
    const double parabola = 2.0 / 3 * 2 * 1;
    CHECK(-area_of("M0 0Q1 2 2 0Z") == Approx(parabola).epsilon(1e-5));
    CHECK(-area_of("m0 0q1 2 2 0z") == Approx(parabola).epsilon(1e-5));
    // T mirrors the control: the second arch is the first one turned over.
    CHECK(-area_of("M0 0Q1 2 2 0T4 0Z") == Approx(0).margin(1e-5));
    CHECK(points_of("M0 0Q1 2 2 0T4 0").size() > 20);
    CHECK(-area_of("M0 0q1 2 2 0t2 0T6 0Z") == Approx(parabola).epsilon(1e-5));
    // Under the cubic from (0,0) by (0,1) and (1,1) to (1,0): 3/5.
    CHECK(-area_of("M0 0C0 1 1 1 1 0Z") == Approx(0.6).epsilon(1e-5));
    CHECK(-area_of("M0 0c0 1 1 1 1 0z") == Approx(0.6).epsilon(1e-5));
    CHECK(-area_of("M0 0C0 1 1 1 1 0S2-1 2 0Z") == Approx(0).margin(1e-5));
    CHECK(-area_of("M0 0c0 1 1 1 1 0s1 -1 1 0z") == Approx(0).margin(1e-5));
    // Without a curve before them S and T begin at the pen: a straight T, and 3/10 under the S.
    for (const Point& p : points_of("M0 0T2 0")) CHECK(p.y() == 0);
    CHECK(-area_of("M0 0S1 1 1 0Z") == Approx(0.3).epsilon(1e-5));
}

TEST_CASE("arcs have the area of their circle", "[svg]") {
    const double circle = pi * 9;
    CHECK(area_of("M3 0A3 3 0 0 1-3 0A3 3 0 0 1 3 0Z") == Approx(circle).epsilon(1e-5));
    CHECK(-area_of("M3 0A3 3 0 0 0-3 0A3 3 0 0 0 3 0Z") == Approx(circle).epsilon(1e-5));
    // A quarter and the three others; flags packed without separators.
    CHECK(area_of("M3 0A3 3 0 010 3L0 0Z") == Approx(circle / 4).epsilon(1e-5));
    CHECK(area_of("M0 3A3 3 0 113 0L0 0Z") == Approx(circle * 3 / 4).epsilon(1e-5));
    CHECK(area_of("M3 0a3 3 0 01-3 3L0 0Z") == Approx(circle / 4).epsilon(1e-5));
    CHECK(area_of("M3 0a3,3,0,0,1,-3,3L0 0Z") == Approx(circle / 4).epsilon(1e-5));
    // Radii too small grow until they reach: half a circle of radius 3.
    CHECK(area_of("M3 0A1 1 0 0 1-3 0Z") == Approx(circle / 2).epsilon(1e-5));
    // A radius of zero draws a line, an arc to where it starts nothing.
    CHECK(points_of("M0 0A0 5 0 0 1 2 2") == Ring{{0, 0}, {2, 2}});
    CHECK(points_of("M0 0L1 0A1 1 0 1 1 1 0L1 1") == Ring{{0, 0}, {1, 0}, {1, 1}});
}

TEST_CASE("a tilted ellipse keeps its area and passes its ends", "[svg]") {
    // Half-axes 2 and 1 at 30 degrees: the long axis ends at 2 (cos 30, sin 30).
    const std::string d =
        "M1.7320508075688772 1A2 1 30 0 1-1.7320508075688772-1"
        "A2 1 30 0 1 1.7320508075688772 1Z";
    CHECK(area_of(d) == Approx(2 * pi).epsilon(1e-5));
    const Ring ring = parse_svg_path(d).flatten(1e-6)[0];
    for (const Point& p : ring) {
        const Point q(p.x() * std::sqrt(0.75) + p.y() / 2, p.y() * std::sqrt(0.75) - p.x() / 2);
        CHECK(q.x() * q.x() / 4 + q.y() * q.y() == Approx(1).epsilon(1e-5));
    }
}

TEST_CASE("an arc between any two points of a circle stays on the circle", "[svg]") {
    check_property(2030, 500, [] {
        const double radius = number_between(0.1, 5);
        const Point centre(number_between(-3, 3), number_between(-3, 3));
        const double from = number_between(-pi, pi);
        const double by = number_between(0.01, 2 * pi - 0.01);
        const bool sweep = *rc::gen::inRange(0, 2) == 1;
        const auto at = [&](double angle) {
            return Point(centre + radius * Point(std::cos(angle), std::sin(angle)));
        };
        CurvePath path;
        path.move_to(at(from));
        path.arc_to({radius, radius, 0, by > pi, sweep}, at(from + (sweep ? by : -by)));
        double length = 0;
        const Ring ring = path.flatten(1e-6 * radius)[0];
        for (std::size_t i = 0; i < ring.size(); ++i) {
            RC_ASSERT(std::abs((ring[i] - centre).norm() - radius) < 1e-6 * radius);
            if (i > 0) length += (ring[i] - ring[i - 1]).norm();
        }
        RC_ASSERT(std::abs(length - radius * by) < 1e-4 * radius);
    });
}

TEST_CASE("flattened curves stay within the tolerance", "[svg]") {
    check_property(2031, 200, [] {
        const auto corner = [] { return Point(number_between(-1, 1), number_between(-1, 1)); };
        const Point a = corner(), b = corner(), c = corner(), d = corner();
        const double tolerance = number_between(1e-4, 1e-2);
        CurvePath path;
        path.move_to(a);
        path.cubic_to(b, c, d);
        const Ring lines = path.flatten(tolerance)[0];
        for (int i = 0; i <= 100; ++i) {
            const double t = i / 100.0, s = 1 - t;
            const Point on = s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
            double nearest = (lines[0] - on).norm();
            for (std::size_t k = 0; k + 1 < lines.size(); ++k)
                nearest =
                    std::min(nearest, (nearest_on_segment(lines[k], lines[k + 1], on) - on).norm());
            RC_ASSERT(nearest <= tolerance);
        }
    });
}

TEST_CASE("a broken path says where", "[svg]") {
    CHECK(parse_svg_path("").empty());
    CHECK(parse_svg_path("  ").empty());
    CHECK(failing_place("L1 1") == 0);
    CHECK(failing_place("M1") == 2);
    CHECK(failing_place("M1 1 L") == 6);
    CHECK(failing_place("M1 1 K2 2") == 5);
    CHECK(failing_place("M1 1 L2 nan") == 8);
    CHECK(failing_place("M1 1 L2 inf") == 8);
    CHECK(failing_place("M1 1 L2 1e999") == 8);
    CHECK(failing_place("M0 0A1 1 0 2 0 1 1") == 11);
    CHECK(failing_place("M0 0A1 1 0 0 1") == 14);
    CHECK(failing_place("M0 0,,1 1") == 5);
}

TEST_CASE("transforms compose from left to right", "[svg]") {
    const auto carried = [](std::string_view text, const Point& p) {
        return Point(parse_svg_transform(text) * p);
    };
    const auto near = [](const Point& p, const Point& q) { return (p - q).norm() < 1e-14; };
    CHECK(carried("", {3, 4}) == Point(3, 4));
    CHECK(carried("translate(1 2)", {3, 4}) == Point(4, 6));
    CHECK(carried("translate(1)", {3, 4}) == Point(4, 4));
    CHECK(carried("scale(2)", {3, 4}) == Point(6, 8));
    CHECK(carried("scale(2,-1)", {3, 4}) == Point(6, -4));
    CHECK(carried("matrix(1 2 3 4 5 6)", {1, 1}) == Point(9, 12));
    CHECK(near(carried("rotate(90)", {3, 4}), {-4, 3}));
    CHECK(near(carried("rotate(90,1,1)", {3, 4}), {-2, 3}));
    CHECK(near(carried("skewX(45)", {3, 4}), {7, 4}));
    CHECK(near(carried("skewY(45)", {3, 4}), {3, 7}));
    CHECK(carried("translate(10,0),scale(2)", {1, 1}) == Point(12, 2));
    CHECK(carried(" scale( 2 ) translate( 10 , 0 ) ", {1, 1}) == Point(22, 2));
    for (std::string_view broken : {"translate", "translate(1", "turn(1)", "rotate(1 2)",
                                    "matrix(1 2 3)", "scale(x)", "translate()"})
        CHECK_THROWS_AS(parse_svg_transform(broken), SvgTextError);
}

TEST_CASE("lengths have the units of CSS", "[svg]") {
    CHECK(parse_svg_length("12", 0) == 12);
    CHECK(parse_svg_length(" 12px ", 0) == 12);
    CHECK(parse_svg_length("1in", 0) == 96);
    CHECK(parse_svg_length("25.4mm", 0) == Approx(96));
    CHECK(parse_svg_length("3pt", 0) == 4);
    CHECK(parse_svg_length("50%", 300) == 150);
    CHECK_THROWS_AS(parse_svg_length("12 furlongs", 0), SvgTextError);
    CHECK_THROWS_AS(parse_svg_length("wide", 0), SvgTextError);
}
