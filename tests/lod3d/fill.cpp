#include "lodlab/lod3d/solid/fill.hpp"

#include <numbers>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "tests/catch.hpp"

using namespace lod3d;

TEST_CASE("an enclosed ball is closed, manifold and nearly of the ball's volume", "[fill]") {
    const Mesh ball = enclose({Point::Constant(-1), Point::Constant(1)}, 24,
                              [](const Point& p) { return p.squaredNorm() < 0.9; });
    CHECK(find_bad_edges(ball).none());
    CHECK(find_parts(ball).count == 1);
    const double radius = std::sqrt(0.9);
    CHECK(integrate(ball).volume ==
          Approx(4.0 / 3 * std::numbers::pi * radius * radius * radius).epsilon(0.01));
    for (const Point& p : ball.vertices)
        CHECK(p.norm() == Approx(radius).margin(2.0 / 24 * std::sqrt(3.0) / 256));
}

TEST_CASE("a box without its lid is filled to the brim", "[fill]") {
    Mesh open = lod::make_from_spec(generators(), "box:1,1,1");
    open.triangles.resize(open.triangles.size() - 2);  // one face of six
    const double volume = integrate(fill_by_winding(open, 40)).volume;
    // With one face missing the winding number at its middle is about 1/2: the lid bulges inwards
    // only, by less than a fifth of the edge.
    CHECK(volume < 1.001);
    CHECK(volume > 0.8);
}

TEST_CASE("overlapping parts are filled as their union", "[fill]") {
    Mesh two = lod::make_from_spec(generators(), "box:1,1,1");
    const Mesh other = two;
    for (const Point& p : other.vertices) two.vertices.push_back(p + Point(0.5, 0, 0));
    for (const Triangle& t : other.triangles)
        two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    const Mesh filled = fill_by_winding(two, 48);
    CHECK(find_bad_edges(filled).none());
    CHECK(integrate(filled).volume == Approx(1.5).epsilon(0.01));
}

TEST_CASE("a single triangle encloses nothing", "[fill]") {
    const Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    CHECK_THROWS_AS(fill_by_winding(one), lod::Error);
}
