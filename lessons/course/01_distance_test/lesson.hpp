#pragma once

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/math/sphere.hpp"

namespace lessons::distance {

// The end of the lesson (touching.cpp): circles that meet in a point, on paper and in a computer.
void step_touching(Lesson& lesson);
void step_rounding(Lesson& lesson);

}  // namespace lessons::distance
