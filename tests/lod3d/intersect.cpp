// Intersection of triangles and of posed meshes, against FCL.
#include "lodlab/lod3d/mesh/intersect.hpp"

#include "lodlab/lod3d/solid/generators.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/fcl_oracle.hpp"
#include "tests/lod3d/random_pose.hpp"

using namespace lod3d;

namespace {

bool fcl_says(const std::shared_ptr<lodtest::FclModel>& a, const Pose& pose_a,
              const std::shared_ptr<lodtest::FclModel>& b, const Pose& pose_b) {
    return lodtest::fcl_collide(a, lodtest::fcl_pose(pose_a.rotation, pose_a.position), b,
                                lodtest::fcl_pose(pose_b.rotation, pose_b.position));
}

TriangleTree::Corners random_triangle(lod::Random& random) {
    const auto corner = [&] { return Point(random.next(), random.next(), random.next()); };
    return {corner(), corner(), corner()};
}

}  // namespace

TEST_CASE("triangles worked by hand intersect, touch or miss", "[intersect]") {
    const TriangleTree::Corners flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto moved = [](TriangleTree::Corners t, const Point& by) {
        return TriangleTree::Corners{t.a + by, t.b + by, t.c + by};
    };
    CHECK(triangles_intersect(flat, flat));
    CHECK_FALSE(triangles_intersect(flat, moved(flat, {0, 0, 0.001})));
    CHECK(triangles_intersect(flat, moved(flat, {0.5, 0.25, 0})));       // in one plane
    CHECK_FALSE(triangles_intersect(flat, moved(flat, {0.6, 0.6, 0})));  // in one plane, apart
    CHECK(triangles_intersect(flat, moved(flat, {1, 0, 0})));            // one corner shared
    const TriangleTree::Corners within{{0.2, 0.2, 0}, {0.3, 0.2, 0}, {0.2, 0.3, 0}};
    CHECK(triangles_intersect(flat, within));
    CHECK(triangles_intersect(within, flat));
    const TriangleTree::Corners upright{{0.2, 0.2, -1}, {0.2, 0.2, 1}, {2, 2, 0}};
    CHECK(triangles_intersect(flat, upright));
    CHECK_FALSE(triangles_intersect(flat, moved(upright, {0.5, 0.5, 0})));
    const TriangleTree::Corners on_corner{{0, 0, 0}, {-1, 0, 1}, {0, -1, 1}};
    CHECK(triangles_intersect(flat, on_corner));
}

TEST_CASE("random triangles intersect exactly where FCL says so", "[intersect]") {
    lod::Random random(21);
    int meet = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto s = random_triangle(random);
        const auto t = random_triangle(random);
        const auto as_model = [](const TriangleTree::Corners& c) {
            return lodtest::fcl_model({{c.a, c.b, c.c}, {{0, 1, 2}}});
        };
        const bool expected = fcl_says(as_model(s), {}, as_model(t), {});
        INFO("pair " << i);
        CHECK(triangles_intersect(s, t) == expected);
        CHECK(triangles_intersect(t, s) == expected);
        meet += expected;
    }
    CHECK(meet > 300);
}

TEST_CASE("posed meshes intersect exactly where FCL says so", "[intersect]") {
    lod::Random random(22);
    int meet = 0;
    for (const auto& [first, second] : {std::pair("knot", "gear:9,0.25,0.4"),
                                        std::pair("ring", "ring"), std::pair("blob:2", "L")}) {
        const Solid a = generate(first);
        const Solid b = generate(second);
        const TriangleTree tree_a(a.mesh);
        const TriangleTree tree_b(b.mesh);
        const auto model_a = lodtest::fcl_model(a.mesh);
        const auto model_b = lodtest::fcl_model(b.mesh);
        for (int i = 0; i < 200; ++i) {
            const Pose pose_a{random_rotation(random), Point(random.next(), 0, 0)};
            const Pose pose_b{random_rotation(random),
                              pose_a.position + random.next(0.2, 1) * random_direction(random)};
            const bool expected = fcl_says(model_a, pose_a, model_b, pose_b);
            INFO(first << " and " << second << ", pair " << i);
            CHECK(surfaces_intersect(tree_a, pose_a, tree_b, pose_b) == expected);
            CHECK(surfaces_intersect(tree_b, pose_b, tree_a, pose_a) == expected);
            meet += expected;
        }
    }
    CHECK(meet > 100);
    CHECK(meet < 500);
}
