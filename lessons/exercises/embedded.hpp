#pragma once

#include <string>

#include "lessons/exercises/exercise.hpp"

namespace exercises {

/// lessons/exercises/wire.hpp itself, for the student's program.
[[nodiscard]] const std::string& wire_text();

}  // namespace exercises
