#pragma once

/// \file
/// Videos of a collision, or of a whole simulation.

#include "lodlab/viz/draw/motion/draw_strip.hpp"

namespace viz {

/// How the film of one collision goes.
struct ImpactMotion {
    double frames_per_second = 30;
    double seconds = 5;  ///< of video for the motion itself, pauses and the slow impact not counted
    double slow = 0.25;  ///< speed near an impact, as a share of the usual one
    std::string title = "The same collision, interrupted at different levels";
    std::string caption = "Slow near the impact; paused while its marks appear.";
};

/// One collision as a video, the runs side by side: quick at first, slow at the
/// impact, a pause at the instant of detection with its marks drawn one after the other, then what
/// follows, and back to the start. Runs share one clock and one scale.
/// Throws lod::Error (input refused) where a run has no instants.
template <int Dim>
[[nodiscard]] Animation impact_motion(const std::vector<Run<Dim>>& runs,
                                      const ImpactMotion& choice = {},
                                      const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// How the film of a simulation goes.
struct SimulationMotion {
    double frames_per_second = 30;
    double speed = 1;    ///< simulated seconds for one second of video, > 0
    bool plots = true;   ///< energy and momentum beside the scene
    double trail = 0.6;  ///< of the past that a body draws behind it [s]
    std::string title;   ///< the run's name when empty
    std::string caption;
};

/// A whole simulation of any number of bodies, contacts shown as they are resolved.
template <int Dim>
[[nodiscard]] Animation simulation_motion(
    const Run<Dim>& run, const SimulationMotion& choice = {},
    const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// One frame of it, as a picture.
template <int Dim>
[[nodiscard]] Figure simulation_picture(const Run<Dim>& run, double time,
                                        const SimulationMotion& choice = {},
                                        const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// The bodies between two instants: they move freely there, so this is exact but for the spin of a
/// body in space.
template <int Dim>
[[nodiscard]] std::vector<lod::Body<Dim>> bodies_at(const Run<Dim>& run, double time);

/// Which part of the ways is drawn.
struct Trail {
    double from = 0;   ///< [s]
    double until = 0;  ///< [s]
    double opacity = 1;
};

/// The way of every moving body, ending where the bodies stand.
template <int Dim>
void add_trails(Panel& panel, const Run<Dim>& run, const std::vector<lod::Body<Dim>>& bodies,
                const Trail& trail);

}  // namespace viz
