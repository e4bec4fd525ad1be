#include "lodlab/core/frame/broad_phase.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/property.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// Every pair of boxes that meet, by asking all of them. Exact: centres are where they were put.
template <int Dim>
std::vector<CandidatePair> brute_force(const std::vector<Body<Dim>>& bodies, double margin) {
    std::vector<CandidatePair> pairs;
    for (std::size_t a = 0; a < bodies.size(); ++a)
        for (std::size_t b = a + 1; b < bodies.size(); ++b) {
            if (bodies[a].is_static() && bodies[b].is_static()) continue;
            const double reach = bodies[a].tree->radius[0] + bodies[b].tree->radius[0] + margin;
            const auto gap = (bodies[a].position - bodies[b].position).cwiseAbs();
            if (gap.maxCoeff() <= reach)
                pairs.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)});
        }
    return pairs;
}

template <int Dim>
std::vector<Body<Dim>> scattered(Random& random, int count, double room) {
    std::vector<Body<Dim>> bodies;
    for (int i = 0; i < count; ++i) {
        bodies.push_back(disc<Dim>(1, random.in(0.1, 1), {0, 0}));
        bodies.back().position = random_vector<Dim>(random, room);
        bodies.back().velocity = random_vector<Dim>(random, 1);
        if (random.below(4) == 0) make_static(bodies.back());
    }
    return bodies;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the broad phase finds what brute force finds, frame after frame",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    check_property(31, 60, [](std::uint64_t seed) {
        Random random(seed);
        auto bodies = scattered<Dim>(random, 1 + random.below(40), 4);
        BroadPhase<Dim> broad_phase;
        std::vector<CandidatePair> pairs;
        for (int frame = 0; frame < 20; ++frame) {
            const auto world_S = posed(bodies);
            broad_phase.find(bodies, world_S, pairs);
            // Random places never lie within rounding of the boxes' touching, so margin 0 will do.
            RC_ASSERT(pairs == brute_force(bodies, 0));
            for (auto& body : bodies)
                if (!body.is_static()) body.position += 0.1 * body.velocity;
        }
    });
}

TEMPLATE_TEST_CASE_SIG("the broad phase follows bodies that come, go and change places",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    Random random(32);
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> pairs;
    for (const int count : {10, 3, 50, 50, 1, 0, 20}) {
        const auto bodies = scattered<Dim>(random, count, 3);
        const auto world_S = posed(bodies);
        broad_phase.find(bodies, world_S, pairs);
        CHECK(pairs == brute_force(bodies, 0));
    }
}

TEMPLATE_TEST_CASE_SIG("bodies that only touch are candidates, static pairs are not",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies{disc<Dim>(1, 1, {0, 0}), disc<Dim>(1, 0.5, {1.5, 0}),
                                  disc<Dim>(1, 0.1, {1.5, 0.6}), disc<Dim>(1, 1, {9, 9})};
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> pairs;
    broad_phase.find(bodies, posed(bodies), pairs);
    CHECK(pairs == std::vector<CandidatePair>{{0, 1}, {1, 2}});

    make_static(bodies[1]);
    broad_phase.find(bodies, posed(bodies), pairs);
    CHECK(pairs == std::vector<CandidatePair>{{0, 1}, {1, 2}});  // one of each pair still moves

    make_static(bodies[0]);
    broad_phase.find(bodies, posed(bodies), pairs);
    CHECK(pairs == std::vector<CandidatePair>{{1, 2}});
}

