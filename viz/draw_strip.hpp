#pragma once

#include "viz/draw_scene.hpp"

namespace viz {

struct StripWords {
    std::string title = "The same collision, interrupted at different levels";
    std::string caption =
        "Bold circles: nodes that intersect. Green: the impulse. Pale outlines: the past.";
};

/// Strips of one collision (the paper's figure 9): a row for each run, with the start, the instant
/// of detection with the nodes that intersect, and as long after, with trajectories and ghosts of
/// the outlines at equal times. All panels share one scale. A run without a collision says so.
/// Throws lod::Error (input refused) where a run has no instants.
[[nodiscard]] Figure strips(const std::vector<Run>& runs, const StripWords& words = {});

/// A box that holds all that a run shows, from its first instant to that one.
[[nodiscard]] Box bounds(const Run& run, std::size_t until);

/// When there is enough to see: as long after the latest detection as that came after the start,
/// or the end of the longest run [s].
[[nodiscard]] double end_time(const std::vector<Run>& runs);

/// The instant nearest to a time [s].
[[nodiscard]] std::size_t instant_at(const Run& run, double time);

/// What one instant of a run looks like, with the past behind it.
struct PastChoice {
    int most_ghosts = 5;  ///< outlines of the past, at equal times; fewer where they would overlap
    double trajectory_opacity = 1;
};
void add_past(Marks& marks, const Run& run, std::size_t until, const PastChoice& choice = {});

/// The impulses of an instant: for each pair of bodies one arrow, on body B, at the middle of its
/// contacts, `metres_per_impulse` long for 1 N s, with its value.
void add_impulses(Marks& marks, const Run& run, std::size_t instant, double metres_per_impulse,
                  double opacity = 1);

/// The largest such impulse of an instant [N s].
[[nodiscard]] double largest_impulse(const Run& run, std::size_t instant);
[[nodiscard]] double largest_speed(const Run& run);

}  // namespace viz
