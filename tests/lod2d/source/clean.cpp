#include "lodlab/lod2d/source/paths/clean.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/shape/distance.hpp"
#include "lodlab/lod2d/shape/orientation.hpp"
#include "tests/lod2d/random_shape.hpp"
#include "tests/property.hpp"

using namespace lod2d;

namespace {

constexpr double grid = 1e-8;  // a few steps of the grid for shapes of about 1 m

Ring square(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

Ring reversed(const Ring& ring) {
    return {ring.rbegin(), ring.rend()};
}

Ring pentagram() {
    Ring ring;
    for (int i = 0; i < 5; ++i) {
        const double angle = 2 * std::numbers::pi * 2 * i / 5;
        ring.emplace_back(std::cos(angle), std::sin(angle));
    }
    return ring;
}

double cleaned_area(const Outline& outline) {
    return polygon_area(clean("test", outline));
}

lod::ErrorKind refusal(const std::vector<Outline>& outlines, const CleanSettings& settings,
                       std::string_view must_name) {
    try {
        (void)clean("thing.svg", outlines, settings);
    } catch (const lod::Error& error) {
        const std::string_view line = error.what();
        INFO(line);
        CHECK(line.find("thing.svg") != std::string_view::npos);
        CHECK(line.find(must_name) != std::string_view::npos);
        CHECK(line.find('\n') == std::string_view::npos);
        return error.kind();
    }
    FAIL("accepted");
    return lod::ErrorKind::usage;
}

lod::ErrorKind refusal(const Ring& ring, std::string_view must_name) {
    return refusal({{{ring}, FillRule::nonzero}}, {}, must_name);
}

/// No two edges meet but at the ends that they share, and no three points stand in line.
bool is_clean(const Polygon& polygon) {
    struct Edge {
        Point a, b;
    };
    std::vector<Edge> edges;
    for (const Ring& ring : polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point& next = ring[(i + 1) % ring.size()];
            edges.push_back({ring[i], next});
            if (orientation(ring[i], next, ring[(i + 2) % ring.size()]) == 0) return false;
        }
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const Edge &e = edges[i], &f = edges[j];
            if (!segments_meet(e.a, e.b, f.a, f.b)) continue;
            // They may touch in a point that ends at least one of them, and no further.
            const int ends = on_segment(e.a, e.b, f.a) + on_segment(e.a, e.b, f.b) +
                             on_segment(f.a, f.b, e.a) + on_segment(f.a, f.b, e.b);
            const bool share = e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b;
            if (ends == 0 || ends > (share ? 2 : 1)) return false;
        }
    return true;
}

int winding(const Outline& outline, const Point& p) {
    double angle = 0;
    for (const Ring& ring : outline.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i] - p;
            const Point b = ring[(i + 1) % ring.size()] - p;
            angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        }
    return static_cast<int>(std::lround(angle / (2 * std::numbers::pi)));
}

}  // namespace

TEST_CASE("a pentagram is filled whole or without its middle, by the rule", "[clean]") {
    // R = 1: the inner pentagon has r = 1 / phi^2; star = 10 triangles, middle = 5.
    const double phi = std::numbers::phi;
    const double inner = 1 / (phi * phi);
    const double star = 5 * inner * std::sin(std::numbers::pi / 5);
    const double middle = 2.5 * inner * inner * std::sin(2 * std::numbers::pi / 5);
    CHECK(cleaned_area({{pentagram()}, FillRule::nonzero}) == Approx(star).margin(grid));
    CHECK(cleaned_area({{pentagram()}, FillRule::evenodd}) == Approx(star - middle).margin(grid));
    CHECK(clean("star", {{pentagram()}, FillRule::nonzero}).rings.size() == 1);
    CHECK(clean("star", {{pentagram()}, FillRule::nonzero}).rings[0].size() == 10);
    CHECK(clean("star", {{pentagram()}, FillRule::evenodd}).rings.size() == 5);
}

TEST_CASE("a ring within a ring is a hole by its direction or by the rule", "[clean]") {
    const Ring outer = square(0, 0, 3);
    const Ring inner = square(1, 1, 1);
    CHECK(cleaned_area({{outer, inner}, FillRule::nonzero}) == 9);
    CHECK(cleaned_area({{outer, reversed(inner)}, FillRule::nonzero}) == 8);
    CHECK(cleaned_area({{outer, inner}, FillRule::evenodd}) == 8);
    CHECK(cleaned_area({{reversed(outer), inner}, FillRule::evenodd}) == 8);
    const Polygon frame = clean("frame", {{outer, inner}, FillRule::evenodd});
    REQUIRE(frame.rings.size() == 2);
    CHECK(polygon_area({{frame.rings[0]}}) * polygon_area({{frame.rings[1]}}) == -9);
}

TEST_CASE("any direction of an outline encloses the same region", "[clean]") {
    CHECK(cleaned_area({{square(0, 0, 1)}, FillRule::nonzero}) == 1);
    CHECK(cleaned_area({{reversed(square(0, 0, 1))}, FillRule::nonzero}) == 1);
    // A bow tie winds once around one half and once backwards around the other.
    CHECK(cleaned_area({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}, FillRule::nonzero}) == 2);
}

TEST_CASE("outlines are united, each by its own rule", "[clean]") {
    const std::vector<Outline> outlines = {
        {{square(0, 0, 2)}, FillRule::nonzero},
        {{square(1, 1, 2), square(1.5, 1.5, 1)}, FillRule::evenodd},
        {{square(10, 0, 1)}, FillRule::evenodd}};
    const Polygon polygon = clean("three", outlines);
    CHECK(polygon_area(polygon) == 4 + 3 - 1 + 0.25 + 1);
    CHECK(is_clean(polygon));
}

