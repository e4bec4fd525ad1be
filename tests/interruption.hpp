#pragma once

// The method's promise (section 3), for the plane and for space: a detection that is interrupted
// anywhere stands where its last finished level stood, and never calls bodies apart that touch.
// What differs between the two, the shapes and the oracle, their tests hand over.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "lodlab/core/frame/frame.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

namespace lodtest {

/// A body at rest at the origin, with its tree.
template <int Dim>
struct Model {
    std::string name;
    lod::Body<Dim> body;
};

/// Whether two models' true shapes, where the bodies stand, share a point: boundaries that meet, or
/// one shape wholly inside the other. An oracle that knows nothing of trees.
template <int Dim>
using Touching = std::function<bool(std::size_t model_a, const lod::Body<Dim>& a,
                                    std::size_t model_b, const lod::Body<Dim>& b)>;

/// A random position within `reach` along every axis, turned and moving at random.
template <int Dim>
lod::Body<Dim> placed(Random& random, lod::Body<Dim> body, double reach) {
    body.position = random_vector<Dim>(random, reach);
    body.orientation =
        lod::Space<Dim>::turned(lod::Space<Dim>::unturned(), random_spin<Dim>(random, 3));
    body.velocity = random_vector<Dim>(random, 2);
    body.spin = random_spin<Dim>(random, 3);
    return body;
}

/// Two bodies at an instant, and whether they touch.
template <int Dim>
struct Meeting {
    std::vector<lod::Body<Dim>> bodies;
    bool touching = false;

    const lod::FrameRecord<Dim>& find(lod::Budget budget, int deepest,
                                      lod::FrameStorage<Dim>& storage) const {
        lod::FrameSettings settings;
        settings.deepest_level = deepest;
        return lod::detect<Dim>(bodies, settings, budget, storage);
    }
    /// The state after a whole frame: detection, response, integration.
    std::uint64_t step(lod::Budget budget, int deepest, lod::FrameStorage<Dim>& storage) const {
        std::vector<lod::Body<Dim>> moved = bodies;
        lod::FrameSettings settings;
        settings.deepest_level = deepest;
        lod::advance<Dim>(moved, settings, budget, storage);
        return lod::state_hash<Dim>(moved);
    }
};

/// Everything that the response is made from: contacts are equal to the last bit.
template <int Dim>
bool same_finding(const lod::FrameRecord<Dim>& cut, const lod::FrameRecord<Dim>& whole) {
    const auto same_contact = [](const lod::Impact<Dim>& x, const lod::Impact<Dim>& y) {
        return x.contact.point == y.contact.point && x.contact.normal == y.contact.normal &&
               x.contact.depth == y.contact.depth;
    };
    return cut.pairs[0].level == whole.pairs[0].level &&
           cut.pairs[0].verdict == whole.pairs[0].verdict && cut.node_pairs == whole.node_pairs &&
           std::equal(cut.impacts.begin(), cut.impacts.end(), whole.impacts.begin(),
                      whole.impacts.end(), same_contact);
}

/// What was met.
struct Count {
    int touching = 0;
    int apart = 0;
    int refuted_late = 0;  ///< apart, but seen only below level 0
    std::uint64_t budgets = 0;
};

/// What detection finds when it may go on to each level in turn; empty where the broad phase
/// already says apart.
template <int Dim>
std::vector<lod::FrameRecord<Dim>> find_levels(const Meeting<Dim>& pair,
                                               lod::FrameStorage<Dim>& storage) {
    std::vector<lod::FrameRecord<Dim>> levels;
    for (int level = 0; level < 20; ++level) {
        const lod::FrameRecord<Dim>& record = pair.find(lod::Budget::unlimited(), level, storage);
        if (record.pairs.empty() || record.pairs[0].level < level) break;
        levels.push_back(record);
    }
    return levels;
}

/// Every budget from nothing to the full number of tests; where those are more than `most`, the
/// budgets around the end of every level and `most` others, spread evenly.
template <int Dim>
std::set<std::uint64_t> quotas(const std::vector<lod::FrameRecord<Dim>>& levels,
                               std::uint64_t most) {
    const std::uint64_t all = levels.back().tests;
    const std::uint64_t stride = 1 + all / (most + 1);
    std::set<std::uint64_t> result;
    for (std::uint64_t quota = 0; quota <= all; quota += stride) result.insert(quota);
    for (const auto& level : levels)
        for (const std::uint64_t quota : {level.tests - 1, level.tests, level.tests + 1})
            if (quota <= all) result.insert(quota);
    return result;
}

/// At every budget the result is that of the last level which it could finish, to the last bit, and
/// a true collision is never called apart.
template <int Dim>
void check_interruptions(const Meeting<Dim>& pair, lod::FrameStorage<Dim>& storage, Count& count,
                         std::uint64_t most_budgets = 1'000'000) {
    const auto levels = find_levels(pair, storage);
    count.touching += pair.touching;
    count.apart += !pair.touching;
    if (levels.empty()) {
        REQUIRE_FALSE(pair.touching);
        return;
    }
    bool sound = true;
    bool exact = true;
    std::size_t last = 0;
    std::uint64_t state = 0;
    for (const std::uint64_t quota : quotas(levels, most_budgets)) {
        bool finishes = quota == 0;
        for (; last + 1 < levels.size() && levels[last + 1].tests <= quota; finishes = true) ++last;
        const auto& record = pair.find(lod::Budget::node_tests(quota), 1000, storage);
        exact &= same_finding(record, levels[last]);
        sound &= !(pair.touching && record.pairs[0].verdict == lod::Verdict::apart);
        // The rest of a frame follows from what was found; once a level it is run as well, and
        // once more where the next level lacks a single test.
        if (finishes) state = pair.step(lod::Budget::unlimited(), static_cast<int>(last), storage);
        if (finishes || (last + 1 < levels.size() && levels[last + 1].tests == quota + 1))
            exact &= pair.step(lod::Budget::node_tests(quota), 1000, storage) == state;
        ++count.budgets;
    }
    CHECK(exact);
    CHECK(sound);
    count.refuted_late +=
        levels.size() > 1 && levels.back().pairs[0].verdict == lod::Verdict::apart;
}

/// Random pairs of the models: the first near the origin, the second within `reach` of it.
template <int Dim>
Count check_pairs(const std::vector<Model<Dim>>& models, const Touching<Dim>& touching, int pairs,
                  std::uint64_t seed, double reach, std::uint64_t most_budgets = 1'000'000) {
    Count count;
    lod::FrameStorage<Dim> storage;
    for (int trial = 0; trial < pairs; ++trial) {
        Random random(seed + static_cast<std::uint64_t>(trial));
        const auto a = static_cast<std::size_t>(random.below(static_cast<int>(models.size())));
        const auto b = static_cast<std::size_t>(random.below(static_cast<int>(models.size())));
        Meeting<Dim> pair;
        pair.bodies.push_back(placed<Dim>(random, models[a].body, 0.1));
        pair.bodies.push_back(placed<Dim>(random, models[b].body, reach));
        pair.touching = touching(a, pair.bodies[0], b, pair.bodies[1]);
        INFO("pair " << trial << " of seed " << seed << ": " << models[a].name << ", "
                     << models[b].name);
        check_interruptions(pair, storage, count, most_budgets);
    }
    return count;
}

}  // namespace lodtest
