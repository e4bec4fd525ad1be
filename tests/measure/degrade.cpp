#include "lodlab/measure/degrade.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/measure/curves.hpp"
#include "lodlab/measure/free_flight.hpp"
#include "tests/catch.hpp"

namespace {

using lod::ContactModel;
using lod::Response;

/// Kinds with shallow trees, built once for all tests.
template <int Dim>
const std::vector<measure::MeasuredShape<Dim>>& shapes();

std::vector<measure::MeasuredShape<2>> made_in_plane() {
    std::vector<measure::MeasuredShape<2>> made;
    scenes::TreeChoice tree;
    tree.depth = 4;
    for (const char* spec : {"box", "L", "star:5"})
        made.push_back(
            measure::measured_shape<2>(spec, scenes::Shapes<2>::named(spec, {}), tree, {}));
    return made;
}
std::vector<measure::MeasuredShape<3>> made_in_space() {
    scenes::TreeChoice tree;
    tree.depth = 2;
    tree.builder = "octree";
    return {measure::measured_shape<3>("box", scenes::Shapes<3>::named("box", {}), tree, {})};
}
template <>
const std::vector<measure::MeasuredShape<2>>& shapes<2>() {
    static const auto made = made_in_plane();
    return made;
}
template <>
const std::vector<measure::MeasuredShape<3>>& shapes<3>() {
    static const auto made = made_in_space();
    return made;
}

measure::Plan plan(int dim, int impacts) {
    measure::Plan plan;
    plan.dim = dim;
    plan.shapes = {"box"};
    plan.depth = dim == 2 ? 4 : 2;
    plan.impacts = impacts;
    plan.ensemble.seed = 7;
    plan.models = {ContactModel::centre_line, ContactModel::node_normal};
    plan.responses = {Response::net};
    return plan;
}

std::string refusal(std::vector<measure::Outcomes> shares) {
    try {
        (void)measure::merged(std::move(shares));
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::input_refused);
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("a spread takes values that were measured, by nearest rank") {
    const measure::Spread ten = measure::spread({10, 1, 9, 2, 8, 3, 7, 4, 6, 5});
    CHECK(ten.p10 == 1);
    CHECK(ten.median == 5);
    CHECK(ten.p90 == 9);
    const measure::Spread one = measure::spread({3.5});
    CHECK(one.median == 3.5);
    CHECK(one.p90 == 3.5);
    CHECK(measure::spread({1, 2, 3}).median == 2);
    CHECK_THROWS_AS(measure::spread({}), lod::Error);
}

TEST_CASE("an impact of an ensemble does not depend on the others") {
    const measure::EnsembleSettings settings;
    const std::span<const measure::MeasuredShape<2>> all(shapes<2>());
    const auto fifth = measure::draw_approach<2>(all, settings, 5, 1.0 / 960);
    (void)measure::draw_approach<2>(all, settings, 4, 1.0 / 960);
    const auto again = measure::draw_approach<2>(all, settings, 5, 1.0 / 960);
    CHECK(again.time == fifth.time);
    CHECK(again.b.position == fifth.b.position);
    CHECK(again.a.spin == fifth.a.spin);
    const auto sixth = measure::draw_approach<2>(all, settings, 6, 1.0 / 960);
    CHECK(sixth.b.position != fifth.b.position);
    const auto other_seed = measure::draw_approach<2>(all, {.seed = 2}, 5, 1.0 / 960);
    CHECK(other_seed.b.position != fifth.b.position);
}

TEMPLATE_TEST_CASE_SIG("the exact level is exact and no gap is beyond its bound", "[degrade]",
                       ((int Dim), Dim), 2, 3) {
    const auto outcomes = measure::degrade<Dim>(plan(Dim, Dim == 2 ? 60 : 6), shapes<Dim>());
    const std::size_t levels = outcomes.plan.levels();
    // In space a frame goes back in time by a step of free rotation, which undoes a step to second
    // order in the angle, some 0.003.
    const double tolerance = Dim == 2 ? 1e-9 : 1e-4;
    for (const measure::ImpactSample& impact : outcomes.impacts)
        for (std::size_t i = 0; i < impact.outcomes.size(); ++i) {
            const measure::Outcome& outcome = impact.outcomes[i];
            CHECK(outcome.gap <= outcome.gap_bound);
            CHECK_FALSE(outcome.missed);
            if (i % levels + 1 < levels) continue;
            CHECK(outcome.impulse_error <= tolerance);
            CHECK(outcome.spin_error <= tolerance);
            CHECK(std::abs(outcome.delay) <= tolerance);
        }
}

TEST_CASE("with node normals every level answers better than the one before") {
    const auto curves = measure::curves_of(measure::degrade<2>(plan(2, 100), shapes<2>()));
    REQUIRE(curves.size() == 2);
    const measure::DegradationCurve& by_surface = curves[1];
    CHECK(by_surface.model == ContactModel::node_normal);
    CHECK(by_surface.falls_at_every_level());
    CHECK(by_surface.levels[4].impulse_error.median < 0.06);
    CHECK(by_surface.levels[4].impulse_error.median < curves[0].levels[4].impulse_error.median / 2);
    CHECK(by_surface.levels.back().name == "exact");
    // The first level is the root's, which knows nothing of surfaces.
    CHECK(by_surface.levels[0].impulse_error.median == curves[0].levels[0].impulse_error.median);
}

TEST_CASE("shares put together have the bits of one run, through files too") {
    const measure::Plan all = plan(2, 10);
    const auto whole = measure::degrade<2>(all, shapes<2>());
    REQUIRE(whole.complete());
    std::vector<measure::Outcomes> shares;
    for (const int index : {2, 3, 1}) {
        const auto share = measure::degrade<2>(all, shapes<2>(), {.share = {index, 3}});
        CHECK(share.impacts.size() == (index == 1 ? 4u : 3u));
        shares.push_back(measure::outcomes_from_json(measure::outcomes_json(share), "share"));
    }
    const auto together = measure::merged(shares);
    CHECK(together.plan == whole.plan);
    CHECK(together.impacts == whole.impacts);
    CHECK(measure::outcomes_json(together) == measure::outcomes_json(whole));

    CHECK(refusal({shares[0], shares[1]}).find("missing") != std::string::npos);
    CHECK(refusal({shares[0], shares[1], shares[2], shares[1]}).find("twice") != std::string::npos);
    shares[1].plan.ensemble.seed = 8;
    CHECK(refusal(shares).find("settings differ") != std::string::npos);
    CHECK(refusal({}).find("no shares") != std::string::npos);
}

TEST_CASE("frames that are skipped would have changed nothing") {
    const measure::Plan settings = plan(2, 5);
    const auto outcomes = measure::degrade<2>(settings, shapes<2>());
    for (const measure::ImpactSample& impact : outcomes.impacts) {
        const auto approach = measure::draw_approach<2>(shapes<2>(), settings.ensemble,
                                                        static_cast<std::uint64_t>(impact.number),
                                                        settings.time_step);
        for (int level = 0; level <= settings.depth; ++level) {
            lod::FrameSettings frame;
            frame.time_step = settings.time_step;
            frame.deepest_level = level;
            frame.contact_model = settings.models[0];
            std::vector<lod::Body<2>> bodies{approach.a, approach.b};
            lod::FrameStorage<2> storage;
            int number = 0;
            for (;; ++number) {
                lod::Budget budget = lod::Budget::unlimited();
                const auto& record = lod::advance<2>(bodies, frame, budget, storage);
                if (record.energy_before != record.energy_after) break;
                bool pushed = false;
                for (const double j : record.impulses) pushed |= j > 0;
                if (pushed) break;
            }
            CHECK(impact.outcomes[static_cast<std::size_t>(level)].delay ==
                  number * settings.time_step - approach.time);
        }
    }
}

TEST_CASE("bodies may move by their clearance before a level has a front") {
    const auto& shape = shapes<2>()[2];
    for (int trial = 0; trial < 40; ++trial) {
        lod::Body<2> a = shape.body;
        lod::Body<2> b = shape.body;
        b.position = {0.6 + 0.015 * trial, 0.1};
        b.orientation = 0.1 * trial;
        lod::PosedTree<2> world_a;
        lod::PosedTree<2> world_b;
        const int level = trial % 5;
        const auto gap = [&] {
            world_a.pose(a);
            world_b.pose(b);
            return measure::clearance(world_a, world_b, level);
        };
        const auto has_front = [&] {
            const auto fronts = lod::traverse_levels(a, b, level);
            return !fronts.back().pairs.empty();
        };
        const double clear = gap();
        CHECK((clear <= 0) == has_front());
        if (clear <= 0) continue;
        b.position -= 0.999 * clear * lod::Vector<2>(1, 0);
        CHECK_FALSE(has_front());
    }
}

TEST_CASE("a file that holds no outcomes is refused by name") {
    for (const char* text : {"", "{}", "[1, 2]", "{\"lodlab_outcomes\": 99}"}) {
        try {
            (void)measure::outcomes_from_json(text, "share.json");
            FAIL("accepted");
        } catch (const lod::Error& error) {
            CHECK(error.kind() == lod::ErrorKind::input_refused);
            CHECK(std::string(error.what()).find("share.json") == 0);
        }
    }
}
