// The method's promise (section 3): a detection that is interrupted anywhere stands where its last
// finished level stood, and never calls bodies apart that touch.

#include <initializer_list>
#include <memory>
#include <string>

#include "core/frame.hpp"
#include "core/state_hash.hpp"
#include "lod2d/build_tree.hpp"
#include "lod2d/generators.hpp"
#include "lod2d/overlap.hpp"
#include "tests/catch.hpp"
#include "tests/random.hpp"

using namespace lod;
using lodtest::Random;

namespace {

struct Model {
    lod2d::Shape shape;
    std::shared_ptr<const SphereTree<2>> tree;
};

/// Real shapes, convex and not, with holes and without, each with the trees of these builders.
std::vector<Model> make_models(int depth, std::initializer_list<lod2d::Builder> builders) {
    std::vector<Model> models;
    for (const char* spec :
         {"box",      "rod",     "triangle", "disc:24", "ring:0.7", "L",        "U",
          "cross",    "star:5",  "star:9",   "gear:7",  "arrow",    "crescent", "comb:5",
          "spiral:2", "capsule", "blob:1",   "blob:17", "blob:23",  "blob:99",  "box:2,0.3"}) {
        const lod2d::Shape shape = lod2d::generate(spec);
        for (const lod2d::Builder builder : builders) {
            lod2d::TreeSettings settings;
            settings.builder = builder;
            settings.depth = depth;
            models.push_back(
                {shape, std::make_shared<SphereTree<2>>(lod2d::build_tree(shape, settings))});
        }
    }
    return models;
}

Body<2> placed(Random& random, const Model& model, double reach) {
    Body<2> body;
    set_mass<2>(body, model.shape.area, Inertia<2>::Constant(model.shape.second_moment));
    body.position = {random.in(-reach, reach), random.in(-reach, reach)};
    body.orientation = random.in(-3, 3);
    body.velocity = {random.in(-2, 2), random.in(-2, 2)};
    body.spin[0] = random.in(-3, 3);
    body.tree = model.tree;
    return body;
}

class Pair {
  public:
    Pair(const Model& a, const Model& b, Random& random)
        : start_{placed(random, a, 0.1), placed(random, b, 1.1)},
          touching_(lod2d::overlap(a.shape, {start_[0].position, start_[0].orientation}, b.shape,
                                   {start_[1].position, start_[1].orientation})) {}

    [[nodiscard]] bool touching() const { return touching_; }

    const FrameRecord<2>& find(Budget budget, int deepest, FrameStorage<2>& storage) const {
        FrameSettings settings;
        settings.deepest_level = deepest;
        return detect<2>(start_, settings, budget, storage);
    }
    /// The state after a whole frame: detection, response, integration.
    std::uint64_t step(Budget budget, int deepest, FrameStorage<2>& storage) const {
        std::vector<Body<2>> bodies = start_;
        FrameSettings settings;
        settings.deepest_level = deepest;
        advance<2>(bodies, settings, budget, storage);
        return state_hash<2>(bodies);
    }

  private:
    std::vector<Body<2>> start_;
    bool touching_;
};

/// Everything that the response is made from: contacts are equal to the last bit.
bool same_finding(const FrameRecord<2>& cut, const FrameRecord<2>& whole) {
    const auto same_contact = [](const Impact<2>& x, const Impact<2>& y) {
        return x.contact.point == y.contact.point && x.contact.normal == y.contact.normal &&
               x.contact.depth == y.contact.depth;
    };
    return cut.pairs[0].level == whole.pairs[0].level &&
           cut.pairs[0].verdict == whole.pairs[0].verdict && cut.node_pairs == whole.node_pairs &&
           std::equal(cut.impacts.begin(), cut.impacts.end(), whole.impacts.begin(),
                      whole.impacts.end(), same_contact);
}

struct Count {
    int touching = 0;
    int apart = 0;
    int refuted_late = 0;  ///< apart, but seen only below level 0
    std::uint64_t budgets = 0;
};

/// What detection finds when it may go on to each level in turn; empty where the broad phase
/// already says apart.
std::vector<FrameRecord<2>> find_levels(const Pair& pair, FrameStorage<2>& storage) {
    std::vector<FrameRecord<2>> levels;
    for (int level = 0; level < 20; ++level) {
        const FrameRecord<2>& record = pair.find(Budget::unlimited(), level, storage);
        if (record.pairs.empty() || record.pairs[0].level < level) break;
        levels.push_back(record);
    }
    return levels;
}

/// Every budget from 0 to the full number of tests; `count` gathers what was met.
void check_every_budget(const Pair& pair, FrameStorage<2>& storage, Count& count) {
    const auto levels = find_levels(pair, storage);
    count.touching += pair.touching();
    count.apart += !pair.touching();
    if (levels.empty()) {
        REQUIRE_FALSE(pair.touching());
        return;
    }

    bool sound = true;
    bool exact = true;
    std::size_t last = 0;
    std::uint64_t state = 0;
    const std::uint64_t all = levels.back().tests;
    for (std::uint64_t quota = 0; quota <= all; ++quota) {
        const bool finishes = last + 1 < levels.size() && levels[last + 1].tests <= quota;
        if (finishes) ++last;
        const auto& record = pair.find(Budget::node_tests(quota), 1000, storage);
        exact &= same_finding(record, levels[last]);
        sound &= !(pair.touching() && record.pairs[0].verdict == Verdict::apart);
        // The rest of a frame follows from what was found; once a level it is run as well, and
        // once more where the next level lacks a single test.
        if (quota == 0 || finishes)
            state = pair.step(Budget::unlimited(), static_cast<int>(last), storage);
        if (quota == 0 || finishes ||
            (last + 1 < levels.size() && levels[last + 1].tests == quota + 1))
            exact &= pair.step(Budget::node_tests(quota), 1000, storage) == state;
    }
    CHECK(exact);
    CHECK(sound);
    count.budgets += all + 1;
    count.refuted_late += levels.size() > 1 && levels.back().pairs[0].verdict == Verdict::apart;
}

Count check_pairs(const std::vector<Model>& models, int pairs, std::uint64_t seed) {
    Count count;
    FrameStorage<2> storage;
    for (int trial = 0; trial < pairs; ++trial) {
        Random random(seed + static_cast<std::uint64_t>(trial));
        const auto pick = [&]() -> const Model& {
            return models[static_cast<std::size_t>(random.below(static_cast<int>(models.size())))];
        };
        const Model& a = pick();
        const Model& b = pick();
        Pair pair(a, b, random);
        INFO("pair " << trial << " of seed " << seed << ": " << a.shape.name << ", "
                     << b.shape.name);
        check_every_budget(pair, storage, count);
    }
    return count;
}

}  // namespace

TEST_CASE("a thousand pairs interrupted after every test stand at their last finished level",
          "[interruption]") {
    const Count count =
        check_pairs(make_models(3, {lod2d::Builder::quadtree, lod2d::Builder::pieces}), 1000, 1000);
    // All kinds of pairs were met.
    CHECK(count.touching > 300);
    CHECK(count.apart > 300);
    CHECK(count.refuted_late > 100);
}

TEST_CASE("deep trees interrupted after every test stand at their last finished level",
          "[interruption]") {
    const Count count = check_pairs(make_models(5, {lod2d::Builder::quadtree}), 20, 5000);
    CHECK(count.touching > 5);
}
