#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lessons {

/// Throws lod::Error (input refused): "file:line: why".
[[noreturn]] void refuse_line(const std::string& where, int line, const std::string& why);

/// Whether it is a letter of ASCII, as names begin with.
[[nodiscard]] bool is_letter(char c);
/// Whether a name may go on with it: a letter, a digit, an underscore.
[[nodiscard]] bool is_word(char c);

/// Without the blanks at both ends.
[[nodiscard]] std::string trimmed(std::string_view text);

[[nodiscard]] std::vector<std::string> lines_of(std::string_view text);

/// The 1-based line of an offset.
[[nodiscard]] int line_of(std::string_view text, std::size_t offset);

}  // namespace lessons
