#include "lodlab/core/response/response.hpp"

#include <cmath>
#include <numeric>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
Contact<Dim> random_contact(Random& random, const Vector<Dim>& near) {
    return {near + random_vector<Dim>(random, 1), random_unit<Dim>(random), 0};
}

/// What conservation is measured against: the size of the terms, so that their cancelling is fair.
template <int Dim>
struct Totals {
    Vector<Dim> momentum = Vector<Dim>::Zero();
    Spin<Dim> angular = Spin<Dim>::Zero();
    double momentum_size = 0;
    double angular_size = 0;

    explicit Totals(std::span<const Body<Dim>> bodies) {
        momentum = lod::momentum(bodies);
        angular = lod::angular_momentum(bodies);
        for (const Body<Dim>& body : bodies) {
            if (body.is_static()) continue;
            const double mv = body.velocity.norm() / body.inverse_mass;
            momentum_size += mv;
            angular_size += mv * body.position.norm() + body.inertia.norm() * body.spin.norm();
        }
    }
    /// The larger relative change of the two since `before`.
    [[nodiscard]] double change(const Totals& before) const {
        return std::max(
            (momentum - before.momentum).norm() / std::max(momentum_size, before.momentum_size),
            (angular - before.angular).norm() / std::max(angular_size, before.angular_size));
    }
};

enum class Normals {
    facing,  ///< within some 45 degrees of the line of the two centres, as real contacts mostly are
    escapable,  ///< any, but some motion parts all contacts at once
    wild,       ///< any; they may contradict each other
};

/// Bodies with contacts between them.
template <int Dim>
struct Crowd {
    std::vector<Body<Dim>> bodies;
    std::vector<Impact<Dim>> impacts;

    Crowd(Random& random, int body_count, int contact_count, Normals normals = Normals::escapable) {
        std::vector<Body<Dim>> parting;
        for (int i = 0; i < body_count; ++i) {
            bodies.push_back(random_body<Dim>(random));
            parting.push_back(bodies.back());
            parting.back().velocity = random_vector<Dim>(random, 2);
            parting.back().spin = random_spin<Dim>(random, 1);
        }
        for (int c = 0; c < contact_count; ++c) {
            const int a = random.below(body_count - 1);
            const int b = a + 1 + random.below(body_count - a - 1);
            const auto i = static_cast<std::size_t>(a);
            const auto k = static_cast<std::size_t>(b);
            auto contact = random_contact<Dim>(random, bodies[i].position);
            if (normals == Normals::facing) {
                contact.point += 0.5 * (bodies[k].position - bodies[i].position);
                contact.normal =
                    ((bodies[k].position - bodies[i].position).normalized() + 0.7 * contact.normal)
                        .normalized();
            }
            if (normals == Normals::escapable &&
                closing_velocity(parting[i], parting[k], contact) < 0)
                contact.normal = -contact.normal;
            impacts.push_back({a, b, a * body_count + b, contact});
        }
        std::stable_sort(impacts.begin(), impacts.end(),
                         [](const auto& x, const auto& y) { return x.pair < y.pair; });
    }
};

/// A box 2 x 1 of mass 1 that falls flat at speed 1 on `contacts` evenly spread points of the
/// floor.
template <int Dim>
Crowd<Dim> falling_box(Random& random, int contacts) {
    Crowd<Dim> crowd(random, 2, 0);
    crowd.bodies = {immovable<Dim>(), planar_body<Dim>(1, 5.0 / 12, {0, 0.5}, {0, -1})};
    for (int c = 0; c < contacts; ++c) {
        const double x = -1 + 2.0 * c / (contacts - 1);
        crowd.impacts.push_back({0, 1, 0, planar_contact<Dim>({x, 0}, {0, 1})});
    }
    return crowd;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a million random impulses keep momentum and angular momentum", "[response]",
                       ((int Dim), Dim), 2, 3) {
    Random random(41);
    double worst = 0;
    for (int crowd = 0; crowd < 1000; ++crowd) {
        std::vector<Body<Dim>> bodies{random_body<Dim>(random), random_body<Dim>(random)};
        if (crowd % 10 == 0) bodies[0].restitution = random.in(0, 1);
        for (int i = 0; i < 1000;) {
            const auto contact = random_contact<Dim>(random, bodies[0].position);
            const double j = single_impulse(bodies[0], bodies[1], contact);
            CHECK((j >= 0 && std::isfinite(j)));
            if (j == 0) continue;
            const Totals<Dim> before(bodies);
            apply_impulse(bodies[0], bodies[1], contact, j);
            worst = std::max(worst, Totals<Dim>(bodies).change(before));
            ++i;
        }
    }
    CHECK(worst <= 1e-12);
}

