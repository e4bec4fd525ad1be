// The collision of the paper's figure 9, as lodlab and as Box2D see it.

#include <cmath>

#include "lodlab/core/frame/finest.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/lod2d/builder/tree_report.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"
#include "lodlab/measure/reference/box2d_reference.hpp"
#include "lodlab/scenes/setup.hpp"
#include "tests/catch.hpp"

using namespace scenes;

namespace {

constexpr double time_step = 1.0 / 960;

struct Figure9 {
    Setup<2> setup = set_up<2>(load_scene(LODLAB_SOURCE_DIR "/scenes/figure9.toml"));
    lod2d::Box2dImpact reference;

    Figure9() {
        const lod2d::Shape* const shapes[] = {setup.shapes[0].get(), setup.shapes[1].get()};
        reference = lod2d::run_to_impact(setup.bodies, shapes);
    }
};

/// The bodies of the first frame with an impulse: as it found them and as it left them.
struct Impact {
    double time = -1;
    std::vector<lod::Body<2>> before;
    std::vector<lod::Body<2>> after;
};

Impact first_impact(std::vector<lod::Body<2>> bodies, int level) {
    lod::FrameSettings settings;
    settings.deepest_level = level;
    settings.time_step = time_step;
    lod::FrameStorage<2> storage;
    for (int frame = 0; frame < 4000; ++frame) {
        Impact impact{frame * time_step, bodies, {}};
        lod::Budget budget = lod::Budget::unlimited();
        const auto& record = lod::advance<2>(bodies, settings, budget, storage);
        for (const double j : record.impulses) {
            if (j <= 0) continue;
            impact.after = bodies;
            return impact;
        }
    }
    return {};
}

lod2d::BoundaryIndex border(const lod2d::Shape& shape, const lod::Body<2>& body) {
    return lod2d::BoundaryIndex(shape.polygon).carried({body.position, body.orientation});
}

double gap(const Setup<2>& setup, const std::vector<lod::Body<2>>& bodies) {
    return lod2d::distance(border(*setup.shapes[0], bodies[0]),
                           border(*setup.shapes[1], bodies[1]));
}

}  // namespace

TEST_CASE("from Box2D's contact of bat and plane lodlab finds the same velocities", "[box2d]") {
    const Figure9 figure;
    REQUIRE(figure.reference.happened);
    REQUIRE(figure.reference.contacts.size() == 1);
    const lod2d::Box2dContact& touch = figure.reference.contacts[0];
    auto bodies = figure.reference.before;
    const lod::Contact<2> contact{touch.point, touch.normal, 0};
    const double j = lod::single_impulse(bodies[0], bodies[1], contact);
    lod::apply_impulse(bodies[0], bodies[1], contact, j);
    // Single precision, some ten roundings of 1e-6: see the test of the reference itself.
    CHECK(touch.impulse == Approx(j).epsilon(1e-5));
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK((bodies[i].velocity - figure.reference.after[i].velocity).norm() < 3e-5);
        CHECK(std::abs(bodies[i].spin[0] - figure.reference.after[i].spin[0]) < 1e-4);
    }
}

TEST_CASE("bat and plane repel across a gap that each level bounds, ever nearer to Box2D's instant",
          "[box2d]") {
    const Figure9 figure;
    const auto& [scene, bodies, shapes, warnings] = figure.setup;
    const auto bat = lod2d::report_tree(*shapes[0], *bodies[0].tree);
    const auto plane = lod2d::report_tree(*shapes[1], *bodies[1].tree);
    // No point of the two turns before the impact, so none closes faster than the bodies do.
    const double closing = (bodies[0].velocity - bodies[1].velocity).norm();
    double early_before = 1e9;
    for (int level = 0; level <= 4; ++level) {
        const auto k = static_cast<std::size_t>(level);
        const Impact impact = first_impact(bodies, level);
        REQUIRE(impact.time >= 0);
        const double bound = bat.levels[k].worst_protrusion + plane.levels[k].worst_protrusion;
        CHECK(gap(figure.setup, impact.before) <= bound);
        const double early = figure.reference.time - impact.time;
        INFO("level " << level << ": " << early << " s before Box2D, gap "
                      << gap(figure.setup, impact.before) << " m of at most " << bound << " m");
        CHECK(early <= early_before);
        // Box2D's skins meet 0.6 mm before the outlines, and it steps as far as lodlab does.
        CHECK(early >= -(2 * time_step + 0.002 / closing));
        early_before = early;
        const double error = (impact.after[0].velocity - figure.reference.after[0].velocity).norm();
        UNSCOPED_INFO("velocity error of the bat " << error << " m/s");
    }
    CHECK(early_before * closing < 0.02);
}

TEST_CASE("the letters touch along one normal at every level, cuts or not") {
    // Round strokes whose pieces end in cuts: where a serif meets two pieces, both say the same.
    const Setup<2> setup = set_up<2>(load_scene(LODLAB_SOURCE_DIR "/scenes/letters.toml"));
    for (int level = 0; level < 5; ++level) {
        const Impact impact = first_impact(setup.bodies, level);
        REQUIRE(impact.time > 0);
        lod::FrameSettings settings;
        settings.deepest_level = level;
        settings.time_step = time_step;
        lod::FrameStorage<2> storage;
        lod::Budget budget = lod::Budget::unlimited();
        const auto& record = lod::detect<2>(impact.before, settings, budget, storage);
        const auto exact = lod::exact_contact(impact.before[0], impact.before[1], time_step, 1e-9);
        REQUIRE(exact.contacts.size() == 1);
        for (const auto& one : record.impacts) {
            INFO("level " << level);
            CHECK(one.contact.normal.dot(exact.contacts[0].normal) > 0.99);
        }
    }
}
