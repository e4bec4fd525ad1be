#pragma once

/// \file
/// Pictures and videos of runs laid over a reference.

#include "lodlab/viz/draw/motion/draw_motion.hpp"

namespace viz {

/// The words of the page.
struct ComparisonWords {
    std::string title = "The same scene at several levels, and by a reference";
    std::string caption{};
};

/// Runs of one scene laid over a reference run of it: a panel for each run, headed by its name,
/// with its bodies at a time [s], the way they came, and, dashed, the reference's ways and where
/// its bodies are by then. The reference is named at its end where few bodies move: many leave no
/// room. All panels share one scale.
/// Throws lod::Error (input refused) where a run has no instants.
template <int Dim>
[[nodiscard]] Figure comparison(const std::vector<Run<Dim>>& runs, const Run<Dim>& reference,
                                double until, const ComparisonWords& words = {},
                                const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// How the film goes.
struct ComparisonMotion {
    ComparisonWords words{};
    double frames_per_second = 30;
    double seconds = 12;  ///< of video for the whole run
    double trail = 0.5;   ///< of the past that a body draws behind it [s]
};

/// The runs side by side, the reference last and dashed in all others, on one clock.
template <int Dim>
[[nodiscard]] Animation comparison_motion(
    const std::vector<Run<Dim>>& runs, const Run<Dim>& reference,
    const ComparisonMotion& choice = {}, const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

}  // namespace viz
