// A frame whose parts an executor does: no bit depends on which.
#include "lodlab/core/base/executor.hpp"

#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/core/math/bit_hash.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/core/executors.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// A crowd of so many bodies and pairs (but for a smaller one) that each stage has several parts: a
/// few trees, some bodies that stand, two walls.
template <int Dim>
std::vector<Body<Dim>> crowd(std::size_t count = 600) {
    const double room = Space<Dim>::Vector::Zero().size() == 2 ? 8 : 3;
    Random random(311);
    std::vector<std::shared_ptr<const SphereTree<Dim>>> trees;
    for (int i = 0; i < 5; ++i)
        trees.push_back(random_tree<Dim>(random, 3, 4, random.in(0.3, 0.6)));
    std::vector<Body<Dim>> bodies;
    for (std::size_t i = 0; i < count; ++i) {
        bodies.push_back(random_body<Dim>(random));
        bodies.back().position = random_vector<Dim>(random, room);
        bodies.back().velocity *= 4;
        bodies.back().tree = trees[i % trees.size()];
        if (i % 50 == 0) make_static(bodies.back());
    }
    for (const double side : {-1.0, 1.0}) {
        bodies.push_back(immovable<Dim>());
        bodies.back().tree = std::make_shared<SphereTree<Dim>>(
            half_space<Dim>(Vector<Dim>(-side * Vector<Dim>::Unit(0))));
        bodies.back().position = side * 3 * Vector<Dim>::Unit(0);
    }
    return bodies;
}

void add(const Range& range, BitHash& hash) {
    hash.add(range.first);
    hash.add(range.count);
}

template <int Dim>
void add(const Contact<Dim>& contact, BitHash& hash) {
    hash.add(contact.point);
    hash.add(contact.normal);
    hash.add(contact.depth);
}

/// Of all that a frame found and did, but for times.
template <int Dim>
std::uint64_t hash_of(const FrameRecord<Dim>& record) {
    BitHash hash;
    for (const PairRecord& pair : record.pairs) {
        for (const std::int32_t number :
             {pair.bodies.a, pair.bodies.b, std::int32_t{pair.level},
              static_cast<std::int32_t>(pair.verdict), pair.first_contact, pair.contact_count,
              static_cast<std::int32_t>(pair.finest)})
            hash.add(number);
        hash.add(pair.tests);
        add(pair.nodes, hash);
        hash.add(pair.impact_time);
    }
    for (const NodePair& nodes : record.node_pairs) add({nodes.a, nodes.b}, hash);
    for (const Impact<Dim>& impact : record.impacts) {
        for (const std::int32_t number : {impact.a, impact.b, impact.pair}) hash.add(number);
        add(impact.contact, hash);
    }
    for (const Range& range : record.contact_nodes) add(range, hash);
    hash.add_all(record.impulses);
    for (const SweptImpact<Dim>& swept : record.swept) {
        hash.add(swept.time);
        add(swept.contact, hash);
        hash.add(swept.impulse);
    }
    const LevelCounts& levels = record.spending.levels;
    for (const std::uint64_t number :
         {record.tests, record.reserved_row_visits, record.response.row_visits, levels.finished,
          levels.skipped, levels.dropped, record.spending.tests_left.value_or(0)})
        hash.add(number);
    hash.add(record.energy_before);
    hash.add(record.energy_after);
    return hash.value();
}

/// Of each frame of a short run: its record and the bodies after it.
template <int Dim>
std::vector<std::uint64_t> hashes(std::vector<Body<Dim>> bodies, const FrameSettings& settings,
                                  std::optional<std::uint64_t> quota, Executor* executor,
                                  int frames = 2) {
    FrameStorage<Dim> storage;
    storage.executor = executor;
    std::vector<std::uint64_t> result;
    for (int frame = 0; frame < frames; ++frame) {
        Budget budget = quota ? Budget::node_tests(*quota, 2.0) : Budget::unlimited();
        const FrameRecord<Dim>& record = advance<Dim>(bodies, settings, budget, storage);
        CHECK(record.impacts.size() > 100);
        CHECK(record.interrupted() == quota.has_value());
        result.push_back(hash_of(record));
        result.push_back(state_hash<Dim>(bodies));
    }
    return result;
}

constexpr std::optional<std::uint64_t> quotas[] = {std::nullopt, 20000};

}  // namespace

