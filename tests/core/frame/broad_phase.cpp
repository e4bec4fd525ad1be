#include "lodlab/core/frame/broad_phase.hpp"

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/property.hpp"

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
std::vector<PosedTree<Dim>> posed(const std::vector<Body<Dim>>& bodies) {
    std::vector<PosedTree<Dim>> world_S(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) world_S[i].pose(bodies[i]);
    return world_S;
}

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

TEMPLATE_TEST_CASE_SIG("rows and sheets of bodies cost linear time along every axis",
                       "[broad_phase]", ((int Dim), Dim), 2, 3) {
    const int axis = GENERATE(range(0, Dim));
    const bool is_sheet = GENERATE(false, true);
    for (const int count : {1024, 2048, 4096}) {
        Random random(35);
        const int side = is_sheet ? static_cast<int>(std::sqrt(count)) : count;
        std::vector<Body<Dim>> bodies;
        for (int i = 0; i < count; ++i) {
            bodies.push_back(disc<Dim>(1, 0.4, {0, 0}));
            bodies.back().position = Vector<Dim>::Zero();
            bodies.back().position[axis] = i % side;
            bodies.back().position[(axis + 1) % Dim] = i / side;
        }
        for (std::size_t i = bodies.size() - 1; i > 0; --i)  // in no order
            std::swap(bodies[i],
                      bodies[static_cast<std::size_t>(random.below(static_cast<int>(i) + 1))]);
        BroadPhase<Dim> broad_phase;
        std::vector<CandidatePair> pairs;
        broad_phase.find(bodies, posed(bodies), pairs);
        CHECK(pairs.empty());
        CHECK(broad_phase.steps() <= 8 * bodies.size());
        std::ranges::reverse(bodies);  // as far from the order of before as it gets
        broad_phase.find(bodies, posed(bodies), pairs);
        CHECK(broad_phase.steps() <= 40 * bodies.size());
    }
}
