#include "lodlab/lod3d/mesh/distance.hpp"

#include "lodlab/core/math/eigen.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/random_pose.hpp"

using namespace lod3d;

namespace {

/// Distance from a solid box about the origin, negative inside, worked by cases.
double from_box(const Point& half, const Point& p) {
    const Point q = p.cwiseAbs() - half;
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

Point random_point(lod::Random& random, double size) {
    return {random.next(-size, size), random.next(-size, size), random.next(-size, size)};
}

}  // namespace

TEST_CASE("the signed distance from a box is the box's own", "[distance]") {
    lod::Random random(1);
    const Solid box = generate("box:2,1,0.6");
    const MeshDistance distance(box.mesh);
    for (int i = 0; i < 5000; ++i) {
        const Point p = random_point(random, 1.5);
        const double expected = from_box({1, 0.5, 0.3}, p);
        CHECK(distance.signed_distance(p) == Approx(expected).margin(1e-13));
    }
}

TEST_CASE("points straight off edges and corners of a box are outside", "[distance]") {
    const Solid box = generate("box:2,2,2");
    const MeshDistance distance(box.mesh);
    for (double x : {-1.0, -0.25, 0.0, 1.0})
        for (double y : {-1.0, 0.0, 1.0})
            for (double z : {-1.0, 0.0, 1.0}) {
                const Point p(x, y, z);
                if (p.cwiseAbs().maxCoeff() < 1) continue;
                CHECK_FALSE(distance.inside(1.5 * p));
                CHECK(distance.inside(0.99 * p));
            }
}

TEST_CASE("the nearest point is found as well as by asking every triangle", "[distance]") {
    lod::Random random(2);
    const Solid knot = generate("knot");
    const MeshDistance distance(knot.mesh);
    // Each triangle alone is a mesh of one, whose nearest point needs no tree.
    std::vector<MeshDistance> alone;
    for (const Triangle& t : knot.mesh.triangles)
        alone.emplace_back(Mesh{knot.mesh.vertices, {t}}, InsideRule::winding);
    for (int i = 0; i < 100; ++i) {
        const Point p = random_point(random, 0.7);
        double least = 1e9;
        for (const MeshDistance& one : alone) least = std::min(least, one.nearest(p).distance);
        const Nearest found = distance.nearest(p);
        CHECK(found.distance == Approx(least).epsilon(1e-12));
        CHECK((found.point - p).norm() == Approx(least).epsilon(1e-12));
        CHECK(distance.nearest(p, 0.99 * least).triangle == -1);
        CHECK(distance.nearest(p, 1.01 * least).triangle == found.triangle);
    }
}

TEST_CASE("the side of the nearest normal and the winding number agree", "[distance]") {
    lod::Random random(4);
    for (const char* spec : {"gear:9,0.25,0.4", "knot", "ring", "L", "blob:3"}) {
        const Solid solid = generate(spec);
        const MeshDistance quick(solid.mesh);
        const MeshDistance thorough(solid.mesh, InsideRule::winding);
        for (int i = 0; i < 700; ++i) {
            const Point p = random_point(random, 0.6);
            INFO(spec << " at " << lod::to_eigen(p).transpose());
            const double winding = thorough.winding_number(p);
            CHECK(std::abs(winding - std::round(winding)) < 0.1);
            CHECK(quick.inside(p) == thorough.inside(p));
        }
    }
}

TEST_CASE("the torus's distance is found to the height of its facets", "[distance]") {
    lod::Random random(6);
    const double r = 0.12;
    const double R = 0.5 - r;
    const MeshDistance distance(generate("ring:0.12,320").mesh);
    const double sagitta = r * (1 - std::cos(3.1416 / 160)) + 0.5 * (1 - std::cos(3.1416 / 320));
    for (int i = 0; i < 700; ++i) {
        const Point p = random_point(random, 0.7);
        const double expected = std::hypot(std::hypot(p.x(), p.y()) - R, p.z()) - r;
        const double found = distance.signed_distance(p);
        CHECK(std::abs(found - expected) <= sagitta);
    }
}
