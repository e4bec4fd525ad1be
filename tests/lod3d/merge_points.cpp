#include "lodlab/lod3d/mesh/merge_points.hpp"

#include <numeric>
#include <tuple>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "tests/catch.hpp"
#include "tests/property.hpp"
#include "tests/random.hpp"

using namespace lod3d;

namespace {

/// Word for word what the header says, by asking all pairs.
std::vector<std::int32_t> by_definition(const std::vector<Point>& points, double tolerance) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return std::tuple(points[i].x(), points[i].y(), points[i].z(), i) <
               std::tuple(points[j].x(), points[j].y(), points[j].z(), j);
    });
    std::vector<std::int32_t> into(points.size(), -1);
    for (const std::size_t i : order) {
        if (into[i] >= 0) continue;
        for (const std::size_t j : order)
            if (into[j] < 0 && (points[i] - points[j]).cwiseAbs().maxCoeff() <= tolerance)
                into[j] = static_cast<std::int32_t>(i);
    }
    return into;
}

/// A square of side 1 m across an axis, its points in rows, each moved by at most `jitter` [m].
std::vector<Point> sheet(int axis, int side, double jitter) {
    lodtest::Random random(7);
    std::vector<Point> points;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            Point p = Point::Zero();
            p[(axis + 1) % 3] = static_cast<double>(i) / side + random.in(-jitter, jitter);
            p[(axis + 2) % 3] = static_cast<double>(k) / side + random.in(-jitter, jitter);
            points.push_back(p);
        }
    return points;
}

}  // namespace

TEST_CASE("merged points are those that asking all pairs merges", "[merge_points]") {
    check_property(71, 300, [](std::uint64_t seed) {
        lodtest::Random random(seed);
        const double size = std::ldexp(1.0, random.below(200) - 100);
        // From all apart to all within reach of each other; 2^-52 is a step between doubles.
        const double tolerance = size * std::ldexp(1.0, 1 - random.below(54));
        const double away = random.below(2) * size * std::ldexp(1.0, random.below(54));
        std::vector<Point> points;
        for (int i = 0; i < 60; ++i) {
            Point p;
            for (int d = 0; d < 3; ++d) {
                // Whole and half tolerances from each other: many lie just within reach.
                const double steps = 0.5 * tolerance * random.below(8);
                p[d] = away + (random.below(2) ? steps : size * random.in(-1, 1));
                if (random.below(8) == 0) p[d] = -0.0;
            }
            points.push_back(p);
        }
        RC_ASSERT(merge_points(points, tolerance).into == by_definition(points, tolerance));
        RC_ASSERT(merge_points(points, 0).into == by_definition(points, 0));
    });
}

TEST_CASE("points that a tolerance cannot tell apart at all are merged", "[merge_points]") {
    // Cells beyond all doubles.
    const std::vector<Point> points{{1e100, 0, 0}, {1e100, 0, 0}, {-1e100, 0, 0}, {0, 0, 1e-310}};
    CHECK(merge_points(points, 1e-300).into == std::vector<std::int32_t>{0, 0, 2, 3});
}

TEST_CASE("merging takes a bounded number of steps a point, however many lie beside each other",
          "[merge_points]") {
    const auto axis = GENERATE(0, 1, 2);
    for (const int side : {64, 128, 256}) {
        const double spacing = 1.0 / side;
        const auto count = static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side);
        INFO(count << " points across axis " << axis);
        // All apart; just out of each other's reach, so that cells are full; pairs of neighbours;
        // one heap. 8 cells and what they hold.
        CHECK(merge_points(sheet(axis, side, 0.1 * spacing), 1e-9).steps <= 9 * count);
        CHECK(merge_points(sheet(axis, side, 0), 0.99 * spacing).steps <= 24 * count);
        CHECK(merge_points(sheet(axis, side, 0), 1.01 * spacing).steps <= 24 * count);
        CHECK(merge_points(sheet(axis, side, 0), 2).steps <= 9 * count);
    }
}

TEST_CASE("merging stops when it is asked to", "[merge_points]") {
    lod::stop_requested = true;
    CHECK_THROWS_AS(merge_points(sheet(0, 8, 0), 1e-9), lod::Interrupted);
    lod::stop_requested = false;
}
