#pragma once

/// \file
/// Pictures and videos of a crowd under a quota: how far each body was refined, and what the quota
/// went into.

#include <array>

#include "lodlab/viz/draw/motion/quota_use.hpp"
#include "lodlab/viz/draw/scene_view.hpp"

namespace viz {

/// What a picture of a crowd shows.
struct CrowdChoice {
    Quota quota;  ///< of every frame; without one there is no bar
    /// The point that the observer looks at [m], where the policy goes by one.
    std::optional<std::array<double, 3>> fixation;
    std::string title;  ///< empty: what the frame, or the film, shows
    std::string caption;
    double frames_per_second = 30;
    std::int64_t first_frame = 0;  ///< number of the first instant's frame
    std::int64_t frames = 0;       ///< of the whole run; 0: those of the instants
};

/// The level of every body: the least that one of its pairs reached which nothing proved apart, for
/// that is how coarsely it was answered; -1 where it has none.
template <int Dim>
[[nodiscard]] std::vector<int> body_levels(const lod::FrameRecord<Dim>& record, std::size_t bodies);

/// One frame: bodies filled by their level, the fixation point, and the parts of the quota along
/// the edge. Throws lod::Error (input refused) where there is no such instant.
template <int Dim>
[[nodiscard]] Figure crowd_picture(const Run<Dim>& run, std::size_t instant,
                                   const CrowdChoice& choice = {},
                                   const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// The frame with most pairs that nothing proved apart: where there is most to refine.
template <int Dim>
[[nodiscard]] std::size_t fullest_instant(const Run<Dim>& run);

/// The whole run, a frame of it in each of the video's (in long runs every second, third, ...), the
/// last one held. Throws lod::Error (input refused) where the run has no instants.
template <int Dim>
[[nodiscard]] Animation crowd_motion(const Run<Dim>& run, const CrowdChoice& choice = {},
                                     const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

}  // namespace viz
