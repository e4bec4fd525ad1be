#include "lodlab/measure/crowd/course.hpp"

#include "lodlab/measure/crowd/frames_without.hpp"

namespace measure {
namespace {

template <int Dim>
CourseFrame told(const lod::FrameRecord<Dim>& record) {
    return {0, record.tests, record.levels_reached(), record.interrupted()};
}

/// Does one frame within its budget, on the clock.
template <int Dim>
CourseFrame timed_frame(const CoursePlan<Dim>& plan, const lod::FrameSettings& settings,
                        std::vector<lod::Body<Dim>>& bodies, lod::FrameStorage<Dim>& storage) {
    const auto now = [&] { return plan.clock ? plan.clock->now() : std::chrono::nanoseconds{}; };
    const std::chrono::nanoseconds begin = now();
    lod::Budget budget = plan.budget();
    const auto& record = lod::advance<Dim>(bodies, settings, budget, storage);
    const std::chrono::nanoseconds taken = now() - begin;
    CourseFrame frame = told(record);
    frame.milliseconds = 1e-6 * static_cast<double>(taken.count());
    return frame;
}

}  // namespace

template <int Dim>
std::vector<CourseFrame> course_of(const CoursePlan<Dim>& plan) {
    std::vector<lod::Body<Dim>> bodies(plan.bodies.begin(), plan.bodies.end());
    lod::FrameStorage<Dim> storage;
    std::vector<CourseFrame> frames;
    for (std::int64_t i = 0; i < plan.frames; ++i) {
        lod::check_interrupted();
        frames.push_back(timed_frame(plan, plan.settings, bodies, storage));
        if (plan.progress)
            plan.progress(static_cast<double>(i + 1) / static_cast<double>(plan.frames));
    }
    return frames;
}

template <int Dim>
LevelCourses level_courses(const CoursePlan<Dim>& plan, std::span<const lod::Priority> priorities) {
    struct Way {
        lod::FrameSettings settings;
        lod::FrameStorage<Dim> storage;
    };
    std::vector<Way> ways(priorities.size());
    for (std::size_t i = 0; i < ways.size(); ++i) {
        ways[i].settings = plan.settings;
        ways[i].settings.priority = priorities[i];
    }
    LevelCourses courses;
    courses.of_priority.resize(ways.size());
    const detail::RunWithout<Dim> run{plan.bodies, plan.settings, plan.frames};
    detail::run_without(run, [&](const detail::FrameWithout<Dim>& reference) {
        courses.without.push_back(told(*reference.record));
        for (std::size_t i = 0; i < ways.size(); ++i) {
            std::vector<lod::Body<Dim>> bodies = reference.before;
            courses.of_priority[i].push_back(
                timed_frame(plan, ways[i].settings, bodies, ways[i].storage));
        }
        if (plan.progress) plan.progress(reference.done);
    });
    return courses;
}

#define MEASURE_INSTANTIATE(Dim)                                         \
    template std::vector<CourseFrame> course_of(const CoursePlan<Dim>&); \
    template LevelCourses level_courses(const CoursePlan<Dim>&, std::span<const lod::Priority>);
MEASURE_INSTANTIATE(2)
MEASURE_INSTANTIATE(3)
#undef MEASURE_INSTANTIATE

}  // namespace measure
