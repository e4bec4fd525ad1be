#include "lodlab/viz/paint/labels.hpp"

#include <algorithm>
#include <cmath>

#include "tests/catch.hpp"
#include "tests/random.hpp"

using namespace viz;

namespace {

constexpr Rect page{0, 0, 900, 600};

double distance_to(const Rect& box, Point p) {
    const double dx = std::max({box.x - p.x, 0.0, p.x - box.right()});
    const double dy = std::max({box.y - p.y, 0.0, p.y - box.bottom()});
    return std::hypot(dx, dy);
}

std::vector<LabelRequest> random_requests(lodtest::Random& random) {
    std::vector<LabelRequest> requests(static_cast<std::size_t>(2 + random.below(11)));
    for (LabelRequest& request : requests) {
        request.anchor = {random.in(100, 800), random.in(100, 500)};
        request.clearance = random.below(2) == 0 ? 0 : random.in(5, 60);
        request.extent = {random.in(20, 130), 22};
    }
    return requests;
}

}  // namespace

TEST_CASE("labels never overlap each other, leave the page or cover what they name", "[labels]") {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        lodtest::Random random(seed);
        const auto requests = random_requests(random);
        const auto placed = place_labels(requests, {}, page);
        INFO("seed " << seed);
        REQUIRE(placed.size() == requests.size());
        for (std::size_t i = 0; i < placed.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j)
                CHECK(overlap_area(placed[i].box, placed[j].box) == 0);
            CHECK(overlap_area(placed[i].box, page) ==
                  Approx(placed[i].box.width * placed[i].box.height));
            CHECK(distance_to(placed[i].box, requests[i].anchor) >= requests[i].clearance);
        }
    }
}

TEST_CASE("labels keep off dots and arrows when there is room", "[labels]") {
    Obstacles obstacles;
    obstacles.boxes.push_back({460, 280, 60, 40});
    obstacles.segments.push_back({{450, 300}, {450, 100}, 25});
    const auto placed = place_labels({{{450, 300}, 0, {80, 22}, {0, 0}}}, obstacles, page);
    CHECK(overlap_area(placed[0].box, obstacles.boxes[0]) == 0);
    double from = 0;
    double until = 1;
    CHECK_FALSE(clip_segment({450, 299}, {450, 100}, placed[0].box, from, until));
}

TEST_CASE("a label that stands far from its anchor has a leader line to it", "[labels]") {
    Obstacles obstacles;  // a wall of dots all round
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j)
            obstacles.boxes.push_back({350.0 + 5 * i, 200.0 + 5 * j, 4, 4});
    const auto placed = place_labels({{{450, 300}, 0, {80, 22}, {0, 0}}}, obstacles, page);
    CHECK(placed[0].leader);
    CHECK(distance_to(placed[0].box, placed[0].leader_from) == 0);
    CHECK(std::hypot(placed[0].leader_to.x - 450, placed[0].leader_to.y - 300) < 3);
}

TEST_CASE("a line is cut where it leaves a rectangle and taken up where it enters", "[labels]") {
    const auto parts =
        clipped_line({{-10, 5}, {5, 5}, {5, 20}, {8, 20}, {8, 5}}, Rect{0, 0, 10, 10});
    REQUIRE(parts.size() == 2);
    CHECK(parts[0] == Ring{{0, 5}, {5, 5}, {5, 10}});
    CHECK(parts[1] == Ring{{8, 10}, {8, 5}});
}

TEST_CASE("a huge disc is its rim where the rim passes, all or nothing elsewhere", "[labels]") {
    const Rect window{0, 0, 100, 100};
    CHECK(clipped_disc({0, 1e9}, 1e8, window).empty());
    CHECK(clipped_disc({50, 50}, 1e9, window).size() == 4);
    const Ring rim = clipped_disc({50, 1e9 + 30}, 1e9, window);  // its top lies at y = 30
    double top = 1e9;
    for (const Point& p : rim) top = std::min(top, p.y);
    CHECK(top == Approx(30).margin(0.01));
}

TEST_CASE("names in a column keep the order of their curves, apart and within bounds", "[labels]") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        lodtest::Random random(seed);
        std::vector<LabelRequest> requests(static_cast<std::size_t>(3 + random.below(8)));
        for (LabelRequest& request : requests) {
            request.anchor = {700, random.in(20, 580)};
            request.extent = {random.in(20, 130), 22};
        }
        REQUIRE(end_in_column(requests, 720));
        const auto placed = place_in_column(requests, 734, page);
        INFO("seed " << seed);
        for (std::size_t i = 0; i < placed.size(); ++i) {
            CHECK(placed[i].box.x == 734);
            CHECK(placed[i].box.y >= page.y);
            CHECK(placed[i].box.bottom() <= page.bottom());
            for (std::size_t j = 0; j < i; ++j) {
                CHECK(overlap_area(placed[i].box, placed[j].box) == 0);
                if (requests[i].anchor.y != requests[j].anchor.y)
                    CHECK((placed[i].box.y < placed[j].box.y) ==
                          (requests[i].anchor.y < requests[j].anchor.y));
            }
        }
    }
}

TEST_CASE("a name in a column that has room stands beside its curve's end", "[labels]") {
    const auto placed = place_in_column({{{700, 100}, 0, {80, 22}, {}},
                                         {{700, 300}, 0, {80, 22}, {}},
                                         {{700, 310}, 0, {80, 22}, {}}},
                                        734, page);
    CHECK(placed[0].box.y + 11 == Approx(100));
    CHECK((placed[1].box.y + placed[2].box.bottom()) / 2 == Approx(305));
    CHECK_FALSE(end_in_column({{{700, 100}, 0, {80, 22}, {}}, {{700, 300}, 0, {80, 22}, {}}}, 720));
    CHECK_FALSE(end_in_column({{{700, 100}, 0, {80, 22}, {}},
                               {{300, 300}, 0, {80, 22}, {}},
                               {{700, 310}, 0, {80, 22}, {}}},
                              720));
}
