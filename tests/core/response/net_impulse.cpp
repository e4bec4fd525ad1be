// The net impulse: each pair by itself, and pairs that act on each other together.

#include <cmath>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// `count` contacts along a face at x, from y = -reach to reach.
template <int Dim>
void touch_along(double x, double reach, int count, std::int32_t a, std::int32_t b,
                 std::vector<Impact<Dim>>& impacts) {
    for (int c = 0; c < count; ++c) {
        const double y = count == 1 ? 0 : reach * (2.0 * c / (count - 1) - 1);
        impacts.push_back({a, b, a * 100 + b, planar_contact<Dim>({x, y}, {1, 0})});
    }
}

template <int Dim>
double speed_apart(const Body<Dim>& a, const Body<Dim>& b) {
    return (a.velocity - b.velocity).norm() + (a.spin - b.spin).norm();
}

/// The worst difference of velocity or spin between two states of the same bodies.
template <int Dim>
double difference(const std::vector<Body<Dim>>& one, const std::vector<Body<Dim>>& other) {
    double worst = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        worst = std::max(worst, speed_apart(one[i], other[i]));
    return worst;
}

/// Pairs that may share bodies, each with a few contacts within some 45 degrees of the line of its
/// two bodies.
template <int Dim>
struct Pile {
    std::vector<Body<Dim>> bodies;
    std::vector<Impact<Dim>> impacts;

    Pile(Random& random, int body_count, int pair_count) {
        for (int i = 0; i < body_count; ++i) bodies.push_back(random_body<Dim>(random));
        for (int p = 0; p < pair_count; ++p) {
            const int a = random.below(body_count - 1);
            const int b = a + 1 + random.below(body_count - a - 1);
            for (int c = random.below(3); c >= 0; --c) impacts.push_back(contact(random, a, b));
        }
        std::ranges::stable_sort(impacts, {}, &Impact<Dim>::pair);
    }

