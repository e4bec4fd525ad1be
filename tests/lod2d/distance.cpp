#include "lodlab/lod2d/shape/distance.hpp"

#include <cmath>

#include "lodlab/lod2d/shape/orientation.hpp"
#include "tests/lod2d/random_shape.hpp"
#include "tests/property.hpp"

using namespace lod2d;

namespace {

double plain_distance_to_boundary(const Polygon& polygon, const Point& p) {
    double best = 1e300;
    for (const Ring& ring : polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i];
            const Point d = ring[(i + 1) % ring.size()] - a;
            const double t = std::min(1.0, std::max(0.0, d.dot(p - a) / d.dot(d)));
            best = std::min(best, (p - (a + t * d)).norm());
        }
    return best;
}

/// The winding number by summed angles: nothing in common with counting crossings.
double winding(const Polygon& polygon, const Point& p) {
    double angle = 0;
    for (const Ring& ring : polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i] - p;
            const Point b = ring[(i + 1) % ring.size()] - p;
            angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        }
    return angle / (2 * 3.14159265358979323846);
}

}  // namespace

TEST_CASE("the distance to a box is that of the textbook", "[distance]") {
    const BoundaryIndex box(generate("box:2,1").polygon);
    CHECK(box.distance({0, 0}) == 0);
    CHECK(box.signed_distance({0, 0}) == -0.5);
    CHECK(box.signed_distance({0.75, 0}) == -0.25);
    CHECK(box.distance({1, 0.5}) == 0);
    CHECK(box.distance({4, 4.5}) == 5);
    CHECK(box.nearest({0.5, 2}).point == Point(0.5, 0.5));
    CHECK(box.nearest({0.5, 2}).distance == 1.5);
    CHECK(box.edge_start(box.nearest({0.5, 2}).edge).y() == 0.5);
}

TEST_CASE("the inside of a hole is outside and its rim is inside", "[distance]") {
    const BoundaryIndex frame(
        Polygon{{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}}});
    CHECK_FALSE(frame.inside({0, 0}));
    CHECK(frame.inside({1.5, 0}));
    CHECK(frame.inside({1, 0}));
    CHECK(frame.inside({1, 1}));
    CHECK(frame.inside({-2, -2}));
    CHECK(frame.inside({0, 2}));
    CHECK_FALSE(frame.inside({std::nextafter(1.0, 0.0), 0}));
    CHECK_FALSE(frame.inside({std::nextafter(2.0, 3.0), 0}));
    CHECK(frame.distance({0, 0}) == 1);
    CHECK(frame.signed_distance({0, 1.75}) == -0.25);
}

TEST_CASE("the orientation test is exact where rounding would decide", "[orientation]") {
    // 0.5 + i ulp against the diagonal from (12, 12) to (24, 24) (Kettner et al. 2008).
    const double ulp = std::ldexp(1.0, -53);
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j) {
            const Point p(0.5 + i * ulp, 0.5 + j * ulp);
            const int expected = (p.y() > p.x()) - (p.y() < p.x());
            CHECK(orientation({12, 12}, {24, 24}, p) == expected);
            CHECK(orientation(p, {12, 12}, {24, 24}) == expected);
            CHECK(orientation({24, 24}, {12, 12}, p) == -expected);
        }
}

TEST_CASE("segments meet when they cross, touch or lie on one another", "[orientation]") {
    CHECK(segments_meet({0, 0}, {2, 2}, {0, 2}, {2, 0}));
    CHECK(segments_meet({0, 0}, {2, 0}, {1, 0}, {1, 5}));
    CHECK(segments_meet({0, 0}, {2, 0}, {2, 0}, {3, 1}));
    CHECK(segments_meet({0, 0}, {2, 0}, {1, 0}, {3, 0}));
    CHECK(segments_meet({0, 0}, {3, 0}, {1, 0}, {2, 0}));
    CHECK_FALSE(segments_meet({0, 0}, {1, 0}, {2, 0}, {3, 0}));
    CHECK_FALSE(segments_meet({0, 0}, {2, 2}, {0, 1}, {0.5, 1}));
    CHECK_FALSE(segments_meet({0, 0}, {2, 0}, {1, 1e-300}, {1, 5}));
    CHECK(segments_meet({1, 1}, {1, 1}, {0, 0}, {2, 2}));
}

TEST_CASE("distance and inside agree with plain loops over all edges", "[distance]") {
    check_property(2026, 2000, [] {
        const Shape shape = random_shape();
        const Pose pose = random_pose(10);
        const BoundaryIndex index = BoundaryIndex(shape.polygon).carried(pose);
        const lod::Matrix<2> turn = lod::Space<2>::rotation(pose.angle);
        Polygon world = shape.polygon;
        for (Ring& ring : world.rings)
            for (Point& p : ring) p = turn * p + pose.position;
        const Point p = turn * random_point(shape) + pose.position;

        const double plain = plain_distance_to_boundary(world, p);
        RC_ASSERT(std::abs(index.nearest(p).distance - plain) < 1e-14);
        if (plain > 1e-12) {
            const bool inside = std::abs(winding(world, p)) > 0.5;
            RC_ASSERT(index.inside(p) == inside);
            RC_ASSERT(index.signed_distance(p) == (inside ? -1 : 1) * index.nearest(p).distance);
            RC_ASSERT(index.distance(p) == (inside ? 0 : index.nearest(p).distance));
        }
    });
}

TEST_CASE("corners and middles of edges are inside the closed region", "[distance]") {
    for (const Generator& generator : generators()) {
        const Shape shape = generate(generator.name);
        const BoundaryIndex index(shape.polygon);
        for (const Ring& ring : shape.polygon.rings)
            for (const Point& p : ring) CHECK(index.inside(p));
    }
}