TEMPLATE_TEST_CASE_SIG("a frame has the same bits however many workers do its parts", "[executor]",
                       ((int Dim), Dim), 2, 3) {
    const auto bodies = crowd<Dim>();
    for (const std::optional<std::uint64_t>& quota : quotas) {
        const auto expected = hashes(bodies, {}, quota, nullptr, 4);
        for (const int workers : {1, 2, 3, 7, 16}) {
            CAPTURE(quota.has_value(), workers);
            ShuffledExecutor executor(workers);
            CHECK(hashes(bodies, {}, quota, &executor, 4) == expected);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("and by any policy", "[executor]", ((int Dim), Dim), 2, 3) {
    const auto bodies = crowd<Dim>();
    for (const Priority priority : choices<Priority>())
        for (const std::optional<std::uint64_t>& quota : quotas) {
            const FrameSettings settings{.priority = priority};
            const auto expected = hashes(bodies, settings, quota, nullptr);
            for (const int workers : {2, 16}) {
                CAPTURE(name_of(priority), quota.has_value(), workers);
                ShuffledExecutor executor(workers);
                CHECK(hashes(bodies, settings, quota, &executor) == expected);
                CHECK(executor.parts() > 100);
            }
        }
}

TEMPLATE_TEST_CASE_SIG("and with any contact model, organisation or response", "[executor]",
                       ((int Dim), Dim), 2, 3) {
    const auto bodies = crowd<Dim>();
    std::vector<FrameSettings> choice(1);
    for (const ContactModel model : choices<ContactModel>())
        choice.push_back({.contact_model = model});
    for (const Response response : {Response::sequential, Response::sum})
        choice.push_back({.response = response});
    choice.push_back({.organisation = Organisation::stored});
    for (const FrameSettings& settings : choice)
        for (const std::optional<std::uint64_t>& quota : quotas) {
            ShuffledExecutor executor(3);
            CHECK(hashes(bodies, settings, quota, &executor, 1) ==
                  hashes(bodies, settings, quota, nullptr, 1));
        }
}

TEMPLATE_TEST_CASE_SIG("and where fast bodies are swept", "[executor]", ((int Dim), Dim), 2, 3) {
    const auto bodies = crowd<Dim>(200);
    const FrameSettings settings{.time_step = 1.0 / 30, .sweep = {.on = true, .deepest_level = 1}};
    constexpr std::optional<std::uint64_t> smaller[] = {std::nullopt, 2000};
    for (const std::optional<std::uint64_t>& quota : smaller) {
        ShuffledExecutor executor(3);
        CHECK(hashes(bodies, settings, quota, &executor, 1) ==
              hashes(bodies, settings, quota, nullptr, 1));
    }
}

TEMPLATE_TEST_CASE_SIG("and where the workers are threads", "[executor]", ((int Dim), Dim), 2, 3) {
    const auto bodies = crowd<Dim>();
    for (const std::optional<std::uint64_t>& quota : quotas)
        for (const int workers : {2, 5}) {
            ThreadedExecutor executor(workers);
            CHECK(hashes(bodies, {}, quota, &executor) == hashes(bodies, {}, quota, nullptr));
        }
}

TEMPLATE_TEST_CASE_SIG("a storage may change its executor between two frames", "[executor]",
                       ((int Dim), Dim), 2, 3) {
    auto bodies = crowd<Dim>();
    auto alone = bodies;
    FrameStorage<Dim> storage;
    FrameStorage<Dim> storage_alone;
    ShuffledExecutor many(7);
    ShuffledExecutor few(2);
    for (Executor* executor : {static_cast<Executor*>(&many), static_cast<Executor*>(nullptr),
                               static_cast<Executor*>(&few)}) {
        storage.executor = executor;
        Budget budget = Budget::node_tests(20000, 2.0);
        Budget budget_alone = budget;
        const auto& record = advance<Dim>(bodies, {}, budget, storage);
        CHECK(hash_of(record) == hash_of(advance<Dim>(alone, {}, budget_alone, storage_alone)));
    }
    CHECK(state_hash<Dim>(bodies) == state_hash<Dim>(alone));
}

TEST_CASE("an executor that is not there, or has one worker, is handed no part", "[executor]") {
    ShuffledExecutor one(1);
    static_cast<void>(hashes(crowd<2>(), {}, std::nullopt, &one));
    CHECK(one.parts() == 0);
}
