#pragma once

/// \file
/// A row of pictures for each run: before, at and after the collision.

#include "lodlab/viz/draw/draw_scene.hpp"

namespace viz {

/// The words of the page.
struct StripWords {
    std::string title = "The same collision, interrupted at different levels";
    std::string caption{};  ///< empty: what the marks stand for
};

/// Strips of one collision (the paper's figure 9): a row for each run, with the start, the instant
/// of detection with the nodes that intersect, and as long after, with trajectories and ghosts of
/// the outlines at equal times. All panels share one scale. A run without a collision says so.
/// Throws lod::Error (input refused) where a run has no instants.
template <int Dim>
[[nodiscard]] Figure strips(const std::vector<Run<Dim>>& runs, const StripWords& words = {},
                            const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// What shows all that happens in runs until a time [s].
template <int Dim>
[[nodiscard]] View<Dim> view_of(const std::vector<Run<Dim>>& runs, double until,
                                const typename DrawTraits<Dim>::Viewpoint& viewpoint);

/// When there is enough to see: as long after the latest detection as that came after the start,
/// or the end of the longest run [s].
template <int Dim>
[[nodiscard]] double end_time(const std::vector<Run<Dim>>& runs);

/// The instant nearest to a time [s].
template <int Dim>
[[nodiscard]] std::size_t instant_at(const Run<Dim>& run, double time);

/// What one instant of a run looks like, with the past behind it.
struct PastChoice {
    int most_ghosts = 5;  ///< outlines of the past, at equal times; fewer where they would overlap
    double trajectory_opacity = 1;
};
/// Draws the ways that bodies came, and their ghosts.
template <int Dim>
void add_past(Panel& panel, const Run<Dim>& run, std::size_t until, const PastChoice& choice = {});

/// The impulses of an instant: for each pair of bodies one arrow, on body B, at the middle of its
/// contacts, `metres_per_impulse` long for 1 N s, with its value.
template <int Dim>
void add_impulses(Panel& panel, const Run<Dim>& run, std::size_t instant, double metres_per_impulse,
                  double opacity = 1);

/// The largest such impulse of an instant [N s].
template <int Dim>
[[nodiscard]] double largest_impulse(const Run<Dim>& run, std::size_t instant);
/// Of any body at any instant of the run [m/s].
template <int Dim>
[[nodiscard]] double largest_speed(const Run<Dim>& run);

}  // namespace viz
