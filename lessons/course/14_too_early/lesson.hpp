#pragma once

#include "lessons/engine/meeting.hpp"

namespace lessons::early {

/// The second half of the lesson: a crowd whose frames are cut short (crowd.cpp).
void give_crowd(Lesson& lesson);

}  // namespace lessons::early
