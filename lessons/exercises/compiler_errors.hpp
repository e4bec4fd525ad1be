#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/exercises/words.hpp"

namespace exercises {

/// What a student can use of a compiler's errors: at most three lines, of her own file where it has
/// any.
[[nodiscard]] std::vector<std::string> compiler_errors(std::string_view output, const Words& words);

}  // namespace exercises
