#include "lodlab/lod2d/builder/medial_axis.hpp"

#include "lodlab/lod2d/builder/medial_cover.hpp"
#include "lodlab/lod2d/shape/distance.hpp"
#include "tests/catch.hpp"
#include "tests/lod2d/random_shape.hpp"
#include "tests/property.hpp"

using namespace lod2d;
using Disc = lod::Sphere<2>;

TEST_CASE("discs on the medial axis of a box touch two of its sides", "[medial]") {
    const MedialAxis axis(Polygon{{{{0, 0}, {4, 0}, {4, 2}, {0, 2}}}});
    const auto middle = axis.touching(0, 0.5);  // the lower side
    REQUIRE(middle);
    CHECK(middle->centre.isApprox(Point(2, 1)));
    CHECK(middle->radius == Approx(1));
    const auto near_corner = axis.touching(0, 0.1);  // on the corner's bisector
    REQUIRE(near_corner);
    CHECK(near_corner->centre.isApprox(Point(0.4, 0.4)));
    CHECK(near_corner->radius == Approx(0.4));
    const auto short_side = axis.touching(1, 0.5);
    REQUIRE(short_side);
    CHECK(short_side->centre.isApprox(Point(3, 1)));
}

TEST_CASE("a disc that a reflex corner stops lies on its parabola", "[medial]") {
    // An L; its reflex corner at (1, 1). From (0.8, 0) up: |p - f|^2 / (2 * 1) = (0.04 + 1) / 2.
    const MedialAxis axis(Polygon{{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}}});
    const auto disc = axis.touching(0, 0.8 / 3);
    REQUIRE(disc);
    CHECK(disc->radius == Approx(0.52));
    CHECK(disc->centre.isApprox(Point(0.8, 0.52)));
    CHECK_FALSE(axis.at_corner(3).empty());
    CHECK(axis.at_corner(0).empty());
    for (const Disc& d : axis.at_corner(3))
        CHECK((d.centre - Point(1, 1)).norm() == Approx(d.radius));
}

TEST_CASE("the largest disc that touches an edge is as large as the distance index says",
          "[medial]") {
    check_property(31, 80, [] {
        const Shape shape = random_shape();
        const BoundaryIndex index(shape.polygon);
        const MedialAxis axis(shape.polygon);
        std::int32_t edge = 0;
        int found = 0;
        int tried = 0;
        for (const Ring& ring : shape.polygon.rings)
            for (std::size_t i = 0; i < ring.size(); ++i, ++edge)
                for (const double t : {0.13, 0.5, 0.86}) {
                    ++tried;
                    const auto disc = axis.touching(edge, t);
                    if (!disc) continue;
                    ++found;
                    const Point p = ring[i] + t * (ring[(i + 1) % ring.size()] - ring[i]);
                    RC_ASSERT(std::abs((p - disc->centre).norm() - disc->radius) <= 1e-12);
                    RC_ASSERT(std::abs(index.signed_distance(disc->centre) + disc->radius) <= 1e-6);
                }
        RC_ASSERT(found == tried);
    });
}

TEST_CASE("edges that cross on the grid do not break the diagram", "[medial]") {
    // Two spikes that pass each other by far less than the grid can tell.
    const double hair = 1e-14;
    const MedialAxis axis(
        Polygon{{{{0, 0}, {2, 0}, {2, 1}, {1, hair}, {1 - hair, 2 * hair}, {0, 1}}}});
    CHECK(axis.touching(0, 0.1));
}

TEST_CASE("the cover of least growth is the best choice of discs", "[medial]") {
    // Points at 0, 1, 10, 11; candidates of radius 0.25 at 0.5, 5.5 and 10.5.
    const std::vector<FacingPoint> points{{{0, 0}}, {{1, 0}}, {{10, 0}}, {{11, 0}}};
    const std::vector<FacingDisc> discs{
        {{{5.5, 0}, 0.25}}, {{{0.5, 0}, 0.25}}, {{{10.5, 0}, 0.25}}};
    const auto two = least_growth_cover(points, discs, 2);
    REQUIRE(two.size() == 2);
    for (const Disc& disc : two) CHECK(disc.radius == Approx(0.5));
    const auto one = least_growth_cover(points, discs, 1);
    REQUIRE(one.size() == 1);
    CHECK(one[0].centre.x() == 5.5);
    CHECK(one[0].radius == Approx(5.5));
    CHECK(least_growth_cover({}, discs, 2).empty());
    CHECK(least_growth_cover(points, {}, 2).empty());
}
