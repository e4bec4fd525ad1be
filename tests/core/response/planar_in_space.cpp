// What happens in the plane happens in space just so: the same circles as spheres, the same fronts
// test for test, and every response's velocities to 1e-12. Planar motion is lifted into space; no
// case is written down twice.

#include <cmath>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

constexpr double equal = 1e-12;

const Response all_responses[] = {Response::net,        Response::sum, Response::mean,
                                  Response::sequential, Response::lcp, Response::reflections};

Vector<3> lifted(const Vector<2>& v) {
    return {v.x(), v.y(), 0};
}

std::shared_ptr<const SphereTree<3>> lifted(const SphereTree<2>& tree) {
    std::vector<TreeNode<3>> nodes;
    for (int i = 0; i < tree.size(); ++i) {
        const Sphere<2> circle = tree.sphere(i);
        nodes.push_back({{lifted(circle.centre), circle.radius}, lifted(tree.mean_normal(i)), {}});
        for (int c = 0; c < tree.child_count[tree.index(i)]; ++c)
            nodes.back().children.push_back(tree.first_child[tree.index(i)] + c);
    }
    return std::make_shared<SphereTree<3>>(lay_out<3>(std::span<const TreeNode<3>>(nodes)));
}

/// The same body in the plane z = 0. Moments about x and y play no part there.
Body<3> lifted(const Body<2>& flat) {
    Body<3> body;
    if (!flat.is_static()) {
        const double inertia = flat.inertia(0, 0);
        set_mass<3>(body, 1 / flat.inverse_mass,
                    Vector<3>(0.6 * inertia, 0.7 * inertia, inertia).asDiagonal());
    }
    body.restitution = flat.restitution;
    body.position = lifted(flat.position);
    body.orientation = Space<3>::turned(Space<3>::unturned(), {0, 0, flat.orientation});
    body.velocity = lifted(flat.velocity);
    body.spin = {0, 0, flat.spin[0]};
    if (flat.tree) body.tree = lifted(*flat.tree);
    return body;
}

std::vector<Body<3>> lifted(const std::vector<Body<2>>& flat) {
    std::vector<Body<3>> bodies;
    for (const Body<2>& body : flat) bodies.push_back(lifted(body));
    return bodies;
}

/// How far the bodies' places and motions differ, as a share of the largest number among them: an
/// impact hands rounding on from body to body.
double difference(const std::vector<Body<2>>& flat, const std::vector<Body<3>>& deep) {
    double worst = 0;
    double largest = 1;
    for (std::size_t i = 0; i < flat.size(); ++i) {
        const auto compare = [&](const auto& planar, const auto& spatial) {
            worst = std::max(worst, (spatial - planar).cwiseAbs().maxCoeff());
            largest = std::max(largest, planar.cwiseAbs().maxCoeff());
        };
        compare(lifted(flat[i].position), deep[i].position);
        compare(lifted(flat[i].velocity), deep[i].velocity);
        compare(Vector<3>(0, 0, flat[i].spin[0]), deep[i].spin);
        compare(Space<3>::rotation(lifted(flat[i]).orientation),
                Space<3>::rotation(deep[i].orientation));
    }
    return worst / largest;
}

/// Random planar bodies with random trees, moving towards the middle, so that many meet.
std::vector<Body<2>> crowd(Random& random, int count, double reach) {
    std::vector<Body<2>> bodies;
    for (int i = 0; i < count; ++i) {
        bodies.push_back(random_body<2>(random));
        Body<2>& body = bodies.back();
        body.restitution = random.below(2) ? 1 : random.in(0, 1);
        body.position *= reach / 2;
        body.velocity -= body.position;
        body.tree = random_tree<2>(random, 1 + random.below(2), 4, random.in(0.4, 1.2));
    }
    if (count > 2) make_static(bodies.front());
    return bodies;
}

template <int Dim>
const FrameRecord<Dim>& run(std::vector<Body<Dim>>& bodies, const FrameSettings& settings,
                            Budget budget, FrameStorage<Dim>& storage) {
    return advance<Dim>(bodies, settings, budget, storage);
}