TEMPLATE_TEST_CASE_SIG("the net impulse keeps energy at e = 1 with 1 to 64 contacts", "[response]",
                       ((int Dim), Dim), 2, 3) {
    Random random(42);
    double worst = 0;
    Resolver<Dim> resolver;
    std::vector<double> impulses;
    for (int contacts = 1; contacts <= 64; ++contacts) {
        for (int trial = 0; trial < 150; ++trial) {
            Crowd<Dim> crowd(random, 2, contacts, trial % 4 ? Normals::escapable : Normals::wild);
            const double before = energy(crowd.bodies);
            const Totals<Dim> totals(crowd.bodies);
            resolver.resolve(Response::net, crowd.impacts, crowd.bodies, impulses);
            worst = std::max(worst, std::abs(energy(crowd.bodies) / before - 1));
            worst = std::max(worst, Totals<Dim>(crowd.bodies).change(totals));
            for (const double j : impulses) CHECK((j >= 0 && std::isfinite(j)));
        }
    }
    CHECK(worst <= 1e-12);
}

TEMPLATE_TEST_CASE_SIG("islands of many bodies keep energy and momentum at e = 1", "[response]",
                       ((int Dim), Dim), 2, 3) {
    Random random(43);
    double worst = 0;
    Resolver<Dim> resolver;
    std::vector<double> impulses;
    for (int trial = 0; trial < 3000; ++trial) {
        Crowd<Dim> crowd(random, 3 + random.below(10), 1 + random.below(40));
        const double before = energy(crowd.bodies);
        const Totals<Dim> totals(crowd.bodies);
        resolver.resolve(Response::net, crowd.impacts, crowd.bodies, impulses);
        worst = std::max(worst, std::abs(energy(crowd.bodies) / before - 1));
        worst = std::max(worst, Totals<Dim>(crowd.bodies).change(totals));
    }
    CHECK(worst <= 1e-12);
}

TEMPLATE_TEST_CASE_SIG("energy never grows below e = 1, whatever the contacts", "[response]",
                       ((int Dim), Dim), 2, 3) {
    Random random(44);
    for (int trial = 0; trial < 4000; ++trial) {
        Crowd<Dim> crowd(random, 2 + random.below(4), 1 + random.below(20),
                         static_cast<Normals>(trial % 3));
        for (auto& body : crowd.bodies) body.restitution = trial % 4 ? random.in(0, 1) : 0;
        if (random.below(3) == 0) make_static(crowd.bodies[0]);
        const double before = energy(crowd.bodies);
        resolve<Dim>(Response::net, crowd.impacts, crowd.bodies);
        CHECK(energy(crowd.bodies) <= before * (1 + 1e-13));
    }
}

