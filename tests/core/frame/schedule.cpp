#include "lodlab/core/frame/schedule.hpp"

#include <limits>

#include "lodlab/core/frame/state_hash.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/core/frame/clock.hpp"
#include "tests/core/frame/heap.hpp"
#include "tests/core/frame/policies.hpp"

using namespace lod;
using namespace lodtest;
using namespace std::chrono_literals;

namespace {

/// Pairs of equal boxes that overlap, each pair far from the others, the boxes of the sizes given.
template <int Dim>
std::vector<Body<Dim>> couples(std::initializer_list<double> sizes, int depth = 3) {
    std::vector<Body<Dim>> bodies;
    double y = 0;
    for (const double size : sizes) {
        const auto tree = box_tree<Dim>(size, size, depth);
        y += 4 * size;
        for (const double x : {0.0, 0.9 * size}) {
            bodies.push_back(planar_body<Dim>(1, 1, {x, y}));
            bodies.back().tree = tree;
        }
    }
    return bodies;
}

/// Goes on by 30 ns a look, and at every so many looks by 2 us: the machine did something else.
class HaltingClock final : public Clock {
  public:
    explicit HaltingClock(int halt) : halt_(halt) {}
    std::chrono::nanoseconds now() const override {
        return time_ += ++looks_ % halt_ == 0 ? 2000ns : 30ns;
    }

  private:
    int halt_;
    mutable int looks_ = 0;
    mutable std::chrono::nanoseconds time_{};
};

template <int Dim>
std::vector<int> levels_of(const FrameRecord<Dim>& record) {
    std::vector<int> levels;
    for (const PairRecord& pair : record.pairs) levels.push_back(pair.level);
    return levels;
}

/// The levels that pairs reach with so many tests, by a policy.
template <int Dim>
std::vector<int> levels_with(const std::vector<Body<Dim>>& bodies, Priority priority,
                             std::uint64_t tests) {
    FrameStorage<Dim> storage;
    Budget budget = Budget::node_tests(tests);
    return levels_of(detect<Dim>(bodies, {.priority = priority}, budget, storage));
}

/// Whether every front is that of the pair alone at the same level.
template <int Dim>
bool fronts_are_whole(const std::vector<Body<Dim>>& bodies, const FrameStorage<Dim>& storage,
                      const std::vector<std::vector<Front>>& alone) {
    for (std::size_t p = 0; p < storage.candidates.size(); ++p) {
        const ListedFront& front = storage.fronts.of_pair[p];
        const Front& whole = alone[p][static_cast<std::size_t>(front.level)];
        const auto pairs = storage.fronts.pairs(p);
        if (!std::equal(pairs.begin(), pairs.end(), whole.pairs.begin(), whole.pairs.end()) ||
            front.verdict != whole.verdict || front.finest != whole.finest)
            return false;
        // What overlaps at the leaves is never called apart.
        if (front.verdict == Verdict::apart && alone[p].back().verdict != Verdict::apart)
            return false;
    }
    return !bodies.empty();
}

template <int Dim>
std::vector<std::vector<Front>> levels_alone(const std::vector<Body<Dim>>& bodies,
                                             const std::vector<CandidatePair>& candidates) {
    std::vector<std::vector<Front>> alone;
    for (const CandidatePair& pair : candidates)
        alone.push_back(traverse_levels(bodies[at(pair.a)], bodies[at(pair.b)]));
    return alone;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the cost of a level is known before it is begun", "[schedule]",
                       ((int Dim), Dim), 2, 3) {
    int compared = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Random random(seed);
        std::vector<Body<Dim>> bodies;
        for (int i = 0; i < 2; ++i) {
            bodies.push_back(random_body<Dim>(random));
            bodies.back().position *= 0.3;
            bodies.back().tree = random_tree<Dim>(random, 4, 5);
        }
        const std::vector<Front> levels = traverse_levels(bodies[0], bodies[1]);
        for (std::size_t k = 0; k + 1 < levels.size(); ++k, ++compared)
            REQUIRE(next_level_tests(*bodies[0].tree, *bodies[1].tree, levels[k].pairs) ==
                    levels[k + 1].tests - levels[k].tests);
    }
    CHECK(compared > 200);
}

