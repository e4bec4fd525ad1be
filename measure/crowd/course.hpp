#pragma once

/// \file
/// Crowds frame by frame: what each frame takes, and to which levels its pairs come.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "lodlab/core/frame/frame.hpp"

namespace measure {

/// A crowd, and what each of its frames may spend.
template <int Dim>
struct CoursePlan {
    std::span<const lod::Body<Dim>> bodies;  ///< at the start
    lod::FrameSettings settings;
    std::int64_t frames = 1;
    std::function<lod::Budget()> budget = lod::Budget::unlimited;  ///< asked before each frame
    const lod::Clock* clock = nullptr;             ///< of the frames' times; nothing: they are 0
    std::function<void(double share)> progress{};  ///< called after every frame with the share done
};

/// One frame of it.
struct CourseFrame {
    double milliseconds = 0;  ///< on the plan's clock
    std::uint64_t tests = 0;
    lod::LevelsReached reached;
    bool cut = false;  ///< whether the quota left something out
};

/// Runs the crowd.
template <int Dim>
[[nodiscard]] std::vector<CourseFrame> course_of(const CoursePlan<Dim>& plan);

/// Frames of one run, each done in several ways.
struct LevelCourses {
    std::vector<CourseFrame> without;                   ///< a quota: to the leaves
    std::vector<std::vector<CourseFrame>> of_priority;  ///< under it, priority by priority
};

/// Runs the crowd without a quota, and does each of its frames again under one in every order of
/// priority from the same state, so that all meet the same bodies. The plan's own priority is not
/// used.
template <int Dim>
[[nodiscard]] LevelCourses level_courses(const CoursePlan<Dim>& plan,
                                         std::span<const lod::Priority> priorities);

}  // namespace measure
