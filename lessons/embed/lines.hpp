#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lessons {

/// Throws lod::Error (input refused): "file:line: why".
[[noreturn]] void refuse_line(const std::string& where, int line, const std::string& why);

/// Without the blanks at both ends.
[[nodiscard]] std::string trimmed(std::string_view text);

[[nodiscard]] std::vector<std::string> lines_of(std::string_view text);

/// The 1-based line of an offset.
[[nodiscard]] int line_of(std::string_view text, std::size_t offset);

}  // namespace lessons