/// Contacts that contradict each other, of bodies deep within each other, keep the references going
/// for up to thousands of rounds, and rounding grows with each. Such frames compare fronts only.
bool settles(const FrameStorage<2>& storage) {
    return storage.record.response.most_visits <= 20;
}

/// The same pairs, levels, verdicts, tests and node pairs.
bool same_fronts(const FrameRecord<2>& flat, const FrameRecord<3>& deep) {
    return std::equal(flat.pairs.begin(), flat.pairs.end(), deep.pairs.begin(), deep.pairs.end(),
                      [](const PairRecord& p, const PairRecord& q) {
                          return p.bodies == q.bodies && p.level == q.level &&
                                 p.verdict == q.verdict && p.tests == q.tests &&
                                 p.contact_count == q.contact_count;
                      }) &&
           flat.node_pairs == deep.node_pairs && flat.tests == deep.tests &&
           flat.interrupted() == deep.interrupted();
}

/// One contact, or one row of them, of bodies in the plane.
struct Case {
    const char* name;
    std::vector<Body<2>> bodies;
    std::vector<Impact<2>> impacts;
};

/// The exact cases of METHOD.md, by number.
std::vector<Case> exact_cases() {
    const auto one = [](Planar point, Planar normal) {
        return std::vector<Impact<2>>{{0, 1, 0, planar_contact<2>(point, normal)}};
    };
    const double across = std::sqrt(3.0);
    const double share = 1 / across;
    const auto square = planar_body<2>(1, 1.0 / 6, {0, 0.5}, {0, -1});
    return {
        {"1",
         {planar_body<2>(1, 1, {-1, 0}, {2, 0}), planar_body<2>(3, 1, {1, 0}, {-1, 0})},
         one({0, 0}, {1, 0})},
        {"2",
         {disc<2>(1, 1, {0, 0}, {1, 0}), disc<2>(1, 1, {across, 1})},
         one({across / 2, 0.5}, {across / 2, 0.5})},
        {"3",
         {planar_body<2>(1, 1, {1, -0.5}, {0, 1}), planar_body<2>(1, 1.0 / 3)},
         one({1, 0}, {0, 1})},
        {"3, M 2",
         {planar_body<2>(1, 1, {share, -0.5}, {0, 1}), planar_body<2>(2, 2.0 / 3)},
         one({share, 0}, {0, 1})},
        {"4, 0.25", {immovable<2>(), square}, one({0.25, 0}, {0, 1})},
        {"4, 1/sqrt 6", {immovable<2>(), square}, one({1 / std::sqrt(6.0), 0}, {0, 1})},
        {"4, 0.5", {immovable<2>(), square}, one({0.5, 0}, {0, 1})},
        {"5",
         {planar_body<2>(1, 1.0 / 6, {0, 0}, {1, 0}, 2),
          planar_body<2>(2, 1.0 / 3, {1.3, 0.1}, {-0.5, 0.2}, -1)},
         one({0.6, 0.3}, {1, 0})},
        {"6",
         {planar_body<2>(1, 1.0 / 6, {0, 0}, {2, 0}), planar_body<2>(1, 1.0 / 6, {1, 0.4})},
         one({0.5, 0.2}, {1, 0})},
        {"7",
         {disc<2>(1, 1, {0, 0}, {1, 0}), disc<2>(1, 1, {2, 0}), disc<2>(1, 1, {4, 0})},
         {{0, 1, 0, planar_contact<2>({1, 0}, {1, 0})},
          {1, 2, 1, planar_contact<2>({3, 0}, {1, 0})}}},
        {"8",
         {disc<2>(1, 1, {0, 0}, {1, 0}), disc<2>(1, 1, {across, 1}), disc<2>(1, 1, {across, -1})},
         {{0, 1, 0, planar_contact<2>({across / 2, 0.5}, {across / 2, 0.5})},
          {0, 2, 1, planar_contact<2>({across / 2, -0.5}, {across / 2, -0.5})}}},
    };
}

}  // namespace

