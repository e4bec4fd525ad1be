#include "lodlab/core/frame/frame.hpp"

#include "lodlab/core/frame/state_hash.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/core/frame/clock.hpp"
#include "tests/core/frame/heap.hpp"

using namespace lod;
using namespace lodtest;
using namespace std::chrono_literals;

namespace {

template <int Dim>
std::uint64_t hash_of(const std::vector<Body<Dim>>& bodies) {
    return state_hash<Dim>(bodies);
}

template <int Dim>
FrameRecord<Dim> step(std::vector<Body<Dim>>& bodies, Budget budget, FrameSettings settings = {}) {
    FrameStorage<Dim> storage;
    return advance<Dim>(bodies, settings, budget, storage);
}

template <int Dim>
bool same_finding(const FrameRecord<Dim>& x, const FrameRecord<Dim>& y) {
    return std::equal(x.pairs.begin(), x.pairs.end(), y.pairs.begin(), y.pairs.end(),
                      [](const PairRecord& p, const PairRecord& q) {
                          return p.bodies == q.bodies && p.level == q.level &&
                                 p.verdict == q.verdict && p.contact_count == q.contact_count;
                      }) &&
           x.node_pairs == y.node_pairs && x.impulses == y.impulses;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a frame records every stage", "[frame]", ((int Dim), Dim), 2, 3) {
    auto bodies = heap<Dim>(81);
    const double before = energy(bodies);
    const auto record = step(bodies, Budget::unlimited());
    REQUIRE(record.pairs.size() > 3);
    REQUIRE(record.impacts.size() > 3);
    CHECK(record.contact_nodes.size() == record.impacts.size());
    CHECK(record.impulses.size() == record.impacts.size());
    CHECK(record.energy_before == before);
    CHECK(record.energy_after == Approx(before).epsilon(1e-12));
    CHECK_FALSE(record.interrupted());

    std::uint64_t tests = 0;
    std::int32_t contacts = 0;
    for (std::size_t p = 0; p < record.pairs.size(); ++p) {
        const PairRecord& pair = record.pairs[p];
        tests += pair.tests;
        CHECK(pair.first_contact == contacts);
        contacts += pair.contact_count;
        CHECK((pair.verdict == Verdict::apart) == (pair.nodes.count == 0));
        for (std::int32_t c = pair.first_contact; c < contacts; ++c) {
            const Impact<Dim>& impact = record.impacts[static_cast<std::size_t>(c)];
            CHECK(impact.a == pair.bodies.a);
            CHECK(impact.b == pair.bodies.b);
            CHECK(impact.pair == static_cast<std::int32_t>(p));
            CHECK(std::abs(impact.contact.normal.norm() - 1) < 1e-15);
            CHECK(impact.contact.depth >= 0);
            CHECK(record.contact_nodes[static_cast<std::size_t>(c)].count > 0);
        }
    }
    CHECK(contacts == static_cast<std::int32_t>(record.impacts.size()));
    CHECK(record.tests == tests);
}

TEMPLATE_TEST_CASE_SIG("a frame's contacts are those of the contact model that it was given",
                       "[frame]", ((int Dim), Dim), 2, 3) {
    const auto bodies = heap<Dim>(88);
    FrameSettings settings;
    for (const ContactModel model :
         {ContactModel::centre_line, ContactModel::node_normal, ContactModel::hull}) {
        settings.contact_model = model;
        FrameStorage<Dim> storage;
        Budget budget = Budget::unlimited();
        const auto& record = detect<Dim>(bodies, settings, budget, storage);
        REQUIRE(record.impacts.size() > 3);
        for (std::size_t p = 0; p < record.pairs.size(); ++p) {
            const PairRecord& pair = record.pairs[p];
            const auto expected =
                contacts_of_front<Dim>(bodies[static_cast<std::size_t>(pair.bodies.a)],
                                       bodies[static_cast<std::size_t>(pair.bodies.b)],
                                       storage.fronts.front(p), {model}, settings.time_step);
            REQUIRE(expected.size() == static_cast<std::size_t>(pair.contact_count));
            for (std::size_t c = 0; c < expected.size(); ++c) {
                const std::size_t place = static_cast<std::size_t>(pair.first_contact) + c;
                CHECK(record.impacts[place].contact.normal == expected[c].normal);
                CHECK(record.impacts[place].contact.point == expected[c].point);
            }
        }
    }
}

TEMPLATE_TEST_CASE_SIG("detection changes no body", "[frame]", ((int Dim), Dim), 2, 3) {
    const auto bodies = heap<Dim>(82);
    const auto before = hash_of(bodies);
    FrameStorage<Dim> storage;
    Budget budget = Budget::unlimited();
    const auto& record = detect<Dim>(bodies, {}, budget, storage);
    CHECK(hash_of(bodies) == before);
    CHECK(record.energy_after == record.energy_before);
    for (const double j : record.impulses) CHECK(j == 0);
}

TEMPLATE_TEST_CASE_SIG("level 0 of every pair is done even with nothing to spend", "[frame]",
                       ((int Dim), Dim), 2, 3) {
    auto bodies = heap<Dim>(83);
    auto other = bodies;
    FrameSettings roots_only;
    roots_only.deepest_level = 0;
    const auto broke = step(bodies, Budget::node_tests(0));
    const auto record = step(other, Budget::unlimited(), roots_only);
    CHECK(broke.interrupted());
    CHECK_FALSE(record.interrupted());
    CHECK(broke.tests == broke.pairs.size());
    for (const PairRecord& pair : broke.pairs) CHECK(pair.level == 0);
    CHECK(same_finding(broke, record));
    CHECK(hash_of(bodies) == hash_of(other));
}

TEMPLATE_TEST_CASE_SIG("a level cut short leaves no trace in the frame's result", "[frame]",
                       ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> start{planar_body<Dim>(1, 0.4, {0, 0}, {1, 0}, 0.5),
                                 planar_body<Dim>(2, 0.7, {1.3, 0.2}, {-1, 0.1}, -0.3)};
    start[0].tree = box_tree<Dim>(2, 1, 3);
    start[1].tree = box_tree<Dim>(1.5, 1, 3);
    for (std::uint64_t quota = 0;; ++quota) {
        auto cut = start;
        auto whole = start;
        const auto record = step(cut, Budget::node_tests(quota));
        FrameSettings settings;
        settings.deepest_level = record.pairs.at(0).level;
        CHECK(same_finding(record, step(whole, Budget::unlimited(), settings)));
        CHECK(hash_of(cut) == hash_of(whole));
        if (!record.interrupted()) {
            CHECK(record.pairs[0].level == 3);
            break;
        }
    }
}

TEMPLATE_TEST_CASE_SIG("tests and contacts together never cost more than the quota", "[frame]",
                       ((int Dim), Dim), 2, 3) {
    const auto start = heap<Dim>(84);
    const double contact_cost = 3.5;
    int reached = 0;
    bool before_complete = true;
    for (std::uint64_t quota = 0; before_complete; quota += 1 + quota / 20) {
        auto bodies = start;
        const auto record = step(bodies, Budget::node_tests(quota, contact_cost));
        int deepest = 0;
        for (const PairRecord& pair : record.pairs) deepest = std::max(deepest, pair.level);
        const double cost = static_cast<double>(record.tests) +
                            contact_cost * static_cast<double>(record.impacts.size());
        if (deepest > 0) CHECK(cost <= static_cast<double>(quota));
        reached = std::max(reached, deepest);
        before_complete = record.interrupted();
    }
    CHECK(reached == 3);
}

TEMPLATE_TEST_CASE_SIG("a frame that ran on a clock is repeated from its record", "[frame]",
                       ((int Dim), Dim), 2, 3) {
    const auto start = heap<Dim>(85);
    int interrupted = 0;
    for (const auto contact_cost : {0ns, 40ns}) {
        for (auto quota = 0ns; quota < 6000ns; quota += 19ns) {
            FakeClock clock;
            clock.step = 13ns;
            auto first = start;
            const auto record = step(first, Budget::deadline(clock, quota, contact_cost));
            auto again = start;
            const auto repeated =
                step(again, record.cut ? Budget::until(*record.cut) : Budget::unlimited());
            CHECK(hash_of(again) == hash_of(first));
            CHECK(same_finding(record, repeated));
            CHECK(repeated.tests == record.tests);
            CHECK(repeated.cut == record.cut);
            interrupted += record.interrupted();
        }
    }
    CHECK(interrupted > 20);
}

TEMPLATE_TEST_CASE_SIG("a budget cut short goes to the pair that closes fastest", "[frame]",
                       ((int Dim), Dim), 2, 3) {
    const auto tree = box_tree<Dim>(1, 1, 3);
    std::vector<Body<Dim>> bodies;
    for (const double speed : {1.0, 3.0, 2.0}) {
        const double y = 10 * speed;
        bodies.push_back(planar_body<Dim>(1, 1, {0, y}, {speed, 0}));
        bodies.push_back(planar_body<Dim>(1, 1, {0.9, y}));
        bodies[bodies.size() - 1].tree = bodies[bodies.size() - 2].tree = tree;
    }
    auto again = bodies;
    const auto level_of = [](const FrameRecord<Dim>& record, std::int32_t a) {
        for (const PairRecord& pair : record.pairs)
            if (pair.bodies.a == a) return pair.level;
        return -1;
    };
    // Three roots, and one family of 4 x 4 for a single pair.
    const auto record = step(bodies, Budget::node_tests(3 + 16));
    CHECK(level_of(record, 2) == 1);
    CHECK(level_of(record, 0) == 0);
    CHECK(level_of(record, 4) == 0);

    FrameSettings in_order;
    in_order.priority = Priority::level_order;
    const auto by_number = step(again, Budget::node_tests(3 + 16), in_order);
    CHECK(level_of(by_number, 0) == 1);
    CHECK(level_of(by_number, 2) == 0);
}

TEMPLATE_TEST_CASE_SIG("storage from another scene changes no result", "[frame]", ((int Dim), Dim),
                       2, 3) {
    FrameStorage<Dim> used;
    for (const int count : {15, 4, 9}) {
        auto bodies = heap<Dim>(86 + static_cast<std::uint64_t>(count), count);
        auto other = bodies;
        for (int frame = 0; frame < 20; ++frame) {
            FrameStorage<Dim> fresh;
            Budget one = Budget::node_tests(300);
            Budget two = Budget::node_tests(300);
            advance<Dim>(bodies, {}, one, used);
            advance<Dim>(other, {}, two, fresh);
        }
        CHECK(hash_of(bodies) == hash_of(other));
    }
}

TEMPLATE_TEST_CASE_SIG("a closed system keeps momentum and energy frame after frame", "[frame]",
                       ((int Dim), Dim), 2, 3) {
    auto bodies = heap<Dim>(87);
    Random random(87);
    const Body<Dim> moving = random_body<Dim>(random);
    bodies[0].inverse_mass = moving.inverse_mass;
    bodies[0].inertia = moving.inertia;
    bodies[0].inverse_inertia = moving.inverse_inertia;
    const double energy_before = energy(bodies);
    const Vector<Dim> momentum_before = momentum<Dim>(bodies);
    const Spin<Dim> angular_before = angular_momentum<Dim>(bodies);
    FrameStorage<Dim> storage;
    std::size_t contacts = 0;
    for (int frame = 0; frame < 300; ++frame) {
        Budget budget = Budget::node_tests(500);
        contacts += advance<Dim>(bodies, {}, budget, storage).impacts.size();
    }
    CHECK(contacts > 300);
    CHECK(energy(bodies) == Approx(energy_before).epsilon(1e-11));
    CHECK((momentum<Dim>(bodies) - momentum_before).norm() < 1e-11);
    CHECK((angular_momentum<Dim>(bodies) - angular_before).norm() < 1e-10);
}

TEST_CASE("frames in space repeat the frames of the plane", "[frame]") {
    const auto scene = []<int Dim>(std::integral_constant<int, Dim>) {
        std::vector<Body<Dim>> bodies{planar_body<Dim>(1, 0.4, {-1.5, 0}, {1, 0}, 0.5),
                                      planar_body<Dim>(2, 0.7, {1.3, 0.2}, {-1, 0.1}, -0.3),
                                      disc<Dim>(1.5, 0.6, {0.2, 2}, {0, -1.5})};
        bodies[0].tree = box_tree<Dim>(2, 1, 3);
        bodies[1].tree = box_tree<Dim>(1.5, 1, 3);
        return bodies;
    };
    auto flat = scene(std::integral_constant<int, 2>());
    auto deep = scene(std::integral_constant<int, 3>());
    FrameStorage<2> flat_storage;
    FrameStorage<3> deep_storage;
    std::size_t contacts = 0;
    for (int frame = 0; frame < 100; ++frame) {
        Budget flat_budget = Budget::unlimited();
        Budget deep_budget = Budget::unlimited();
        const auto& flat_record = advance<2>(flat, {}, flat_budget, flat_storage);
        const auto& deep_record = advance<3>(deep, {}, deep_budget, deep_storage);
        REQUIRE(flat_record.node_pairs == deep_record.node_pairs);
        contacts += flat_record.impacts.size();
    }
    CHECK(contacts > 2);
    for (std::size_t i = 0; i < flat.size(); ++i) {
        CHECK((in_plane(deep[i].position) - flat[i].position).norm() < 1e-12);
        CHECK((in_plane(deep[i].velocity) - flat[i].velocity).norm() < 1e-12);
        CHECK(std::abs(planar_spin(deep[i]) - planar_spin(flat[i])) < 1e-12);
    }
}
