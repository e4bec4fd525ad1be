#pragma once

#include "lessons/engine/meeting.hpp"

namespace lessons::degradation {

constexpr int depth = 4;  ///< levels 0 to 4: the text counts on it

/// The second half of the lesson: many collisions, and what a budget buys (curve.cpp).
void give_curves(Lesson& lesson);

}  // namespace lessons::degradation
