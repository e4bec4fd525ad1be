#include "lodlab/core/builder/piece.hpp"

#include "lodlab/lod2d/builder/piece.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "tests/catch.hpp"
#include "tests/lod2d/random_shape.hpp"
#include "tests/property.hpp"

using namespace lod2d;

namespace {

bool is_convex(std::span<const Point> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point a = corners[(i + 1) % corners.size()] - corners[i];
        const Point b = corners[(i + 2) % corners.size()] - corners[(i + 1) % corners.size()];
        if (a.x() * b.y() - a.y() * b.x() < -1e-15) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("the convex parts of a shape are convex and have its area", "[pieces]") {
    check_property(11, 60, [] {
        const Shape shape = random_shape();
        const ConvexParts parts = convex_parts(shape.polygon);
        double area = 0;
        for (std::size_t i = 0; i < parts.count(); ++i) {
            const auto begin = static_cast<std::size_t>(parts.begin[i]);
            const auto end = static_cast<std::size_t>(parts.begin[i + 1]);
            const auto corners = std::span(parts.corners).subspan(begin, end - begin);
            RC_ASSERT(is_convex(corners));
            RC_ASSERT(ring_area(corners) > 0);
            area += ring_area(corners);
        }
        RC_ASSERT(std::abs(area - shape.area) <= 1e-12 * shape.area);
    });
}

TEST_CASE("a convex shape is one part, and a square with a hole at its corner two or more",
          "[pieces]") {
    CHECK(convex_parts(generate("disc:24").polygon).count() == 1);
    CHECK(convex_parts(generate("box").polygon).count() == 1);
    // The hole touches the outer ring in one corner.
    const Polygon touching{{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 0}, {1, 2 - 0.5}, {1.5, 1}}}};
    const PolygonPiece piece(touching);
    CHECK(piece.measure() == Approx(polygon_area(touching)).epsilon(1e-14));
}

TEST_CASE("the pieces of a power diagram share out area, border and normals", "[pieces]") {
    check_property(12, 60, [] {
        const Shape shape = random_shape();
        const PolygonPiece whole(shape.polygon);
        std::vector<lod::Sphere<2>> discs;
        for (int i = 0; i < 5; ++i) discs.push_back({random_point(shape), number_between(0, 0.3)});
        double area = 0;
        double border = 0;
        Point normal(0, 0);
        for (const PolygonPiece& piece :
             lod::split<2>(whole, std::span<const lod::Sphere<2>>(discs))) {
            area += piece.measure();
            border += piece.surface_measure();
            normal += piece.surface_normal();
        }
        RC_ASSERT(std::abs(area - shape.area) <= 1e-12);
        RC_ASSERT(std::abs(border - whole.surface_measure()) <= 1e-12 * whole.surface_measure());
        RC_ASSERT(normal.norm() <= 1e-12 * border);  // a closed curve's normals cancel
    });
}

TEST_CASE("what lies in the line between two equal cells belongs to the first alone", "[pieces]") {
    // The line x = 0 runs along an edge of the L-shaped outline.
    const PolygonPiece whole(Polygon{{{{-1, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}, {-1, 2}}}});
    const std::vector<lod::Sphere<2>> discs{{{-1, 0}, 1}, {{1, 0}, 1}};
    const auto parts = lod::split<2>(whole, std::span<const lod::Sphere<2>>(discs));
    CHECK(parts[0].measure() == Approx(2));
    CHECK(parts[1].measure() == Approx(1));
    CHECK(parts[0].surface_measure() == Approx(5));
    CHECK(parts[1].surface_measure() == Approx(3));
}

TEST_CASE("a disc's part of a piece and the rest add up, from below and from above", "[pieces]") {
    const PolygonPiece square(Polygon{{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}});
    const auto [held, rest] = square.held_by({{0, 0}, 1});
    CHECK(held.measure() + rest == Approx(4).epsilon(1e-14));
    CHECK(held.measure() <= 3.14159265358979);
    CHECK(held.measure() >= 2.8);
    CHECK(square.held_by({{0, 0}, 1.5}).second == 0);
    CHECK(square.held_by({{9, 0}, 1}).second == Approx(4));
}
