#include "lodlab/measure/crowd/quota.hpp"

#include <cmath>

#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"
#include "tests/catch.hpp"

using measure::QuotaOutcome;

namespace {

constexpr auto priorities = lod::choices<lod::Priority>();

measure::QuotaOutcomes tried(const std::vector<lod::Body<2>>& bodies, std::vector<double> shares,
                             std::int64_t frames, const lod::FrameSettings& settings = {}) {
    measure::QuotaPlan<2> plan;
    plan.bodies = bodies;
    plan.settings = settings;
    plan.settings.time_step = 1.0 / 60;
    plan.frames = frames;
    plan.shares = std::move(shares);
    plan.priorities.assign(priorities.begin(), priorities.end());
    return measure::try_quotas(plan);
}

/// With trees that are built quickly.
scenes::Scene shallow_crowd() {
    scenes::Scene scene = scenes::crowd("implode:60");
    for (scenes::BodySpec& body : scene.bodies) body.depth = 3;
    return scene;
}

const std::vector<lod::Body<2>>& crowd() {
    static const std::vector<lod::Body<2>> bodies = scenes::set_up<2>(shallow_crowd()).bodies;
    return bodies;
}

/// Two boxes of 1 m and 1 kg that pass each other at 1 m/s and a gap of 0.1 m, and `away` [m] along
/// x two discs that meet head-on.
std::vector<lod::Body<2>> two_couples(double away) {
    const lod2d::Shape square = lod2d::generate("box:1,1");
    const auto tree = std::make_shared<const lod::SphereTree<2>>(lod2d::build_tree(square));
    const auto disc = std::make_shared<const lod::SphereTree<2>>(
        lod::single_sphere<2>({lod::Vector<2>::Zero(), 0.5}));
    const auto body = [&](const auto& of, double x, double y, double speed) {
        lod::Body<2> made;
        lod::set_mass<2>(made, 1, lod::Inertia<2>::Constant(1.0 / 6));
        made.tree = of;
        made.position = {x, y};
        made.velocity = {speed, 0};
        return made;
    };
    return {body(tree, 0, 0, 1), body(tree, 0.5, 1.1, -1), body(disc, away, 0, 1),
            body(disc, away + 0.99, 0, -1)};
}

}  // namespace

TEST_CASE("a quota of all tests that the dearest frame needs makes no error") {
    for (const auto& of_share : tried(crowd(), {1}, 60).of_priority) {
        CHECK(of_share[0].error == 0);
        CHECK(of_share[0].cut == 0);
    }
}

TEST_CASE("a smaller quota makes larger errors, at lower levels, in more frames") {
    const auto outcomes = tried(crowd(), {0.02, 0.1, 0.5}, 60);
    REQUIRE(outcomes.of_priority.size() == priorities.size());
    for (const std::vector<QuotaOutcome>& rows : outcomes.of_priority)
        for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
            CHECK(rows[i].quota < rows[i + 1].quota);
            CHECK(rows[i].error > rows[i + 1].error);
            CHECK(rows[i].level < rows[i + 1].level);
            CHECK(rows[i].cut >= rows[i + 1].cut);
        }
}

TEST_CASE("an error is the share of the momentum that goes wrong") {
    // Two discs of 1 kg meet head-on at 1 m/s each and exchange velocities: 4 kg m/s change, at any
    // quota, for their trees have one node. Two squares of 1 m and 1 kg pass at a gap of 0.1 m;
    // only their root circles meet, and without a test more they are pushed along n, the line of
    // the centres: each by j = 2 |v . n| / (1 + 1) = 2 n.x, so 4 n.x of 4 are wrong.
    const std::vector<lod::Body<2>> bodies = two_couples(100);
    lod::FrameSettings settings;
    settings.contact_model = lod::ContactModel::centre_line;
    const auto outcomes = tried(bodies, {0, 1}, 1, settings);
    CHECK(outcomes.dearest > 2);
    for (const std::vector<QuotaOutcome>& rows : outcomes.of_priority) {
        CHECK(rows[0].error == Approx(0.5 / std::sqrt(0.25 + 1.21)).epsilon(1e-6));
        CHECK(rows[0].cut == 1);
        CHECK(rows[1].error == 0);
        CHECK(rows[1].cut == 0);
    }
}

TEST_CASE("an attended error weighs each body by the most attention that a pair of it has") {
    // Where the observer looks at one couple of boxes that are pushed though they pass, and another
    // couple far from there meets rightly, more of what is attended is wrong than of all; and less
    // where the other couple is looked at. By hand: a couple has one weight, w; each changes by
    // 2 and 4 kg m/s (see above).
    const std::vector<lod::Body<2>> bodies = two_couples(5);
    const double wrong = 4 * 0.5 / std::sqrt(0.25 + 1.21);
    for (const double fixation : {0.0, 5.0}) {
        lod::FrameSettings settings;
        settings.contact_model = lod::ContactModel::centre_line;
        settings.viewer.fixation = {fixation, 0, 0};
        const std::vector<lod::CandidatePair> pairs{{0, 1}, {2, 3}};
        const auto weight = measure::body_attention<2>(settings.viewer, bodies, pairs);
        CHECK(weight[0] == weight[1]);
        CHECK(weight[2] == weight[3]);
        CHECK((weight[0] > weight[2]) == (fixation == 0));
        const auto outcomes = tried(bodies, {0, 1}, 1, settings);
        for (const std::vector<QuotaOutcome>& rows : outcomes.of_priority) {
            CHECK(rows[0].error == Approx(wrong / 4).epsilon(1e-6));
            CHECK(rows[0].attended_error ==
                  Approx(weight[0] * wrong / (4 * weight[2])).epsilon(1e-6));
            CHECK(rows[1].attended_error == 0);
        }
    }
}

TEST_CASE("a body without a pair has no attention, and one of many the most of them") {
    std::vector<lod::Body<2>> bodies(crowd().begin(), crowd().end());
    const lod::Viewer viewer;
    const std::vector<lod::CandidatePair> pairs{{0, 1}, {0, 59}};
    lod::Attention<2> attention;
    std::vector<double> of_pair;
    attention.weigh(viewer, bodies, pairs, of_pair);
    const auto weight = measure::body_attention<2>(viewer, bodies, pairs);
    CHECK(weight[0] == std::max(of_pair[0], of_pair[1]));
    CHECK(weight[1] == of_pair[0]);
    CHECK(weight[59] == of_pair[1]);
    CHECK(weight[2] == 0);
}
