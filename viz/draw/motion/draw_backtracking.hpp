#pragma once

/// \file
/// A figure of inappropriate backtracking.

#include "lodlab/core/exact/level_impact.hpp"
#include "lodlab/viz/draw/draw_scene.hpp"

namespace viz {

/// What figure 5 is asked for.
struct BacktrackingQuestion {
    int level = 1;                 ///< whose nodes are taken for the shapes
    double time_step = 1.0 / 120;  ///< of the frames in which the nodes are found to overlap [s]
    double horizon = 2;            ///< how long the bodies are watched [s]
};

/// Inappropriate backtracking (the paper's figure 5), in three panels: the frame in which nodes of
/// the level overlap; the "collision time" that backtracking finds, at which those nodes touch and
/// the bodies do not; and the bodies where they are nearest to each other, untouched.
/// The actors stand as they do at the beginning and move freely. Requires: body.exact of both.
/// Throws lod::Error (input refused) where the nodes never touch, or where the bodies themselves
/// do: then nothing is inappropriate.
template <int Dim>
[[nodiscard]] Figure inappropriate_backtracking(
    const Actor<Dim>& a, const Actor<Dim>& b, const BacktrackingQuestion& question = {},
    const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

}  // namespace viz