TEST_CASE("double, collinear and zero-length points leave no trace", "[clean]") {
    const Ring messy = {{0, 0}, {0, 0},     {0.25, 0}, {1, 0}, {1, 0}, {1, 0.5},
                        {1, 1}, {0.5, 1.0}, {0, 1},    {0, 1}, {0, 0}};
    const Polygon polygon = clean("messy", {{messy}, FillRule::nonzero});
    REQUIRE(polygon.rings.size() == 1);
    CHECK(polygon.rings[0].size() == 4);
    CHECK(polygon_area(polygon) == 1);
    // A whisker that goes out and comes back encloses nothing.
    const Ring whisker = {{0, 0}, {1, 0}, {1, 0.5}, {2, 0.5}, {1, 0.5}, {1, 1}, {0, 1}};
    CHECK(clean("whisker", {{whisker}, FillRule::nonzero}).rings[0].size() == 4);
}

TEST_CASE("specks far smaller than the whole are dropped", "[clean]") {
    const Outline outline{{square(0, 0, 1), square(2, 0, 1e-7)}, FillRule::nonzero};
    CHECK(clean("speck", outline).rings.size() == 1);
    CleanSettings all;
    all.smallest_part = 0;
    CHECK(clean("speck", outline, all).rings.size() == 2);
}

TEST_CASE("an outline that bounds nothing is refused with its reason", "[clean]") {
    using enum lod::ErrorKind;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    CHECK(refusal(std::vector<Outline>{}, {}, "empty") == input_refused);
    CHECK(refusal(Ring{}, "empty") == input_refused);
    CHECK(refusal({{1, 1}}, "1 points") == input_refused);
    CHECK(refusal({{1, 1}, {2, 2}}, "2 points") == input_refused);
    CHECK(refusal({{1, 1}, {1, 1}, {1, 1}}, "one place") == input_refused);
    CHECK(refusal({{0, 0}, {1, 1}, {2, 2}}, "area is zero") == input_refused);
    CHECK(refusal({{0, 0}, {1, 1}, {nan, 2}}, "point 3") == input_refused);
    CHECK(refusal({{0, 0}, {1, inf}, {1, 2}}, "point 2") == input_refused);
    CHECK(refusal({{0, 0}, {1e300, 0}, {1e300, 1e300}}, "point 2") == input_refused);
    CHECK(refusal({{0, 0}, {1e-300, 0}, {1e-300, 1e-300}}, "one place") == input_refused);
}

TEST_CASE("more work than the limits is refused with the limit", "[clean]") {
    using enum lod::ErrorKind;
    CleanSettings few;
    few.most_points = 3;
    CHECK(refusal({{{square(0, 0, 1)}, FillRule::nonzero}}, few, "limit is 3") == limit_exceeded);

    // Long chords of a circle, every one across almost every other.
    Ring scribble;
    for (int i = 0; i < 20001; ++i) {
        const double angle = std::numbers::pi * i * 20000.0 / 20001;
        scribble.emplace_back(std::cos(angle), std::sin(angle));
    }
    CHECK(refusal(scribble, "too intricate") == limit_exceeded);
    CHECK(refusal(Ring(1'000'001, Point(0, 0)), "limit is 1000000") == limit_exceeded);
}

TEST_CASE("a million points along a circle are one clean ring", "[clean]") {
    Ring ring;
    for (int i = 0; i < 1'000'000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 1'000'000;
        ring.emplace_back(std::cos(angle), std::sin(angle));
    }
    const Polygon polygon = clean("circle", {{ring}, FillRule::nonzero});
    CHECK(polygon.rings.size() == 1);
    CHECK(polygon_area(polygon) == Approx(std::numbers::pi).margin(grid));
}

TEST_CASE("a cleaned scribble is clean and holds what the winding number says", "[clean]") {
    check_property(2028, 1000, [] {
        Outline outline;
        outline.rule = *rc::gen::inRange(0, 2) == 0 ? FillRule::nonzero : FillRule::evenodd;
        const int rings = *rc::gen::inRange(1, 4);
        const bool coarse = *rc::gen::inRange(0, 2) == 0;  // many coincidences
        for (int r = 0; r < rings; ++r) {
            Ring ring;
            const int points = *rc::gen::inRange(3, 16);
            for (int i = 0; i < points; ++i) {
                Point p(number_between(-1, 1), number_between(-1, 1));
                if (coarse) p = (4 * p).cwiseRound() / 4;
                ring.push_back(p);
            }
            outline.rings.push_back(ring);
        }
        Polygon polygon;
        try {
            polygon = clean("scribble", outline);
        } catch (const lod::Error&) {
            RC_DISCARD("encloses nothing");
        }
        RC_ASSERT(is_clean(polygon));
        const BoundaryIndex cleaned(polygon);
        const BoundaryIndex raw(Polygon{outline.rings});
        for (int k = 0; k < 20; ++k) {
            const Point p(number_between(-1.1, 1.1), number_between(-1.1, 1.1));
            if (raw.nearest(p).distance < grid) continue;
            const int turns = winding(outline, p);
            const bool filled = outline.rule == FillRule::nonzero ? turns != 0 : turns % 2 != 0;
            RC_ASSERT(cleaned.inside(p) == filled);
        }
    });
}
