#pragma once

#include <span>
#include <string>

#include "lessons/exercises/exercise.hpp"

namespace exercises {

/// An exercise as the build embeds it; `answers` has one for each of mixtures_of its words.
struct Embedded {
    const char* path;  ///< PART/NAME
    std::string markdown;
    Task (*task)();
    Numbers (*const* answers)(const Numbers& asked);
};

/// Every exercise, in order.
[[nodiscard]] std::span<const Embedded> all_embedded();

/// lessons/exercises/wire.hpp itself, for the student's program.
[[nodiscard]] const std::string& wire_text();

}  // namespace exercises
