// The responses that serve as references: sequential, lcp, reflections. The two exact cases are
// worked by hand; the rest is what each of them conserves.

#include <cmath>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

constexpr double exact = 1e-12;

template <int Dim>
std::vector<Impact<Dim>> contacts_between(const std::vector<Body<Dim>>& bodies,
                                          std::initializer_list<CandidatePair> pairs) {
    std::vector<Impact<Dim>> impacts;
    for (const auto& [a, b] : pairs) {
        const Vector<Dim> line = bodies[static_cast<std::size_t>(b)].position -
                                 bodies[static_cast<std::size_t>(a)].position;
        const Vector<Dim> middle = bodies[static_cast<std::size_t>(a)].position + 0.5 * line;
        impacts.push_back(
            {a, b, static_cast<std::int32_t>(impacts.size()), {middle, line.normalized(), 0}});
    }
    return impacts;
}

template <int Dim>
bool moves(const Body<Dim>& body, double x, double y) {
    return (body.velocity - planar<Dim>(x, y)).norm() <= exact;
}

/// Bodies on a line, each in touch with the next by a few contacts whose normals lie within some 30
/// degrees of the line, so that all can part at once.
template <int Dim>
struct Row {
    std::vector<Body<Dim>> bodies;
    std::vector<Impact<Dim>> impacts;

    Row(Random& random, int body_count, int contacts_a_pair) {
        for (int i = 0; i < body_count; ++i) {
            bodies.push_back(random_body<Dim>(random));
            bodies.back().position = planar<Dim>(2.0 * i, 0);
        }
        for (int i = 0; i + 1 < body_count; ++i)
            for (int c = 0; c < contacts_a_pair; ++c) {
                const Vector<Dim> point =
                    planar<Dim>(2.0 * i + 1, 0) + random_vector<Dim>(random, 0.4);
                const Vector<Dim> normal = planar<Dim>(1, 0) + 0.5 * random_unit<Dim>(random);
                impacts.push_back({i, i + 1, i, {point, normal.normalized(), 0}});
            }
    }
    [[nodiscard]] double fastest_approach() const {
        double fastest = 0;
        for (const auto& [a, b, pair, touch] : impacts)
            fastest =
                std::max(fastest, -closing_velocity(bodies[static_cast<std::size_t>(a)],
                                                    bodies[static_cast<std::size_t>(b)], touch));
        return fastest;
    }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("a ball meets a row of two: reflections hand on, Newton spreads",
                       "[references]", ((int Dim), Dim), 2, 3) {
    const std::vector<Body<Dim>> before{disc<Dim>(1, 1, {0, 0}, {1, 0}), disc<Dim>(1, 1, {2, 0}),
                                        disc<Dim>(1, 1, {4, 0})};
    const auto impacts = contacts_between<Dim>(before, {{0, 1}, {1, 2}});

    auto bodies = before;
    resolve<Dim>(Response::reflections, impacts, bodies);
    CHECK(moves(bodies[0], 0, 0));
    CHECK(moves(bodies[1], 0, 0));
    CHECK(moves(bodies[2], 1, 0));

    bodies = before;
    resolve<Dim>(Response::lcp, impacts, bodies);
    CHECK(moves(bodies[0], -1.0 / 3, 0));
    CHECK(moves(bodies[1], 2.0 / 3, 0));
    CHECK(moves(bodies[2], 2.0 / 3, 0));

    bodies = before;
    resolve<Dim>(Response::sequential, impacts, bodies);
    CHECK(moves(bodies[2], 1, 0));
}

TEMPLATE_TEST_CASE_SIG("a break onto two: Newton and reflections are symmetric, one by one is not",
                       "[references]", ((int Dim), Dim), 2, 3) {
    const double across = std::sqrt(3.0);
    const std::vector<Body<Dim>> before{disc<Dim>(1, 1, {0, 0}, {1, 0}),
                                        disc<Dim>(1, 1, {across, 1}),
                                        disc<Dim>(1, 1, {across, -1})};
    const auto impacts = contacts_between<Dim>(before, {{0, 1}, {0, 2}});
    for (const Response response : {Response::lcp, Response::reflections}) {
        auto bodies = before;
        resolve<Dim>(response, impacts, bodies);
        CHECK(moves(bodies[0], -0.2, 0));
        CHECK(moves(bodies[1], 0.6, 0.6 / across));
        CHECK(moves(bodies[2], 0.6, -0.6 / across));
    }
    auto bodies = before;
    resolve<Dim>(Response::sequential, impacts, bodies);
    CHECK(std::abs(bodies[1].velocity[1] + bodies[2].velocity[1]) > 0.1);
    CHECK(std::abs(energy(bodies) - 0.5) <= exact);
}

TEMPLATE_TEST_CASE_SIG("sequential impulses and reflections keep energy, Newton never adds any",
                       "[references]", ((int Dim), Dim), 2, 3) {
    Random random(20260701);
    for (int round = 0; round < 100; ++round) {
        const Row<Dim> row(random, 2 + random.below(4), 1 + random.below(6));
        const double before = energy(row.bodies);
        for (const Response response : {Response::sequential, Response::reflections}) {
            auto after = row;
            resolve<Dim>(response, row.impacts, after.bodies);
            CHECK(std::abs(energy(after.bodies) - before) <= 1e-10 * before);
        }
        auto elastic = row.bodies;
        resolve<Dim>(Response::lcp, row.impacts, elastic);
        CHECK(std::abs(energy(elastic) - before) <= 1e-9 * before);
        auto lossy = row.bodies;
        for (auto& body : lossy) body.restitution = 0.5;
        resolve<Dim>(Response::lcp, row.impacts, lossy);
        CHECK(energy(lossy) <= before * (1 + 1e-12));
    }
}

TEMPLATE_TEST_CASE_SIG("after reflections no contact approaches", "[references]", ((int Dim), Dim),
                       2, 3) {
    Random random(77);
    for (int round = 0; round < 100; ++round) {
        Row<Dim> row(random, 2 + random.below(4), 1 + random.below(6));
        for (auto& body : row.bodies) body.restitution = random.in(0, 1);
        const double before = row.fastest_approach();
        resolve<Dim>(Response::reflections, row.impacts, row.bodies);
        CHECK(row.fastest_approach() <= 1e-9 * before);
    }
}

TEMPLATE_TEST_CASE_SIG("every reference is equation (1) for a single contact", "[references]",
                       ((int Dim), Dim), 2, 3) {
    Random random(5);
    for (int round = 0; round < 100; ++round) {
        Row<Dim> row(random, 2, 1);
        row.bodies[0].restitution = random.in(0, 1);
        const double j = single_impulse(row.bodies[0], row.bodies[1], row.impacts[0].contact);
        for (const Response response :
             {Response::sequential, Response::lcp, Response::reflections, Response::net}) {
            auto bodies = row.bodies;
            CHECK(std::abs(resolve<Dim>(response, row.impacts, bodies)[0] - j) <= 1e-12 * (1 + j));
        }
    }
}
