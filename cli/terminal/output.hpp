#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

namespace cli {

/// Writes to standard output, all of it. Throws lod::Error (output failed) when that does not work.
void print(const std::string& text);

/// The same for a result as JSON, indented, with a newline.
void print(const nlohmann::ordered_json& json);

/// A remark that is no result: one line on standard error.
void remark(const std::string& line);
/// Remarks of one kind: the first few, and how many more there are.
void remark_all(std::span<const std::string> lines);

/// A number as a reader wants it: at most so many significant digits, no trailing zeros.
[[nodiscard]] std::string readable(double number, int digits = 6);

/// The text at the right end of a column of so many characters.
[[nodiscard]] std::string right(const std::string& text, std::size_t width);

}  // namespace cli