namespace {

/// Bodies of one radius in no order, a metre apart, along one axis or two, or spread over a room.
template <int Dim>
std::vector<Body<Dim>> laid_out(Random& random, int count,
                                const std::function<Vector<Dim>(int)>& place) {
    std::vector<Body<Dim>> bodies;
    for (int i = 0; i < count; ++i) {
        bodies.push_back(disc<Dim>(1, 0.4, {0, 0}));
        bodies.back().position = place(i);
    }
    for (std::size_t i = bodies.size() - 1; i > 0; --i)
        std::swap(bodies[i],
                  bodies[static_cast<std::size_t>(random.below(static_cast<int>(i) + 1))]);
    return bodies;
}

/// Comparisons for each body and pair that is found.
template <int Dim>
double steps_each(const std::vector<Body<Dim>>& bodies) {
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> pairs;
    broad_phase.find(bodies, posed(bodies), pairs);
    return static_cast<double>(broad_phase.steps()) /
           static_cast<double>(bodies.size() + pairs.size());
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("rows and sheets of bodies cost linear time along every axis",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    const int axis = GENERATE(range(0, Dim));
    const bool is_sheet = GENERATE(false, true);
    for (const int count : {1024, 2048, 4096}) {
        Random random(35);
        const int side = is_sheet ? static_cast<int>(std::sqrt(count)) : count;
        const auto bodies = laid_out<Dim>(random, count, [&](int i) {
            Vector<Dim> place = Vector<Dim>::Zero();
            place[axis] = i % side;
            place[(axis + 1) % Dim] = i / side;
            return place;
        });
        // Two for its own pencil and the next, four more in space; each ends one beyond.
        CHECK(steps_each(bodies) <= 8);
    }
}

TEMPLATE_TEST_CASE_SIG("a crowd costs linear time, wherever its bodies are and however they jump",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> pairs;
    for (const int count : {1000, 2000, 4000, 8000}) {
        Random random(36);
        const double room = 0.5 * std::pow(count, 1.0 / Dim);
        auto bodies =
            laid_out<Dim>(random, count, [&](int) { return random_vector<Dim>(random, room); });
        for (const double far : {0.0, 1e9, -1e9, 1e15, -1e200}) {
            for (auto& body : bodies) body.position = random_vector<Dim>(random, room);
            if (far != 0) bodies[7].position = far * Vector<Dim>::Unit(random.below(Dim));
            broad_phase.find(bodies, posed(bodies), pairs);
            // Within reach, some 0.8 by 0.8 m by twice that along a pencil, is about one body;
            // there are two pencils to look at in the plane and five in space.
            CHECK(broad_phase.steps() <= 16 * bodies.size());
        }
    }
}

TEMPLATE_TEST_CASE_SIG("sizes from 1 to 1000 cost little more than one size", "[broad_phase]",
                       ((int Dim), Dim), 2, 3) {
    double least = 1e9;
    double most = 0;
    for (const int count : {1000, 2000, 4000, 8000}) {
        Random random(37);
        std::vector<Body<Dim>> bodies;
        const double room = 2 * std::pow(count, 1.0 / Dim);
        for (int i = 0; i < count; ++i) {
            bodies.push_back(disc<Dim>(1, 5 * std::pow(10, random.in(-3, 0)), {0, 0}));
            bodies.back().position = random_vector<Dim>(random, room);
        }
        const double each = steps_each(bodies);
        least = std::min(least, each);
        most = std::max(most, each);
    }
    CHECK(most <= 30);
    CHECK(most <= 1.5 * least);
}

TEMPLATE_TEST_CASE_SIG("one large body among many small ones costs no more than its own pairs",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    for (const double radius : {1.0, 3.0, 30.0, 1000.0})
        for (const int count : {1000, 4000}) {
            Random random(38);
            const double room = 0.5 * std::pow(count, 1.0 / Dim);
            auto bodies =
                laid_out<Dim>(random, count, [&](int) { return random_vector<Dim>(random, room); });
            bodies.push_back(disc<Dim>(1, radius, {0, 0}));
            CAPTURE(radius, count);
            CHECK(steps_each(bodies) <= 16);
        }
}

TEMPLATE_TEST_CASE_SIG("the broad phase finds what brute force finds in crowds of any kind",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    check_property(39, 150, [](std::uint64_t seed) {
        Random random(seed);
        BroadPhase<Dim> broad_phase;
        std::vector<CandidatePair> pairs;
        const double sizes = random.in(0, 4);  // powers of ten from the largest to the least
        const double room = std::pow(10, random.in(-1, 1.5));
        const int clusters = 1 + random.below(3);
        const double apart = random.below(2) == 0 ? 5 : 1e7;
        std::vector<Body<Dim>> bodies;
        for (int i = 0; i < 150; ++i) {
            bodies.push_back(disc<Dim>(1, std::pow(10, random.in(-sizes, 0)), {0, 0}));
            bodies.back().position =
                random_vector<Dim>(random, room) +
                apart * random.below(clusters) * Vector<Dim>::Unit(random.below(Dim));
            if (random.below(8) == 0) make_static(bodies.back());
        }
        if (random.below(2) == 0) bodies[3].position[random.below(Dim)] = random.in(-1e9, 1e9);
        broad_phase.find(bodies, posed(bodies), pairs);
        RC_ASSERT(pairs == brute_force(bodies, 0));
        const auto before = pairs;
        broad_phase.find(bodies, posed(bodies), pairs);
        RC_ASSERT(pairs == before);
    });
}

TEMPLATE_TEST_CASE_SIG("many bodies at one place are all found", "[broad_phase]", ((int Dim), Dim),
                       2, 3) {
    Random random(40);
    const std::size_t count = 300;
    const auto bodies = laid_out<Dim>(random, count, [](int) { return planar<Dim>(1e3, 0); });
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> pairs;
    broad_phase.find(bodies, posed(bodies), pairs);
    CHECK(pairs.size() == count * (count - 1) / 2);
    CHECK(broad_phase.steps() <= 2 * pairs.size());
}

TEMPLATE_TEST_CASE_SIG("bodies that are nowhere meet none, and the others meet as before",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    const double infinity = std::numeric_limits<double>::infinity();
    Random random(41);
    auto bodies = scattered<Dim>(random, 40, 3);
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> pairs;
    broad_phase.find(bodies, posed(bodies), pairs);
    const auto before = pairs;
    CHECK_FALSE(before.empty());
    for (const double nowhere : {infinity, -infinity, std::nan(""), 1e308, -1e308}) {
        auto more = bodies;
        for (const bool is_static : {false, false, true}) {
            more.push_back(disc<Dim>(1, 1, {0, 0}));
            more.back().position[random.below(Dim)] = nowhere;
            if (is_static) make_static(more.back());
        }
        broad_phase.find(more, posed(more), pairs);
        CHECK(pairs == before);
    }
}

TEMPLATE_TEST_CASE_SIG("half-spaces are candidates of the bodies that move and reach them",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    Random random(42);
    auto bodies = scattered<Dim>(random, 60, 4);
    std::vector<CandidatePair> expected = brute_force(bodies, 0);
    for (const double height : {-2.0, 1.0}) {
        const auto wall = static_cast<std::int32_t>(bodies.size());
        for (std::int32_t i = 0; i < 60; ++i) {
            const Body<Dim>& body = bodies[static_cast<std::size_t>(i)];
            if (!body.is_static() && body.position[1] - body.tree->radius[0] <= height)
                expected.push_back({i, wall});
        }
        bodies.push_back(immovable<Dim>());
        bodies.back().tree =
            std::make_shared<SphereTree<Dim>>(half_space<Dim>(Vector<Dim>(Vector<Dim>::Unit(1))));
        bodies.back().position = planar<Dim>(7, height);
    }
    std::ranges::sort(expected, {}, [](const CandidatePair& p) { return std::pair(p.a, p.b); });
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> pairs;
    broad_phase.find(bodies, posed(bodies), pairs);
    CHECK(pairs == expected);
}

TEST_CASE("cells are sorted by pencil and place, equal ones stay in order", "[broad_phase]") {
    check_property(43, 60, [](std::uint64_t seed) {
        Random random(seed);
        std::vector<GridCell> cells;
        const int widths[] = {random.below(33), random.below(33), random.below(33)};
        const auto number = [&](int width) { return random.bits() >> 32 >> (32 - width); };
        for (int i = random.below(200); i > 0; --i)
            cells.push_back({number(widths[0]) << 32 | number(widths[1]),
                             static_cast<std::uint32_t>(number(widths[2])),
                             static_cast<std::int32_t>(cells.size())});
        const auto key = [](const GridCell& cell) {
            return std::tuple(cell.pencil, cell.along, cell.box);
        };
        auto expected = cells;
        std::ranges::sort(expected, {}, key);
        std::vector<GridCell> spare;
        sort_cells(cells, spare);
        RC_ASSERT(std::ranges::equal(cells, expected, {}, key, key));
    });
}
