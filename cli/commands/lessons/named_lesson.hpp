#pragma once

#include <string>

#include "lessons/engine/lessons.hpp"

namespace cli {

/// The lesson of that number or name. Throws lod::Error, usage, where there is none.
[[nodiscard]] lessons::Entry named_lesson(const std::string& word);

}  // namespace cli