TEMPLATE_TEST_CASE_SIG("each policy puts levels in its order", "[schedule]", ((int Dim), Dim), 2,
                       3) {
    // A small pair and a large one; the first level of either is one family of 4 x 4 tests.
    const auto bodies = couples<Dim>({1, 3});
    const std::uint64_t roots = 2;
    CHECK(levels_with(bodies, Priority::level_order, roots + 16) == std::vector{1, 0});
    CHECK(levels_with(bodies, Priority::level_order, roots + 32) == std::vector{1, 1});
    CHECK(levels_with(bodies, Priority::best_gain, roots + 16) == std::vector{0, 1});
    CHECK(levels_with(bodies, Priority::trade, roots + 16) == std::vector{0, 1});
    CHECK(levels_with(bodies, Priority::first_come, roots + 16) == std::vector{1, 0});
    const auto alone = traverse_levels(bodies[0], bodies[1]);
    CHECK(levels_with(bodies, Priority::first_come, alone[2].tests + 1) == std::vector{2, 0});
    CHECK(levels_with(bodies, Priority::first_come, alone[2].tests + 1 + 16) == std::vector{2, 1});
}

TEMPLATE_TEST_CASE_SIG("a level that does not fit is skipped, and a cheaper one done", "[schedule]",
                       ((int Dim), Dim), 2, 3) {
    // The first pair has 5 children a node, the second 4.
    auto bodies = couples<Dim>({1, 1});
    std::vector<TreeNode<Dim>> nodes(6);
    nodes[0].sphere.radius = 1;
    for (int child = 1; child < 6; ++child) {
        nodes[0].children.push_back(child);
        nodes[static_cast<std::size_t>(child)].sphere.radius = 0.5;
    }
    bodies[0].tree = bodies[1].tree =
        std::make_shared<SphereTree<Dim>>(lay_out<Dim>(std::span<const TreeNode<Dim>>(nodes)));
    for (const Priority priority : {Priority::level_order, Priority::first_come}) {
        FrameStorage<Dim> storage;
        Budget budget = Budget::node_tests(2 + 24);
        const auto& record = detect<Dim>(bodies, {.priority = priority}, budget, storage);
        CHECK(levels_of(record) == std::vector{0, 1});
        CHECK(record.tests == 2 + 16);
        CHECK(record.interrupted());
        CHECK(record.spending.levels.finished == 1);
        CHECK(record.spending.levels.skipped == 2);
        CHECK(record.spending.levels.dropped == 0);
        CHECK(record.spending.tests_left == 8U);
    }
}

TEMPLATE_TEST_CASE_SIG("what a policy decides is whose level comes first, not what a level says",
                       "[schedule]", ((int Dim), Dim), 2, 3) {
    const auto bodies = heap<Dim>(301);
    FrameStorage<Dim> storage;
    Budget unlimited = Budget::unlimited();
    detect<Dim>(bodies, {}, unlimited, storage);
    const auto alone = levels_alone(bodies, storage.candidates);
    std::uint64_t all = 0;
    for (const auto& levels : alone) all += levels.back().tests;
    Random random(302);
    for (const Priority priority : policies)
        for (int trial = 0; trial < 150; ++trial) {
            const auto quota = static_cast<std::uint64_t>(random.below(static_cast<int>(all) + 1));
            Budget budget = Budget::node_tests(quota, trial % 3 * 2.5);
            const auto& record = detect<Dim>(bodies, {.priority = priority}, budget, storage);
            REQUIRE(fronts_are_whole(bodies, storage, alone));
            REQUIRE((record.tests <= quota || record.spending.levels.finished == 0));
            const auto pair = random.below(static_cast<int>(alone.size()));
            const auto tests = static_cast<std::uint64_t>(random.below(40));
            Budget until = Budget::until({pair, 1 + random.below(3), tests, {}});
            detect<Dim>(bodies, {.priority = priority}, until, storage);
            REQUIRE(fronts_are_whole(bodies, storage, alone));
        }
}

TEMPLATE_TEST_CASE_SIG("a frame that the clock cut anywhere is repeated under every policy",
                       "[schedule]", ((int Dim), Dim), 2, 3) {
    const auto start = heap<Dim>(303, 20);
    int counted = 0;
    int ended = 0;
    for (const Priority priority : policies)
        for (const int halt : {1000, 5, 2})
            for (auto quota = 0ns; quota < 9000ns; quota += 67ns) {
                const auto organisation = static_cast<Organisation>(quota.count() % 2);
                const FrameSettings settings{.priority = priority, .organisation = organisation};
                const HaltingClock clock(halt);
                std::vector<Body<Dim>> first = start;
                std::vector<Body<Dim>> again = start;
                FrameStorage<Dim> live;
                FrameStorage<Dim> replayed;
                for (int frame = 0; frame < 3; ++frame) {  // trade remembers
                    // Where time is reserved, entry levels and contacts end before levels do.
                    Budget budget = Budget::deadline(clock, quota, frame == 1 ? 20ns : 0ns);
                    const auto& record = advance<Dim>(first, settings, budget, live);
                    Budget until = record.cut ? Budget::until(*record.cut) : Budget::unlimited();
                    const auto& repeated = advance<Dim>(again, settings, until, replayed);
                    REQUIRE(state_hash<Dim>(again) == state_hash<Dim>(first));
                    REQUIRE(levels_of(repeated) == levels_of(record));
                    REQUIRE(repeated.tests == record.tests);
                    REQUIRE(repeated.cut == record.cut);
                    counted += record.cut && record.cut->counted ? 1 : 0;
                    ended += record.cut && record.cut->pair >= 0 ? 1 : 0;
                }
            }
    CAPTURE(counted, ended);
    CHECK(counted > 50);
    CHECK(ended > 10);
}