    Impact<Dim> contact(Random& random, int a, int b) const {
        const Vector<Dim> from = bodies[static_cast<std::size_t>(a)].position;
        const Vector<Dim> to = bodies[static_cast<std::size_t>(b)].position;
        const Vector<Dim> normal =
            ((to - from).normalized() + 0.7 * random_unit<Dim>(random)).normalized();
        const Vector<Dim> point = 0.5 * (from + to) + 0.5 * random_vector<Dim>(random, 1);
        return {a, b, a * 100 + b, {point, normal, 0}};
    }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("collisions that cannot act on each other have each its own answer",
                       "[net_impulse]", ((int Dim), Dim), 2, 3) {
    // A meets B on a face, C meets D, and B and C touch but part. Worked by hand for C and D: the
    // arm across the normal is 0.25, K = 2 + 2 (0.25)^2 6 = 2.75, j = 2 / 2.75.
    for (const int contacts : {0, 1, 2, 4, 32}) {
        std::vector<Body<Dim>> bodies;
        const double velocities[] = {-2, -3, 3, 2};
        for (int i = 0; i < 4; ++i)
            bodies.push_back(planar_body<Dim>(1, 1.0 / 6, {i - 1.0, 0}, {velocities[i], 0}));
        std::vector<Impact<Dim>> impacts;
        touch_along<Dim>(-0.5, 0.5, contacts, 0, 1, impacts);
        touch_along<Dim>(0.5, 0.5, contacts, 1, 2, impacts);
        impacts.push_back({2, 3, 203, planar_contact<Dim>({1.5, 0.25}, {1, 0})});
        resolve<Dim>(Response::net, impacts, bodies);
        INFO(contacts << " contacts of A and B");
        CHECK(std::abs(bodies[2].velocity[0] - (3 - 2 / 2.75)) <= 1e-12);
        CHECK(std::abs(planar_spin(bodies[2]) - 0.25 * 6 * 2 / 2.75) <= 1e-12);
        if (contacts == 0) continue;
        CHECK(std::abs(bodies[0].velocity[0] - -3) <= 1e-12);  // equal masses, face on face
        CHECK(std::abs(bodies[1].velocity[0] - -2) <= 1e-12);
    }
}

namespace {

/// Two balls that fell on one floor, with e = 0 at 1 m/s and e = 1 at 3 m/s, after the response.
template <int Dim>
std::vector<Body<Dim>> landed_on(const Body<Dim>& floor) {
    std::vector<Body<Dim>> bodies{floor, planar_body<Dim>(1, 1, {-5, 1}, {0, -1}),
                                  planar_body<Dim>(1, 1, {5, 1}, {0, -3})};
    bodies[1].restitution = 0;
    resolve<Dim>(Response::net,
                 {{0, 1, 0, planar_contact<Dim>({-5, 0}, {0, 1})},
                  {0, 2, 1, planar_contact<Dim>({5, 0}, {0, 1})}},
                 bodies);
    return bodies;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("bodies that share only a static body are two islands", "[net_impulse]",
                       ((int Dim), Dim), 2, 3) {
    // The fast one must not share its impulse with the slow one.
    const auto bodies = landed_on(immovable<Dim>());
    CHECK(bodies[1].velocity[1] == Approx(0).margin(1e-15));
    CHECK(bodies[2].velocity[1] == Approx(3));
}

TEMPLATE_TEST_CASE_SIG("a heavy floor is as a static one, the lighter the bodies the more",
                       "[net_impulse]", ((int Dim), Dim), 2, 3) {
    for (const double mass : {1e3, 1e6, 1e9}) {
        const auto bodies = landed_on(planar_body<Dim>(mass, mass * 1e3, {0, -1}));
        CHECK(std::abs(bodies[1].velocity[1]) <= 20 / mass);
        CHECK(std::abs(bodies[2].velocity[1] - 3) <= 20 / mass);
    }
}

TEMPLATE_TEST_CASE_SIG("static is the limit of heavy, in any pile", "[net_impulse]",
                       ((int Dim), Dim), 2, 3) {
    Random random(401);
    for (int trial = 0; trial < 300; ++trial) {
        // One visit each: after several, who still approaches may turn on the last digit.
        Pile<Dim> pile(random, 4, 4);
        std::vector<Body<Dim>> heavy = pile.bodies;
        make_static(pile.bodies[0]);
        heavy[0] = pile.bodies[0];
        set_mass<Dim>(heavy[0], 1e12, 1e12 * Inertia<Dim>::Identity());
        std::vector<double> impulses(pile.impacts.size());
        for (std::vector<Body<Dim>>* bodies : {&pile.bodies, &heavy})
            NetImpulse<Dim>().resolve(pile.impacts, *bodies, impulses, 1);
        for (std::size_t i = 1; i < 4; ++i) CHECK(speed_apart(pile.bodies[i], heavy[i]) <= 1e-8);
    }
}

TEMPLATE_TEST_CASE_SIG("a break keeps its symmetry with 5 contacts against 1", "[net_impulse]",
                       ((int Dim), Dim), 2, 3) {
    const double root3 = std::sqrt(3.0);
    for (const int contacts : {1, 2, 5, 40}) {
        std::vector<Body<Dim>> bodies{disc<Dim>(1, 0.5, {0, 0}, {1, 0}),
                                      disc<Dim>(1, 0.5, {root3 / 2, 0.5}),
                                      disc<Dim>(1, 0.5, {root3 / 2, -0.5})};
        std::vector<Impact<Dim>> impacts;
        for (int c = 0; c < contacts; ++c)
            impacts.push_back({0, 1, 1, planar_contact<Dim>({root3 / 4, 0.25}, {root3 / 2, 0.5})});
        impacts.push_back({0, 2, 2, planar_contact<Dim>({root3 / 4, -0.25}, {root3 / 2, -0.5})});
        resolve<Dim>(Response::net, impacts, bodies);
        CHECK(std::abs(bodies[0].velocity[0] - -0.2) <= 1e-12);
        CHECK(std::abs(bodies[0].velocity[1]) <= 1e-12);
        for (const int i : {1, 2}) {
            const Vector<Dim>& v = bodies[static_cast<std::size_t>(i)].velocity;
            CHECK(std::abs(v[0] - 0.6) <= 1e-12);
            CHECK(std::abs(v[1] - (i == 1 ? 0.2 : -0.2) * root3) <= 1e-12);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("repeating a pair's contacts changes nothing", "[net_impulse]",
                       ((int Dim), Dim), 2, 3) {
    Random random(402);
    for (int trial = 0; trial < 500; ++trial) {
        Pile<Dim> pile(random, 3 + random.below(4), 1 + random.below(8));
        std::vector<Body<Dim>> repeated = pile.bodies;
        std::vector<Impact<Dim>> impacts = pile.impacts;
        // All contacts of one pair, so many times more.
        const std::int32_t pair =
            impacts[static_cast<std::size_t>(random.below(static_cast<int>(impacts.size())))].pair;
        for (int times = 1 + random.below(4); times > 0; --times)
            for (const Impact<Dim>& impact : pile.impacts)
                if (impact.pair == pair) impacts.push_back(impact);
        resolve<Dim>(Response::net, pile.impacts, pile.bodies);
        resolve<Dim>(Response::net, impacts, repeated);
        CHECK(difference(pile.bodies, repeated) <= 1e-11);
    }
}

TEMPLATE_TEST_CASE_SIG("a collision that cannot act on the others changes no bit of theirs",
                       "[net_impulse]", ((int Dim), Dim), 2, 3) {
    Random random(403);
    for (int trial = 0; trial < 300; ++trial) {
        Pile<Dim> pile(random, 4, 5);
        pile.bodies.push_back(random_body<Dim>(random));
        pile.bodies.push_back(random_body<Dim>(random));
        make_static(pile.bodies[0]);
        std::vector<Body<Dim>> more = pile.bodies;
        std::vector<Impact<Dim>> impacts = pile.impacts;
        impacts.push_back(pile.contact(random, 4, 5));
        impacts.push_back(pile.contact(random, 0, 5));  // both touch the static body
        impacts.insert(impacts.begin(), pile.contact(random, 0, 4));
        resolve<Dim>(Response::net, pile.impacts, pile.bodies);
        resolve<Dim>(Response::net, impacts, more);
        for (std::size_t i = 0; i < 4; ++i) CHECK(speed_apart(pile.bodies[i], more[i]) == 0);
    }
}

TEMPLATE_TEST_CASE_SIG("mirrored in, mirrored out", "[net_impulse]", ((int Dim), Dim), 2, 3) {
    Random random(404);
    const auto mirrored = [](Vector<Dim> v) {
        v[0] = -v[0];
        return v;
    };
    for (int trial = 0; trial < 300; ++trial) {
        Pile<Dim> pile(random, 4, 6);
        std::vector<Body<Dim>> bodies = pile.bodies;
        std::vector<Impact<Dim>> impacts = pile.impacts;
        // A spin is an axial vector: a mirror at x = 0 keeps its part along x and turns the others.
        const auto mirror = [&](Body<Dim>& body) {
            body.position = mirrored(body.position);
            body.velocity = mirrored(body.velocity);
            for (int d = 0; d < body.spin.size(); ++d)
                if (Dim == 2 || d > 0) body.spin[d] = -body.spin[d];
        };
        for (std::vector<Body<Dim>>* side : {&pile.bodies, &bodies})
            for (Body<Dim>& body : *side) {
                body.orientation = Space<Dim>::unturned();  // of inertias along the axes
                if (side == &bodies) mirror(body);
            }
        for (Impact<Dim>& impact : impacts) {
            impact.contact.point = mirrored(impact.contact.point);
            impact.contact.normal = mirrored(impact.contact.normal);
        }
        resolve<Dim>(Response::net, pile.impacts, pile.bodies);
        resolve<Dim>(Response::net, impacts, bodies);
        for (Body<Dim>& body : bodies) mirror(body);
        CHECK(difference(pile.bodies, bodies) == 0);
    }
}

TEMPLATE_TEST_CASE_SIG("a response cut after any visit keeps momentum and at e = 1 energy",
                       "[net_impulse]", ((int Dim), Dim), 2, 3) {
    Random random(405);
    double worst = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const Pile<Dim> pile(random, 3 + random.below(8), 1 + random.below(20));
        const auto momentum_of = [](const std::vector<Body<Dim>>& bodies) {
            return momentum(std::span<const Body<Dim>>(bodies));
        };
        std::vector<double> impulses(pile.impacts.size());
        for (const int most : {1, 2, 3, 7}) {
            std::vector<Body<Dim>> bodies = pile.bodies;
            const ResponseReport report =
                NetImpulse<Dim>().resolve(pile.impacts, bodies, impulses, most);
            worst = std::max(worst, std::abs(energy(bodies) / energy(pile.bodies) - 1));
            worst = std::max(worst, (momentum_of(bodies) - momentum_of(pile.bodies)).norm() /
                                        momentum_of(pile.bodies).norm());
            CHECK(report.most_visits <= most);
            CHECK(report.row_visits <= static_cast<std::uint64_t>(most + 1) * pile.impacts.size());
        }
    }
    CHECK(worst <= 1e-12);
}

TEMPLATE_TEST_CASE_SIG("what still approaches is counted, and no faster than said", "[net_impulse]",
                       ((int Dim), Dim), 2, 3) {
    Random random(406);
    int some = 0;
    for (int trial = 0; trial < 300; ++trial) {
        Pile<Dim> pile(random, 6, 12);
        std::vector<double> impulses(pile.impacts.size());
        const ResponseReport report =
            NetImpulse<Dim>().resolve(pile.impacts, pile.bodies, impulses, 1 + random.below(3));
        int approaching = 0;
        double fastest = 0;
        for (const Impact<Dim>& impact : pile.impacts) {
            const double speed =
                -closing_velocity(pile.bodies[static_cast<std::size_t>(impact.a)],
                                  pile.bodies[static_cast<std::size_t>(impact.b)], impact.contact);
            approaching += speed > 1e-10;
            fastest = std::max(fastest, speed);
        }
        CHECK(report.approaching == approaching);
        CHECK(std::abs(report.fastest - std::max(fastest, report.fastest)) <= 1e-10);
        some += approaching > 0;
    }
    CHECK(some > 30);
}