TEMPLATE_TEST_CASE_SIG("after the response no contact of facing bodies approaches", "[response]",
                       ((int Dim), Dim), 2, 3) {
    Random random(45);
    Resolver<Dim> resolver;
    std::vector<double> impulses;
    for (const double restitution : {1.0, 0.5}) {
        for (int trial = 0; trial < 3000; ++trial) {
            Crowd<Dim> crowd(random, 2, 1 + random.below(64), Normals::facing);
            for (auto& body : crowd.bodies) body.restitution = restitution;
            const auto closing = [&](const Impact<Dim>& impact) {
                return -closing_velocity(crowd.bodies[0], crowd.bodies[1], impact.contact);
            };
            const ResponseReport report =
                resolver.resolve(Response::net, crowd.impacts, crowd.bodies, impulses);
            // A thousand units of rounding of speeds of some ten metres a second.
            for (const auto& impact : crowd.impacts) CHECK(closing(impact) <= 1e-11);
            if (restitution == 1) CHECK(report.most_visits <= 8);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a box that falls flat shows what sum, mean and net make of energy",
                       "[response]", ((int Dim), Dim), 2, 3) {
    struct Row {
        int contacts;
        double sum, mean;
    };
    Random random(50);
    // A 2 x 1 box falling flat at speed 1, e = 1, to three digits.
    for (const Row& row : {Row{2, 0.031, 0.170},
                           {3, 4.74, 0.0035},
                           {4, 11.1, 0.0070},
                           {16, 357, 0.059},
                           {64, 6516, 0.077}}) {
        const auto ratio = [&](Response response) {
            Crowd<Dim> crowd = falling_box<Dim>(random, row.contacts);
            resolve<Dim>(response, crowd.impacts, crowd.bodies);
            return energy(crowd.bodies) / 0.5;
        };
        const auto printed_as = [](double value, double printed) {
            const double digit = printed >= 100    ? 1
                                 : printed >= 10   ? 0.1
                                 : printed >= 1    ? 0.01
                                 : printed >= 0.01 ? 0.001
                                                   : 0.0001;
            return std::abs(value - printed) <= 0.5 * digit;
        };
        INFO(row.contacts << " contacts: sum " << ratio(Response::sum) << ", mean "
                          << ratio(Response::mean));
        CHECK(printed_as(ratio(Response::sum), row.sum));
        CHECK(printed_as(ratio(Response::mean), row.mean));
        CHECK(std::abs(ratio(Response::net) - 1) <= 1e-12);
    }
}

TEMPLATE_TEST_CASE_SIG("every response keeps momentum and angular momentum", "[response]",
                       ((int Dim), Dim), 2, 3) {
    Random random(53);
    for (int trial = 0; trial < 200; ++trial) {
        const Crowd<Dim> crowd(random, 2 + random.below(3), 1 + random.below(12), Normals::facing);
        for (const Response response :
             {Response::net, Response::sum, Response::mean, Response::sequential, Response::lcp,
              Response::reflections}) {
            auto bodies = crowd.bodies;
            resolve<Dim>(response, crowd.impacts, bodies);
            CHECK(Totals<Dim>(bodies).change(Totals<Dim>(crowd.bodies)) <= 1e-12);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("only the sum of impulses ever adds energy", "[response]", ((int Dim), Dim),
                       2, 3) {
    Random random(54);
    for (int trial = 0; trial < 300; ++trial) {
        Crowd<Dim> crowd(random, 2, 1 + random.below(12), Normals::facing);
        crowd.bodies[0].restitution = trial % 2 ? random.in(0, 1) : 1;
        const double before = energy(crowd.bodies);
        for (const Response response :
             {Response::mean, Response::sequential, Response::lcp, Response::reflections}) {
            auto bodies = crowd.bodies;
            resolve<Dim>(response, crowd.impacts, bodies);
            CHECK(energy(bodies) <= before * (1 + 1e-9));
        }
    }
}

TEMPLATE_TEST_CASE_SIG("references bounce a box that falls flat with the energy that it had",
                       "[response]", ((int Dim), Dim), 2, 3) {
    Random random(55);
    for (const int contacts : {2, 3, 4, 16, 64}) {
        const Crowd<Dim> crowd = falling_box<Dim>(random, contacts);
        for (const Response response :
             {Response::sequential, Response::lcp, Response::reflections}) {
            auto bodies = crowd.bodies;
            resolve<Dim>(response, crowd.impacts, bodies);
            CHECK(std::abs(energy(bodies) / 0.5 - 1) <= 1e-9);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a static body takes any impulse and stays where it is", "[response]",
                       ((int Dim), Dim), 2, 3) {
    Random random(46);
    for (const Response response : {Response::net, Response::sum, Response::mean}) {
        Crowd<Dim> crowd(random, 4, 20);
        make_static(crowd.bodies[1]);
        make_static(crowd.bodies[2]);
        const Vector<Dim> place = crowd.bodies[1].position;
        const auto impulses = resolve<Dim>(response, crowd.impacts, crowd.bodies);
        CHECK(crowd.bodies[1].velocity.isZero(0));
        CHECK(crowd.bodies[1].spin.isZero(0));
        CHECK(crowd.bodies[1].position == place);
        for (std::size_t i = 0; i < impulses.size(); ++i)
            if (crowd.impacts[i].a == 1 && crowd.impacts[i].b == 2) CHECK(impulses[i] == 0);
    }
}

TEMPLATE_TEST_CASE_SIG("parting bodies get no impulse", "[response]", ((int Dim), Dim), 2, 3) {
    const Body<Dim> a = planar_body<Dim>(1, 1, {-1, 0}, {-1, 0});
    const Body<Dim> b = planar_body<Dim>(1, 1, {1, 0}, {-1, 0});  // at rest to each other
    const Body<Dim> c = planar_body<Dim>(1, 1, {1, 0}, {2, 0});
    const Contact<Dim> contact = planar_contact<Dim>({0, 0}, {1, 0});
    CHECK(single_impulse(a, b, contact) == 0);
    CHECK(single_impulse(a, c, contact) == 0);
    for (const Response response : {Response::net, Response::sum, Response::mean}) {
        std::vector<Body<Dim>> bodies{a, c};
        const auto impulses = resolve<Dim>(response, {{0, 1, 0, contact}}, bodies);
        CHECK(impulses == std::vector<double>{0});
        CHECK(bodies[0].velocity == a.velocity);
    }
}

TEMPLATE_TEST_CASE_SIG("an island does not see what happens on another", "[response]",
                       ((int Dim), Dim), 2, 3) {
    Random random(47);
    for (int trial = 0; trial < 50; ++trial) {
        const Crowd<Dim> one(random, 3, 8);
        const Crowd<Dim> two(random, 4, 9);
        std::vector<Body<Dim>> alone = one.bodies;
        const auto impulses_alone = resolve<Dim>(Response::net, one.impacts, alone);

        std::vector<Body<Dim>> both = one.bodies;
        both.insert(both.end(), two.bodies.begin(), two.bodies.end());
        std::vector<Impact<Dim>> impacts = one.impacts;
        for (auto [a, b, pair, contact] : two.impacts)
            impacts.push_back({a + 3, b + 3, 100 + pair, contact});
        const auto impulses = resolve<Dim>(Response::net, impacts, both);
        for (std::size_t i = 0; i < alone.size(); ++i) {
            CHECK(both[i].velocity == alone[i].velocity);  // to the last bit
            CHECK(both[i].spin == alone[i].spin);
        }
        for (std::size_t i = 0; i < impulses_alone.size(); ++i)
            CHECK(impulses[i] == impulses_alone[i]);
    }
}

TEMPLATE_TEST_CASE_SIG("the order of the contacts changes nothing but rounding", "[response]",
                       ((int Dim), Dim), 2, 3) {
    Random random(48);
    for (int trial = 0; trial < 100; ++trial) {
        Crowd<Dim> crowd(random, 3, 12);
        std::vector<Body<Dim>> other = crowd.bodies;
        resolve<Dim>(Response::net, crowd.impacts, crowd.bodies);
        std::reverse(crowd.impacts.begin(), crowd.impacts.end());
        resolve<Dim>(Response::net, crowd.impacts, other);
        for (std::size_t i = 0; i < other.size(); ++i) {
            CHECK((other[i].velocity - crowd.bodies[i].velocity).norm() < 1e-11);
            CHECK((other[i].spin - crowd.bodies[i].spin).norm() < 1e-11);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a row of sixty hands its impulse on to its end", "[response]",
                       ((int Dim), Dim), 2, 3) {
    for (const bool backwards : {false, true}) {
        constexpr int count = 60;
        std::vector<Body<Dim>> bodies;
        std::vector<Impact<Dim>> impacts;
        for (int i = 0; i < count; ++i) bodies.push_back(planar_body<Dim>(1, 1, {2.0 * i, 0}));
        bodies[0].velocity = planar<Dim>(1, 0);
        for (int i = 0; i + 1 < count; ++i)
            impacts.push_back({i, i + 1, i, planar_contact<Dim>({2.0 * i + 1, 0}, {1, 0})});
        if (backwards) std::reverse(impacts.begin(), impacts.end());
        resolve<Dim>(Response::net, impacts, bodies);
        CHECK(energy(bodies) == Approx(0.5).epsilon(1e-12));
        CHECK(bodies.back().velocity[0] == Approx(1).epsilon(1e-12));
    }
}

TEMPLATE_TEST_CASE_SIG("a resolver may be used again for fewer and for more bodies", "[response]",
                       ((int Dim), Dim), 2, 3) {
    Random random(49);
    Resolver<Dim> resolver;
    for (const int count : {2, 9, 3, 20}) {
        Crowd<Dim> crowd(random, count, 2 * count);
        std::vector<Body<Dim>> fresh = crowd.bodies;
        std::vector<double> impulses;
        resolver.resolve(Response::net, crowd.impacts, crowd.bodies, impulses);
        CHECK(impulses == resolve<Dim>(Response::net, crowd.impacts, fresh));
        for (std::size_t i = 0; i < fresh.size(); ++i)
            CHECK(fresh[i].velocity == crowd.bodies[i].velocity);
    }
    std::vector<double> impulses{1, 2, 3};
    std::vector<Body<Dim>> none;
    resolver.resolve(Response::net, {}, none, impulses);
    CHECK(impulses.empty());
}
