#pragma once

#include <string>
#include <string_view>

#include "lessons/engine/lessons.hpp"

namespace lessons {

/// Lines of at most `columns` characters (not bytes), each after `indent`; blank lines, list items
/// and indented code stay apart. With `styled`, **bold** is shown in bold; otherwise the marks are
/// only left out.
[[nodiscard]] std::string wrapped(std::string_view markdown, int columns, bool styled,
                                  std::string_view indent = "");

/// How a reader of the terminal gets the page of the lesson's live part.
[[nodiscard]] std::string live_line(const Lesson& lesson);

/// A text of a completed lesson for a terminal: equations in plain characters, listings indented,
/// figures by their alt text.
[[nodiscard]] std::string text_for_terminal(const Lesson& lesson, std::string_view markdown,
                                            int columns, bool styled);

}  // namespace lessons