TEST_CASE("the exact cases come out in space as in the plane, by every response", "[planar]") {
    for (const Case& of : exact_cases())
        for (const Response response : all_responses)
            for (const double restitution : {1.0, 0.5}) {
                INFO("case " << of.name << ", response " << static_cast<int>(response));
                auto flat = of.bodies;
                for (Body<2>& body : flat) body.restitution = restitution;
                auto deep = lifted(flat);
                std::vector<Impact<3>> impacts;
                for (const auto& [a, b, pair, contact] : of.impacts)
                    impacts.push_back(
                        {a, b, pair, {lifted(contact.point), lifted(contact.normal), 0}});
                const auto before = flat;
                const auto j = resolve<2>(response, of.impacts, flat);
                const auto j_in_space = resolve<3>(response, impacts, deep);
                REQUIRE(j.size() == j_in_space.size());
                for (std::size_t i = 0; i < j.size(); ++i)
                    CHECK(std::abs(j[i] - j_in_space[i]) <= equal * std::max(1.0, j[i]));
                CHECK(difference(flat, deep) <= equal);
                CHECK(difference(before, deep) > 0.01);  // something happened
            }
}

TEST_CASE("random frames of two bodies are the plane's in space, whatever is set", "[planar]") {
    Random random(2101);
    FrameStorage<2> flat_storage;
    FrameStorage<3> deep_storage;
    std::size_t contacts = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const auto start = crowd(random, 2, 1.5);
        FrameSettings settings;
        settings.point_model = static_cast<PointModel>(trial % 2);
        settings.contact_model = static_cast<ContactModel>(trial / 2 % 2);
        for (const Response response : all_responses) {
            settings.response = response;
            auto flat = start;
            auto deep = lifted(start);
            INFO("trial " << trial << ", response " << static_cast<int>(response));
            const auto& in_plane = run<2>(flat, settings, Budget::unlimited(), flat_storage);
            const auto& in_space = run<3>(deep, settings, Budget::unlimited(), deep_storage);
            CHECK(same_fronts(in_plane, in_space));
            if (!settles(flat_storage)) continue;
            CHECK(difference(flat, deep) <= equal);
            contacts += in_plane.impacts.size();
        }
    }
    CHECK(contacts > 300);
}

TEST_CASE("random frames of many bodies are the plane's in space, by every response", "[planar]") {
    Random random(2102);
    FrameStorage<2> flat_storage;
    FrameStorage<3> deep_storage;
    std::size_t contacts = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const auto start = crowd(random, 3 + random.below(5), 2.5);
        FrameSettings settings;
        settings.contact_model = static_cast<ContactModel>(trial % 2);
        settings.response = all_responses[trial % 6];
        auto flat = start;
        auto deep = lifted(start);
        INFO("trial " << trial << " by " << trial % 6);
        const auto& in_plane = run<2>(flat, settings, Budget::unlimited(), flat_storage);
        const auto& in_space = run<3>(deep, settings, Budget::unlimited(), deep_storage);
        CHECK(same_fronts(in_plane, in_space));
        if (!settles(flat_storage)) continue;
        CHECK(difference(flat, deep) <= equal);
        contacts += in_plane.impacts.size();
    }
    CHECK(contacts > 150);
}

TEST_CASE("a budget ends in space after the very test after which it ends in the plane",
          "[planar]") {
    Random random(2103);
    FrameStorage<2> flat_storage;
    FrameStorage<3> deep_storage;
    int interrupted = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const auto flat = crowd(random, 2 + random.below(3), 1);
        const auto deep = lifted(flat);
        Budget unlimited = Budget::unlimited();
        const std::uint64_t all = detect<2>(flat, {}, unlimited, flat_storage).tests;
        for (std::uint64_t quota = 0; quota <= all; quota += 1 + all / 300) {
            Budget flat_budget = Budget::node_tests(quota, 2);
            Budget deep_budget = Budget::node_tests(quota, 2);
            const auto& in_plane = detect<2>(flat, {}, flat_budget, flat_storage);
            const auto& in_space = detect<3>(deep, {}, deep_budget, deep_storage);
            INFO("trial " << trial << ", quota " << quota);
            CHECK(same_fronts(in_plane, in_space));
            interrupted += in_plane.interrupted();
        }
    }
    CHECK(interrupted > 100);
}
