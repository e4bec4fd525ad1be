#pragma once

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/viz/draw/motion/draw_crowd.hpp"

namespace lessons::scheduler {

/// A crowd that draws together, frame by frame as it moves without a quota (crowd.cpp).
struct Crowd {
    Crowd();

    std::vector<viz::Visual<2>> visuals;
    std::vector<std::vector<lod::Body<2>>> before;  ///< of each frame
    std::vector<std::vector<lod::Body<2>>> after;
    std::vector<std::vector<lod::CandidatePair>> candidates;
    std::uint64_t dearest = 0;  ///< tests of the frame that takes most
    std::uint64_t first = 0;    ///< and of the first one

    /// The quota of the lesson: half of what the dearest frame takes.
    [[nodiscard]] std::uint64_t quota() const { return dearest / 2; }
};

/// Node tests that the answer to an overlapping pair of circles counts as.
constexpr double pair_cost = 1;

/// An observer who looks so far to the right of the middle [m].
[[nodiscard]] lod::Viewer looking_at(double right);
constexpr double aside = 1.4;  ///< how far to the left or right the observer looks [m]

/// How the first frame goes under a policy and the quota.
[[nodiscard]] lod::FrameRecord<2> first_frame(const Crowd& crowd, lod::Priority policy,
                                              const lod::Viewer& viewer);

/// Its first frame under the quota, for readers to play with.
[[nodiscard]] live::Scene play(const Crowd& crowd);

/// How wrong the frames of a crowd are under a quota: of all that impulses change, the share that
/// is wrong; 0: nothing, 1: as much as there is to change.
struct Error {
    double all = 0;
    double attended = 0;  ///< each body weighted by the attention that it has
};
[[nodiscard]] Error error_of(const Crowd& crowd, lod::Priority policy, std::uint64_t quota);

/// The second half of the lesson: what each policy is worth (worth.cpp).
void give_worth(Lesson& lesson, const Crowd& crowd);

}  // namespace lessons::scheduler
