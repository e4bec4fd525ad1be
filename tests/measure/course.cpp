#include "lodlab/measure/crowd/course.hpp"

#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "tests/catch.hpp"

namespace {

/// Goes on by a millisecond a look.
class CountingClock final : public lod::Clock {
  public:
    std::chrono::nanoseconds now() const override { return std::chrono::milliseconds(++looks_); }

  private:
    mutable int looks_ = 0;
};

/// Two stars that move through each other, and one that is far.
std::vector<lod::Body<2>> stars() {
    const lod2d::Shape shape = lod2d::generate("star:5");
    const auto tree = std::make_shared<const lod::SphereTree<2>>(
        lod2d::build_tree(shape, {.branching = 4, .depth = 3}));
    std::vector<lod::Body<2>> bodies(3);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        lod::set_mass<2>(bodies[i], 1, lod::Inertia<2>::Constant(0.1));
        bodies[i].tree = tree;
        bodies[i].position = {i == 2 ? 50 : 1.2 * static_cast<double>(i), 0};
        bodies[i].velocity = {i == 1 ? -1 : 0, 0};
    }
    return bodies;
}

measure::CoursePlan<2> plan_of(const std::vector<lod::Body<2>>& bodies) {
    measure::CoursePlan<2> plan;
    plan.bodies = bodies;
    plan.settings.time_step = 1.0 / 30;
    plan.frames = 20;
    return plan;
}

}  // namespace

TEST_CASE("a course tells each frame's time, tests and levels") {
    const std::vector<lod::Body<2>> bodies = stars();
    const CountingClock clock;
    measure::CoursePlan<2> plan = plan_of(bodies);
    plan.clock = &clock;
    const auto frames = measure::course_of(plan);
    REQUIRE(frames.size() == 20);
    CHECK(frames[0].reached.pairs == 0);
    CHECK(frames[0].reached.least == -1);
    bool met = false;
    for (const measure::CourseFrame& frame : frames) {
        CHECK(frame.milliseconds == Approx(1));
        CHECK_FALSE(frame.cut);
        if (frame.reached.pairs == 0) continue;
        met = true;
        CHECK(frame.reached.pairs == 1);
        CHECK(frame.reached.least == 3);
        CHECK(frame.reached.mean == 3);
        CHECK(frame.tests > 1);
    }
    CHECK(met);
}

TEST_CASE("a frame is done in all ways from the state of the run without a quota") {
    const std::vector<lod::Body<2>> bodies = stars();
    measure::CoursePlan<2> plan = plan_of(bodies);
    const auto alone = measure::course_of(plan);
    plan.budget = [] { return lod::Budget::node_tests(0); };
    const std::vector<lod::Priority> priorities{lod::Priority::level_order,
                                                lod::Priority::best_gain};
    const auto courses = measure::level_courses<2>(plan, priorities);
    REQUIRE(courses.of_priority.size() == 2);
    REQUIRE(courses.without.size() == alone.size());
    bool cut = false;
    for (std::size_t i = 0; i < alone.size(); ++i) {
        CHECK(courses.without[i].tests == alone[i].tests);
        CHECK(courses.without[i].reached.pairs == alone[i].reached.pairs);
        for (const auto& frames : courses.of_priority) {
            // Nothing beyond the entry level: fewer tests, fewer pairs proved apart.
            CHECK(frames[i].tests <= alone[i].tests);
            CHECK(frames[i].reached.pairs >= alone[i].reached.pairs);
            if (frames[i].reached.pairs > 0) CHECK(frames[i].reached.least < 3);
            cut = cut || frames[i].cut;
        }
    }
    CHECK(cut);
}
