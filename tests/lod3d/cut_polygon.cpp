#include "lodlab/lod3d/source/cut_polygon.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "tests/catch.hpp"

using namespace lod3d;

namespace {

Point area_of(const std::vector<Point>& corners, const Triangle& t) {
    const auto at = [&](std::size_t k) { return corners[static_cast<std::size_t>(t[k])]; };
    return 0.5 * (at(1) - at(0)).cross(at(2) - at(0));
}

struct Cut {
    std::size_t triangles = 0;
    Point area = Point::Zero();  ///< sum of area times normal
    double areas = 0;            ///< sum of areas: more where triangles overlap
};

Cut cut(const std::vector<Point>& corners) {
    std::vector<Triangle> triangles;
    cut_polygon(corners, triangles);
    // Every side of the polygon is a side of one triangle, every other side one of two.
    std::map<std::pair<std::int32_t, std::int32_t>, int> sides;
    Cut result{triangles.size()};
    for (const Triangle& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++sides[{t[k], t[(k + 1) % 3]}];
            --sides[{t[(k + 1) % 3], t[k]}];
        }
        result.area += area_of(corners, t);
        result.areas += area_of(corners, t).norm();
    }
    const auto count = static_cast<std::int32_t>(corners.size());
    for (std::int32_t i = 0; i < count; ++i) --sides[{i, (i + 1) % count}];
    for (std::int32_t i = 0; i < count; ++i) ++sides[{(i + 1) % count, i}];
    for (const auto& [side, left] : sides) CHECK(left == 0);
    return result;
}

}  // namespace

TEST_CASE("a concave polygon is cut into triangles that do not overlap", "[cut]") {
    const std::vector<Point> letter{{0, 0, 1}, {3, 0, 1}, {3, 1, 1}, {1, 1, 1},
                                    {1, 2, 1}, {3, 2, 1}, {3, 3, 1}, {0, 3, 1}};  // a C of area 7
    const Cut cut_letter = cut(letter);
    CHECK(cut_letter.triangles == 6);
    CHECK(cut_letter.area.isApprox(Point(0, 0, 7)));
    CHECK(cut_letter.areas == Approx(7));
}

TEST_CASE("a concave quadrilateral is cut from the corner that points inwards", "[cut]") {
    for (std::size_t first = 0; first < 4; ++first) {
        const std::vector<Point> dart{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
        std::vector<Point> turned;
        for (std::size_t k = 0; k < 4; ++k) turned.push_back(dart[(first + k) % 4]);
        CHECK(cut(turned).areas == Approx(4));
    }
}

TEST_CASE("a polygon with a seam to its hole keeps the hole", "[cut]") {
    const std::vector<Point> ring{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {0, 0, 0},
                                  {2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}, {2, 2, 0}};
    const Cut cut_ring = cut(ring);
    CHECK(cut_ring.triangles == 8);
    CHECK(cut_ring.area.isApprox(Point(0, 0, 32)));
    CHECK(cut_ring.areas == Approx(32));
}

TEST_CASE("polygons stand anywhere in space, and far from the origin", "[cut]") {
    const std::vector<Point> star = [] {
        std::vector<Point> corners;
        for (int i = 0; i < 40; ++i) {
            const double angle = i * std::numbers::pi / 20;
            const double radius = i % 2 == 0 ? 2 : 1;
            const Point p(radius * std::cos(angle), radius * std::sin(angle), 0);
            corners.emplace_back(0.6 * p.x(), p.y(), 0.8 * p.x());
            corners.back() += Point(1e6, -2e6, 5e5);
        }
        return corners;
    }();
    // 40 triangles of two radii about the centre, with an angle of pi / 20 between them.
    const double area = 40 * 0.5 * 2 * 1 * std::sin(std::numbers::pi / 20);
    CHECK(cut(star).areas == Approx(area).epsilon(1e-9));
}

TEST_CASE("corners on a line, repeated places and crossings keep every side", "[cut]") {
    CHECK(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}}).areas ==
          Approx(4));
    CHECK(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}).areas == 0);
    CHECK(cut({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).triangles == 3);
    CHECK(cut({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {-1, 1, 0}}).triangles == 3);
    std::vector<Point> pentagram;
    for (int i = 0; i < 5; ++i)
        pentagram.emplace_back(std::cos(i * 0.8 * std::numbers::pi),
                               std::sin(i * 0.8 * std::numbers::pi), 0);
    CHECK(cut(pentagram).triangles == 3);
}

TEST_CASE("a long comb is cut quickly", "[cut]") {
    std::vector<Point> comb{{0, -1, 0}, {4000, -1, 0}};
    for (int i = 4000; i >= 0; --i) comb.emplace_back(i, i % 2, 0);
    // 4000 columns of height 1 below and half a square above.
    CHECK(cut(comb).areas == Approx(4000 * 1.5));
}
