#include "lodlab/lod3d/builder/piece.hpp"

#include "lodlab/core/builder/piece.hpp"
#include "lodlab/core/math/enclosing_ball.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/random_pose.hpp"

using namespace lod3d;

namespace {

static_assert(lod::PieceOf<MeshPiece, 3>);

std::vector<lod::Sphere<3>> random_balls(lod::Random& random, int count) {
    std::vector<lod::Sphere<3>> balls;
    for (int i = 0; i < count; ++i)
        balls.push_back({random.next(0, 0.5) * random_direction(random), random.next(0.05, 0.4)});
    return balls;
}

}  // namespace

TEST_CASE("a cube cut by a plane has the volume and corners worked by hand", "[cell]") {
    lod::ConvexCell<3> cube(Box{Point::Zero(), Point::Constant(1)});
    CHECK(cube.measure() == Approx(1));
    lod::ConvexCell<3> half = cube;
    half.clip({Point(1, 1, 1), 1.5, true});  // the hexagon through the middle
    CHECK(half.measure() == Approx(0.5));
    lod::ConvexCell<3> corner = cube;
    corner.clip({Point(1, 1, 1), 1, true});
    CHECK(corner.measure() == Approx(1.0 / 6));
    CHECK(corner.holds(Point(0.2, 0.2, 0.2)));
    CHECK_FALSE(corner.holds(Point(0.4, 0.4, 0.4)));
    for (const Point& p : corner.corners()) CHECK(p.sum() <= 1 + 1e-15);
    corner.clip({Point(-1, 0, 0), -2, true});  // x >= 2
    CHECK(corner.empty());
    CHECK(corner.measure() == 0);
}

TEST_CASE("the cells of a power diagram share out a box", "[cell]") {
    lod::Random random(31);
    for (int round = 0; round < 50; ++round) {
        const auto balls = random_balls(random, 8);
        double sum = 0;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            lod::ConvexCell<3> cell(Box{Point::Constant(-1), Point::Constant(1)});
            for (const auto& side : lod::power_cell<3>(balls, i)) cell.clip(side);
            sum += cell.measure();
        }
        CHECK(sum == Approx(8).epsilon(1e-12));
    }
}

TEST_CASE("pieces of a power diagram share out the surface", "[piece]") {
    lod::Random random(32);
    for (const char* spec : {"knot", "box:1,1,1", "gear:9,0.25,0.4", "blob:2"}) {
        const Solid solid = generate(spec);
        const MeshDistance inside(solid.mesh);
        const MeshPiece whole(solid, inside);
        CHECK(whole.surface_normal().norm() < 1e-12);
        for (int round = 0; round < 5; ++round) {
            const auto balls = random_balls(random, 8);
            double area = 0;
            Point normal = Point::Zero();
            for (const MeshPiece& piece : lod::split<3>(whole, std::span(balls))) {
                area += piece.surface_measure();
                normal += piece.surface_normal();
            }
            INFO(spec);
            CHECK(area == Approx(whole.surface_measure()).epsilon(1e-11));
            CHECK(normal.norm() < 1e-11);
        }
    }
}

TEST_CASE("a piece inside a solid has the corners of its cell", "[piece]") {
    const Solid box = generate("box:1,1,1");
    const MeshDistance inside(box.mesh);
    const MeshPiece whole(box, inside);
    std::vector<lod::HalfSpace<3>> cube;
    for (int axis = 0; axis < 3; ++axis)
        for (double sign : {-1.0, 1.0}) cube.push_back({sign * Point::Unit(axis), 0.25, true});
    const MeshPiece core = whole.within(cube);
    CHECK(core.vertices().size() == 8);
    CHECK(core.surface_corners().empty());
    CHECK(core.measure() == Approx(0.125));
    // A ball that holds the surface alone does not hold the inner piece's corners.
    CHECK(lod::farthest_distance<3>(Point::Zero(), core.vertices()) ==
          Approx(0.25 * std::sqrt(3.0)));
}

TEST_CASE("points of the solid in a cell lie within the hull of its piece's vertices", "[piece]") {
    // Checked through balls: every ball that holds the vertices holds the points.
    lod::Random random(33);
    const Solid ring = generate("ring");
    const MeshDistance inside(ring.mesh);
    const MeshPiece whole(ring, inside);
    const auto balls = random_balls(random, 6);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const MeshPiece piece = whole.within(lod::power_cell<3>(std::span(balls), i));
        if (piece.vertices().empty()) continue;
        std::vector<Point> points;
        for (int k = 0; k < 20000; ++k) {
            const Point p(random.next(-0.5, 0.5), random.next(-0.5, 0.5), random.next(-0.15, 0.15));
            if (piece.cell().holds(p) && inside.inside(p)) points.push_back(p);
        }
        for (int k = 0; k < 50; ++k) {
            const Point centre = 2 * random.next() * random_direction(random);
            CHECK(lod::farthest_distance<3>(centre, points) <=
                  lod::farthest_distance<3>(centre, piece.vertices()) + 1e-12);
        }
    }
}

TEST_CASE("what a ball holds of a piece, it holds, and the rest is bounded", "[piece]") {
    const Solid box = generate("box:1,1,1");
    const MeshDistance inside(box.mesh);
    const MeshPiece whole(box, inside);
    const auto [all, none] = whole.held_by({Point::Zero(), 1});
    CHECK(none == 0);
    CHECK(all.vertices().size() == whole.vertices().size());
    const lod::Sphere<3> small{Point(0.5, 0, 0), 0.3};
    const auto [held, rest] = whole.held_by(small);
    CHECK(lod::farthest_distance<3>(small.centre, held.vertices()) <= small.radius + 1e-15);
    CHECK_FALSE(held.vertices().empty());
    CHECK(rest > 0.9);
    CHECK(rest <= 1);
}