TEMPLATE_TEST_CASE_SIG("a policy of one's own gives the value of each level", "[schedule]",
                       ((int Dim), Dim), 2, 3) {
    const auto bodies = couples<Dim>({1, 1, 1});
    FrameStorage<Dim> storage;
    std::vector<int> asked(3);
    storage.scheduler.own_value = [&](const LevelOffer<Dim>& offer) {
        ++asked[at(offer.pair)];
        CHECK(offer.level == 1);
        CHECK(offer.tests == 16);
        CHECK(offer.error_fall > 0);
        CHECK(offer.a.position.y() == offer.b.position.y());
        if (offer.pair == 0) return std::numeric_limits<double>::quiet_NaN();
        return offer.a.position.y();  // the highest
    };
    Budget budget = Budget::node_tests(3 + 16);
    CHECK(levels_of(detect<Dim>(bodies, {.deepest_level = 1}, budget, storage)) ==
          std::vector{0, 0, 1});
    Budget two = Budget::node_tests(3 + 32);
    CHECK(levels_of(detect<Dim>(bodies, {.deepest_level = 1}, two, storage)) ==
          std::vector{0, 1, 1});
    CHECK(asked == std::vector{2, 2, 2});
}

TEMPLATE_TEST_CASE_SIG("without a limit no policy changes a bit", "[schedule]", ((int Dim), Dim), 2,
                       3) {
    const auto start = heap<Dim>(304);
    std::vector<std::uint64_t> hashes;
    for (const Priority priority : policies) {
        auto bodies = start;
        FrameStorage<Dim> storage;
        for (int frame = 0; frame < 20; ++frame) {
            Budget budget = Budget::unlimited();
            advance<Dim>(bodies, {.priority = priority}, budget, storage);
        }
        hashes.push_back(state_hash<Dim>(bodies));
    }
    for (const std::uint64_t hash : hashes) CHECK(hash == hashes.front());
}

TEST_CASE("policies keep the names that they had", "[schedule]") {
    CHECK(named<Priority>("in_order") == Priority::level_order);
    for (const Priority priority : policies) CHECK(named<Priority>(name_of(priority)) == priority);
    CHECK_FALSE(named<Priority>("alphabetical"));
}

TEMPLATE_TEST_CASE_SIG("a level costs the heap no more than the logarithm of what waits",
                       "[schedule]", ((int Dim), Dim), 2, 3) {
    // By count: a policy of one's own is asked once for each level offered, none twice.
    for (const int pairs : {8, 16, 32}) {
        std::vector<Body<Dim>> bodies;
        for (int i = 0; i < pairs; ++i)
            for (const double x : {0.0, 0.9}) {
                bodies.push_back(planar_body<Dim>(1, 1, {x, 4.0 * i}));
                bodies.back().tree = box_tree<Dim>(1, 1, 2);
            }
        FrameStorage<Dim> storage;
        int asked = 0;
        storage.scheduler.own_value = [&](const LevelOffer<Dim>&) { return ++asked, 0.0; };
        Budget budget = Budget::node_tests(1'000'000);
        const auto& record = detect<Dim>(bodies, {}, budget, storage);
        CHECK(record.spending.levels.finished == static_cast<std::uint64_t>(2 * pairs));
        CHECK(asked == 2 * pairs);
    }
}

TEMPLATE_TEST_CASE_SIG("stored levels are answered as interleaved ones where there is enough",
                       "[schedule]", ((int Dim), Dim), 2, 3) {
    const auto bodies = heap<Dim>(305);
    for (const Priority priority : policies)
        for (const Budget& enough :
             {Budget::unlimited(), Budget::node_tests(1'000'000, 3.0), Budget::node_tests(500)}) {
            auto one = bodies;
            auto other = bodies;
            FrameStorage<Dim> storage;
            Budget budget = enough;
            advance<Dim>(one, {.priority = priority}, budget, storage);
            FrameStorage<Dim> stored;
            Budget again = enough;
            advance<Dim>(other, {.priority = priority, .organisation = Organisation::stored}, again,
                         stored);
            CHECK(state_hash<Dim>(one) == state_hash<Dim>(other));
        }
}

