#include "lodlab/lod2d/builder/tree_report.hpp"

#include <numbers>

#include "lodlab/core/builder/protrusion.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/disc_union.hpp"
#include "tests/catch.hpp"
#include "tests/lod2d/random_shape.hpp"
#include "tests/random.hpp"

using namespace lod2d;
using Disc = lod::Sphere<2>;
constexpr double pi = std::numbers::pi;

namespace {

double area_of(const std::vector<Disc>& discs) {
    return union_area(discs, exposed_arcs(discs));
}

}  // namespace

TEST_CASE("the area of a union of discs is that of the textbook", "[report]") {
    CHECK(area_of({{{3, 4}, 2}}) == Approx(4 * pi));
    CHECK(area_of({{{0, 0}, 1}, {{5, 0}, 1}}) == Approx(2 * pi));
    CHECK(area_of({{{0, 0}, 1}, {{0, 0}, 1}, {{0.1, 0}, 0.2}}) == Approx(pi));  // equal, and within
    CHECK(area_of({{{0, 0}, 1}, {{2, 0}, 1}}) == Approx(2 * pi));               // touching
    // Two unit discs at distance 1 share a lens of 2 pi/3 - sqrt(3)/2.
    CHECK(area_of({{{0, 0}, 1}, {{1, 0}, 1}}) ==
          Approx(2 * pi - (2 * pi / 3 - std::sqrt(3.0) / 2)));
    // Four unit discs about the corners of a square of side 2, and one that fills the gap.
    CHECK(area_of({{{1, 1}, 1}, {{-1, 1}, 1}, {{-1, -1}, 1}, {{1, -1}, 1}, {{0, 0}, 1}}) ==
          Approx(4 * pi + pi - 4 * (pi / 2 - 1)));
    CHECK(area_of({}) == 0);
}

TEST_CASE("the area of random unions agrees with points thrown at them", "[report]") {
    lodtest::Random random(8);
    std::vector<Disc> discs;
    for (int i = 0; i < 30; ++i)
        discs.push_back({{random.in(-1, 1), random.in(-1, 1)}, random.in(0.02, 0.4)});
    int hits = 0;
    const int throws = 200000;
    for (int i = 0; i < throws; ++i) {
        const Point p(random.in(-1.5, 1.5), random.in(-1.5, 1.5));
        hits += std::any_of(discs.begin(), discs.end(), [&](const Disc& disc) {
            return (p - disc.centre).norm() <= disc.radius;
        });
    }
    // Standard deviation 9 sqrt(p (1 - p) / n) < 0.0101; five of them.
    CHECK(area_of(discs) == Approx(9.0 * hits / throws).margin(0.0504));
}

TEST_CASE("one circle round the unit square: protrusion, mean and area in closed form",
          "[report]") {
    const Shape square = generate("box");
    const double R = std::sqrt(0.5);
    const auto tree = lod::single_sphere<2>({{0, 0}, R * (1 + 1e-12)});
    const TreeReport report = report_tree(square, tree);
    REQUIRE(report.levels.size() == 1);
    const LevelReport& level = report.levels[0];
    CHECK(report.bounding_diameter == Approx(2 * R));
    CHECK(level.nodes == 1);
    CHECK(level.worst_protrusion == Approx(R - 0.5).margin(report.tolerance));
    CHECK(level.worst_protrusion >= R - 0.5);
    CHECK(level.worst_protrusion_fraction == Approx((R - 0.5) / (2 * R)).margin(1e-6));
    // Mean of R cos(t) - 1/2 for |t| <= pi/4: R (sin(pi/4) / (pi/4)) - 1/2 = 2/pi - 1/2.
    CHECK(level.mean_protrusion == Approx(2 / pi - 0.5).epsilon(1e-5));
    CHECK(level.measure_ratio == Approx(pi / 2));
    CHECK(level.certified);
    CHECK(level.uncovered == 0);
}

TEST_CASE("a quadtree's level of a square stands out by half as much as the one before",
          "[report]") {
    TreeSettings settings;
    settings.builder = Builder::quadtree;
    settings.depth = 3;
    const Shape square = generate("box");
    const TreeReport report = report_tree(square, build_tree(square, settings));
    for (std::size_t level = 0; level < 4; ++level) {
        const double half = std::ldexp(0.5, -static_cast<int>(level));
        CHECK(report.levels[level].nodes == 1 << 2 * level);
        CHECK(report.levels[level].worst_protrusion ==
              Approx(half * (std::sqrt(2.0) - 1)).margin(report.tolerance));
    }
}

TEST_CASE("a circle over a ring's hole stands out to the hole's middle", "[report]") {
    const Shape ring = generate("ring:0.7");  // diameter 1, hole 0.7
    const TreeReport report = report_tree(ring, lod::single_sphere<2>({{0, 0}, 0.51}));
    CHECK(report.levels[0].worst_protrusion == Approx(0.35).epsilon(0.01));
}

TEST_CASE("no sampled point of a union is farther out than the worst protrusion", "[report]") {
    lodtest::Random random(4);
    for (const char* spec : {"gear:9", "U", "spiral:2", "star:5"}) {
        const Shape shape = generate(spec);
        const BoundaryIndex index(shape.polygon);
        std::vector<Disc> discs;
        for (int i = 0; i < 5; ++i)
            discs.push_back({{random.in(-0.4, 0.4), random.in(-0.4, 0.4)}, random.in(0.05, 0.4)});
        const auto found =
            lod::find_protrusion<2>(index, std::span<const lod::Sphere<2>>(discs), 1e-5);
        CHECK(found.most - found.least <= 1e-5);
        CHECK(index.distance(found.at) == Approx(found.least));
        double sampled = 0;
        for (int i = 0; i < 20000; ++i) {
            const Disc& disc = discs[static_cast<std::size_t>(random.below(5))];
            const double angle = random.in(0, 2 * pi);
            const double r = disc.radius * std::sqrt(random.in(0, 1));
            sampled = std::max(
                sampled, index.distance(disc.centre + r * Point(std::cos(angle), std::sin(angle))));
        }
        CHECK(sampled <= found.most);
        CHECK(sampled >= 0.9 * found.least);
    }
}

TEST_CASE("a report of every builder's tree holds together", "[report]") {
    for (const char* spec : {"gear:9", "L", "ring:0.7", "blob:4"}) {
        INFO(spec);
        const Shape shape = generate(spec);
        for (const Builder builder : lod::choices<Builder>()) {
            INFO(lod::name_of(builder));
            TreeSettings settings;
            settings.builder = builder;
            const auto tree = build_tree(shape, settings);
            const TreeReport report = report_tree(shape, tree);
            REQUIRE(static_cast<int>(report.levels.size()) == tree.levels());
            for (const LevelReport& level : report.levels) {
                CHECK(level.certified);
                CHECK(level.measure_ratio >= 1);
                CHECK(level.mean_protrusion <= level.worst_protrusion);
                CHECK(level.mean_protrusion > 0);
            }
            CHECK(report.levels.back().worst_protrusion < report.levels[0].worst_protrusion);
        }
    }
}
