#include "lodlab/lod2d/shape/overlap.hpp"

#include <cmath>

#include "lodlab/lod2d/shape/orientation.hpp"
#include "tests/lod2d/random_shape.hpp"
#include "tests/property.hpp"

using namespace lod2d;

namespace {

Polygon carried(const Shape& shape, const Pose& pose) {
    const lod::Matrix<2> turn = lod::Space<2>::rotation(pose.angle);
    Polygon world = shape.polygon;
    for (Ring& ring : world.rings)
        for (Point& p : ring) p = turn * p + pose.position;
    return world;
}

double segment_distance(const Point& a, const Point& b, const Point& p) {
    const Point d = b - a;
    const double t = std::min(1.0, std::max(0.0, d.dot(p - a) / d.dot(d)));
    return (p - (a + t * d)).norm();
}

bool plainly_inside(const Polygon& polygon, const Point& p) {
    double angle = 0;
    for (const Ring& ring : polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i] - p;
            const Point b = ring[(i + 1) % ring.size()] - p;
            angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        }
    return std::abs(angle) > 3;
}

/// Every edge against every edge: the distance of the outlines, and how many pairs cross.
struct PlainAnswer {
    double distance = 1e300;
    std::size_t crossings = 0;
};

PlainAnswer plain_outlines(const Polygon& a, const Polygon& b) {
    PlainAnswer answer;
    for (const Ring& p : a.rings)
        for (std::size_t i = 0; i < p.size(); ++i)
            for (const Ring& q : b.rings)
                for (std::size_t j = 0; j < q.size(); ++j) {
                    const Point &a0 = p[i], &a1 = p[(i + 1) % p.size()];
                    const Point &b0 = q[j], &b1 = q[(j + 1) % q.size()];
                    if (segments_meet(a0, a1, b0, b1)) {
                        ++answer.crossings;
                        answer.distance = 0;
                    }
                    for (double d : {segment_distance(a0, a1, b0), segment_distance(a0, a1, b1),
                                     segment_distance(b0, b1, a0), segment_distance(b0, b1, a1)})
                        answer.distance = std::min(answer.distance, d);
                }
    return answer;
}

}  // namespace

TEST_CASE("boxes overlap until the last bit of the gap between them", "[overlap]") {
    const Shape box = generate("box");
    CHECK(overlap(box, {{0, 0}, 0}, box, {{1, 0}, 0}));
    CHECK(overlap(box, {{0, 0}, 0}, box, {{1, 1}, 0}));
    CHECK_FALSE(overlap(box, {{0, 0}, 0}, box, {{std::nextafter(1.0, 2.0), 0}, 0}));
    CHECK_FALSE(overlap(box, {{0, 0}, 0}, box, {{1, std::nextafter(1.0, 2.0)}, 0}));
    CHECK(overlap(box, {{0, 0}, 0}, box, {{0, 0}, 0}));
}

TEST_CASE("a body within another overlaps, a body within a hole does not", "[overlap]") {
    const BoundaryIndex ring(generate("ring:0.6").polygon);
    const BoundaryIndex small(generate("box:0.2,0.2").polygon);
    const BoundaryIndex tiny(generate("box:0.02,0.02").polygon);
    CHECK_FALSE(overlap(ring, small));
    CHECK_FALSE(overlap(small, ring));
    // A corner of the box lies at 45 degrees, where the 96-gon has a corner too.
    CHECK(distance(ring, tiny) > 0.28);
    CHECK(distance(ring, small) < 0.3 - 0.1 * std::sqrt(2.0) + 1e-15);
    CHECK(distance(ring, small) > 0.299 - 0.1 * std::sqrt(2.0));
    CHECK(overlap(ring, tiny.carried({{0.4, 0}, 0})));
    CHECK(overlap(tiny.carried({{0.4, 0}, 0}), ring));
}

TEST_CASE("the distance of two boxes is that of the textbook", "[overlap]") {
    const BoundaryIndex box(generate("box").polygon);
    CHECK(distance(box, box.carried({{3, 0}, 0})) == 2);
    CHECK(distance(box, box.carried({{4, 5}, 0})) == 5);
    CHECK(distance(box, box.carried({{1, 0.5}, 0})) == 0);
    const ClosestPoints way = closest_points(box, box.carried({{4, 5}, 0}));
    CHECK(way.on_a == Point(0.5, 0.5));
    CHECK(way.on_b == Point(3.5, 4.5));
}

TEST_CASE("overlap and distance agree with plain loops over all pairs of edges", "[overlap]") {
    check_property(2027, 1500, [] {
        const Shape a = random_shape();
        const Shape b = random_shape();
        const Pose pose_a = random_pose(0.7);
        const Pose pose_b = random_pose(0.7);
        const Polygon world_a = carried(a, pose_a);
        const Polygon world_b = carried(b, pose_b);
        const BoundaryIndex index_a = BoundaryIndex(a.polygon).carried(pose_a);
        const BoundaryIndex index_b = BoundaryIndex(b.polygon).carried(pose_b);

        const PlainAnswer plain = plain_outlines(world_a, world_b);
        const bool contained = plainly_inside(world_a, world_b.rings[0][0]) ||
                               plainly_inside(world_b, world_a.rings[0][0]);
        RC_ASSERT(overlap(index_a, index_b) == (plain.crossings > 0 || contained));
        RC_ASSERT(overlap(index_b, index_a) == (plain.crossings > 0 || contained));
        const double expected = contained ? 0 : plain.distance;
        RC_ASSERT(std::abs(distance(index_a, index_b) - expected) < 1e-14);
        const ClosestPoints way = closest_points(index_a, index_b);
        RC_ASSERT((way.on_b - way.on_a).norm() == way.distance);
    });
}
