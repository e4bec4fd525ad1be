#pragma once

#include <string>
#include <vector>

#include "lessons/engine/sketch.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/measure/curves.hpp"
#include "lodlab/measure/first_impact.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"
#include "lodlab/viz/draw/scene_view.hpp"

// Two bodies that meet, answered in several ways: what lessons share that compare answers.
namespace lessons {

/// Two bodies at the start, with trees and true shapes.
struct Meeting {
    lod2d::Shape shape_a;
    lod2d::Shape shape_b;
    viz::Actor<2> a;
    viz::Actor<2> b;

    [[nodiscard]] std::vector<lod::Body<2>> bodies() const { return {a.body, b.body}; }
    /// The look of body 0 or 1 where a body stands.
    [[nodiscard]] viz::Actor<2> at(int index, const lod::Body<2>& body) const {
        return {index == 0 ? a.visual : b.visual, body};
    }
};

/// Bodies of density 1 by the names of their shapes, at rest in the origin.
[[nodiscard]] Meeting meeting_of(const std::string& a, const std::string& b, int depth);

/// An L and a U with trees of levels 0 to 4, which meet after half a second: one scene for several
/// lessons.
[[nodiscard]] Meeting L_and_U();

/// A body so long ago [s], as it moves freely.
[[nodiscard]] viz::Actor<2> earlier(viz::Actor<2> actor, double seconds);

/// Frames that stop at a level.
[[nodiscard]] lod::FrameSettings down_to(int level, lod::ContactModel model, double time_step);
/// Frames that ask the true shapes and go back to their time of impact.
[[nodiscard]] lod::FrameSettings to_the_true_shapes(double time_step);

/// Bodies frame by frame, and where the last frame leaves them.
[[nodiscard]] viz::Run<2> run_of(const std::vector<viz::Actor<2>>& actors,
                                 const lod::FrameSettings& settings, double seconds,
                                 const std::string& name);
[[nodiscard]] viz::Run<2> run_of(const Meeting& meeting, const lod::FrameSettings& settings,
                                 double seconds, const std::string& name);

/// The first collision, as frames see it; refused where there is none.
[[nodiscard]] measure::Collision<2> collision_of(const Meeting& meeting,
                                                 const lod::FrameSettings& settings,
                                                 double horizon);
/// The same exactly.
[[nodiscard]] measure::Collision<2> exact_collision_of(const Meeting& meeting, double horizon);

/// The shortest way between two bodies, with its length in words.
void add_gap(viz::Panel& panel, const lod::Body<2>& a, const lod::Body<2>& b,
             const std::string& words);

/// The two bodies as a collision finds them, and the nodes of a level that overlap.
[[nodiscard]] viz::Panel found_at(const Meeting& meeting, const measure::Collision<2>& collision,
                                  int level, const viz::Box& view);

/// Runs laid over a reference run at a time [s], which is dashed: a panel each, without ghosts.
[[nodiscard]] viz::Figure over(const std::vector<viz::Run<2>>& runs, const viz::Run<2>& reference,
                               double until, const viz::Box& view);

/// The median error of the impulse at each level but the exact one, with its band.
[[nodiscard]] viz::Curve errors_by_level(const measure::DegradationCurve& curve, int series,
                                         const std::string& name);

/// Several panels on a page of the book.
[[nodiscard]] viz::Figure figure_of(std::vector<viz::Panel> panels, int columns);

}  // namespace lessons
