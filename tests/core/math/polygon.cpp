#include "lodlab/core/math/polygon.hpp"

#include <algorithm>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/property.hpp"

using namespace lod;
using namespace lodtest;

namespace {

using Points = std::vector<Vector<2>>;

Points hull_of(Points points) {
    return convex_hull(std::move(points), [](const Vector<2>& p) { return p; });
}

template <int Dim>
using Polygon = std::vector<Vector<Dim>>;

/// The unit square, in space on the ground.
template <int Dim>
Polygon<Dim> square() {
    const Vector<Dim> x = Vector<Dim>::Unit(0);
    const Vector<Dim> y = Vector<Dim>::Unit(1);
    return {Vector<Dim>::Zero(), x, x + y, y};
}

template <int Dim>
Polygon<Dim> clipped(const Polygon<Dim>& polygon, const std::vector<HalfSpace<Dim>>& cell) {
    Polygon<Dim> part{Vector<Dim>::Constant(9)};  // what is there stays
    PolygonClipper<Dim> clipper(cell);
    const std::size_t count = clipper.clip(polygon, part);
    REQUIRE(part.size() == 1 + count);
    REQUIRE(part.front() == Vector<Dim>::Constant(9));
    part.erase(part.begin());
    return part;
}

}  // namespace

TEST_CASE("a hull begins at the left and goes round anticlockwise, by true corners alone",
          "[convex_hull]") {
    CHECK(hull_of({{1, 1}, {0, 2}, {2, 0}, {1, 0}, {0, 0}, {2, 2}, {0, 1}, {0, 0}, {0.5, 1.5}}) ==
          Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
}

TEST_CASE("the hull of points on a line is its two ends, of one point that point",
          "[convex_hull]") {
    CHECK(hull_of({{1, 1}, {3, 3}, {0, 0}, {2, 2}}) == Points{{0, 0}, {3, 3}});
    CHECK(hull_of({{4, 5}, {4, 5}, {4, 5}}) == Points{{4, 5}});
    CHECK(hull_of({}).empty());
}

TEST_CASE("no point lies outside its hull, and each corner is one of the points", "[convex_hull]") {
    check_property(71, 200, [](std::uint64_t seed) {
        Random random(seed);
        Points points;
        for (int i = random.below(40); i >= 0; --i)  // on a grid: many on one line, some twice
            points.emplace_back(random.below(7), random.below(7));
        const Points hull = hull_of(points);
        for (std::size_t i = 0; i < hull.size(); ++i) {
            RC_ASSERT(std::find(points.begin(), points.end(), hull[i]) != points.end());
            const Vector<2> side = hull[(i + 1) % hull.size()] - hull[i];
            for (const Vector<2>& p : points) {
                const Vector<2> to = p - hull[i];
                RC_ASSERT(side.x() * to.y() - side.y() * to.x() >= 0);
            }
        }
    });
}

TEMPLATE_TEST_CASE_SIG("a cell cuts its part out of a square, corner by corner", "[clip]",
                       ((int Dim), Dim), 2, 3) {
    const Vector<Dim> x = Vector<Dim>::Unit(0);
    const Vector<Dim> y = Vector<Dim>::Unit(1);
    const Polygon<Dim> part =
        clipped<Dim>(square<Dim>(), {{-x, -0.25, true}, {x, 0.75, true}, {-y, 5, true}});
    CHECK(part == Polygon<Dim>{0.25 * x, 0.75 * x, 0.75 * x + y, 0.25 * x + y});
}

TEMPLATE_TEST_CASE_SIG("a polygon within its cell stays as it is, one outside is gone", "[clip]",
                       ((int Dim), Dim), 2, 3) {
    const Vector<Dim> x = Vector<Dim>::Unit(0);
    CHECK(clipped<Dim>(square<Dim>(), {{x, 1, true}, {-x, 0, false}}) == square<Dim>());
    CHECK(clipped<Dim>(square<Dim>(), {{x, -0.5, true}}).empty());
    CHECK(clipped<Dim>(square<Dim>(), {{x, 0, true}}).empty());  // a side only
    CHECK(clipped<Dim>(square<Dim>(), {}) == square<Dim>());
}

TEST_CASE("of two cells one owns a polygon that lies in their common border", "[clip]") {
    const Vector<3> up = Vector<3>::Unit(2);
    CHECK(clipped<3>(square<3>(), {{up, 0, true}}) == square<3>());
    CHECK(clipped<3>(square<3>(), {{-up, 0, false}}).empty());
}
