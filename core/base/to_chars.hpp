#pragma once

#include <charconv>
#include <string>

namespace lod {

/// std::to_chars of a double, for standard libraries that do not promise it, too (libc++): the
/// shortest text that is read as the same number, or one of that format with so many digits,
/// whatever the locale.
[[nodiscard]] std::to_chars_result to_chars(char* first, char* last, double value);
[[nodiscard]] std::to_chars_result to_chars(char* first, char* last, double value,
                                            std::chars_format format, int precision);

/// The same as a text of its own.
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string number_text(double value, std::chars_format format, int precision);

/// What stands in there for the standard library: the same bytes by the C library's printf, slower.
namespace by_printf {
[[nodiscard]] std::to_chars_result to_chars(char* first, char* last, double value);
[[nodiscard]] std::to_chars_result to_chars(char* first, char* last, double value,
                                            std::chars_format format, int precision);
}  // namespace by_printf

}  // namespace lod
