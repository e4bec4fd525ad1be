#pragma once

#include "lessons/engine/meeting.hpp"

namespace lessons::box2d {

/// Two unit boxes, the one higher than the other, that meet face to face.
[[nodiscard]] Meeting offset_boxes();

/// The same two bodies by Box2D, to their first impact.
[[nodiscard]] lod2d::Box2dImpact impact_by_box2d(const Meeting& meeting, double time_step,
                                                 double units_per_metre);

// The second half of the lesson: steps, laws and paths (parting.cpp).
void give_steps(Lesson& lesson);
void give_row(Lesson& lesson);
void give_paths(Lesson& lesson);

}  // namespace lessons::box2d