TEMPLATE_TEST_CASE_SIG("stored levels keep the quota, are whole, and play again", "[schedule]",
                       ((int Dim), Dim), 2, 3) {
    const auto bodies = heap<Dim>(306, 20);
    FrameStorage<Dim> storage;
    Budget unlimited = Budget::unlimited();
    detect<Dim>(bodies, {}, unlimited, storage);
    const auto alone = levels_alone(bodies, storage.candidates);
    std::uint64_t at_entry = 0;
    for (const auto& levels : alone) at_entry += levels[0].pairs.size();
    FrameStorage<Dim> replayed;
    int answered = 0;
    int deeper = 0;
    for (const Priority priority : policies)
        for (std::uint64_t quota = 0; quota < 6000; quota += 171) {
            const FrameSettings settings{.priority = priority,
                                         .organisation = Organisation::stored};
            Budget budget = Budget::node_tests(quota, 10);
            const FrameRecord<Dim> record = detect<Dim>(bodies, settings, budget, storage);
            REQUIRE(fronts_are_whole(bodies, storage, alone));
            std::uint64_t node_pairs = 0;
            for (const ListedFront& front : storage.fronts.of_pair)
                node_pairs += static_cast<std::uint64_t>(front.pairs.count);
            int deepest = 0;
            for (const PairRecord& pair : record.pairs) deepest = std::max(deepest, pair.level);
            // A level that proves pairs apart is answered even beyond.
            REQUIRE((record.tests + 10 * node_pairs <= quota || node_pairs <= at_entry));
            answered += record.cut && record.cut->answered ? 1 : 0;
            deeper += deepest > 0 ? 1 : 0;
            Budget again = record.cut ? Budget::until(*record.cut) : Budget::unlimited();
            const auto& repeated = detect<Dim>(bodies, settings, again, replayed);
            REQUIRE(repeated.cut == record.cut);
            REQUIRE(levels_of(repeated) == levels_of(record));
        }
    CHECK(answered > 10);
    CHECK(deeper > 10);
}

TEMPLATE_TEST_CASE_SIG("a frame tells the turns of its levels in their order", "[schedule]",
                       ((int Dim), Dim), 2, 3) {
    const std::vector<Body<Dim>> bodies = couples<Dim>({1, 0.5, 0.7});
    std::uint64_t dropped = 0;
    std::uint64_t skipped = 0;
    for (std::uint64_t quota = 0; quota < 3000; quota += 53) {
        FrameStorage<Dim> storage;
        Budget budget = Budget::node_tests(quota, 3);
        const FrameRecord<Dim>& record = detect<Dim>(bodies, {}, budget, storage);
        std::vector<int> levels(record.pairs.size(), -1);
        LevelCounts counts;
        std::uint64_t tests = 0;
        for (const Turn& turn : record.turns) {
            int& level = levels[at(turn.pair)];
            if (level >= 0) CHECK(turn.level == level + 1);
            level = turn.end == TurnEnd::finished ? turn.level : turn.level - 1;
            if (turn.end != TurnEnd::skipped) tests += turn.tests;
            ++(turn.end == TurnEnd::finished  ? counts.finished
               : turn.end == TurnEnd::dropped ? counts.dropped
                                              : counts.skipped);
        }
        for (std::size_t p = 0; p < levels.size(); ++p)
            if (levels[p] >= 0) CHECK(record.pairs[p].level == levels[p]);
        CHECK(counts.finished == record.spending.levels.finished);
        CHECK(counts.dropped == record.spending.levels.dropped);
        CHECK(counts.skipped <= record.spending.levels.skipped);
        CHECK(tests <= record.tests);
        dropped += counts.dropped;
        skipped += counts.skipped;
    }
    CHECK(dropped > 0);
    CHECK(skipped > 0);
}

TEST_CASE("a frame without a limit has no turns", "[schedule]") {
    const std::vector<Body<2>> bodies = couples<2>({1, 0.5});
    FrameStorage<2> storage;
    Budget quota = Budget::node_tests(1000000);
    CHECK_FALSE(detect<2>(bodies, {}, quota, storage).turns.empty());
    Budget none = Budget::unlimited();
    CHECK(detect<2>(bodies, {}, none, storage).turns.empty());
}
