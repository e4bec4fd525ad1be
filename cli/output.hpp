#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace cli {

/// Writes to standard output, all of it. Throws lod::Error (output failed) when that does not work.
void print(const std::string& text);

/// The same for a result as JSON, indented, with a newline.
void print(const nlohmann::ordered_json& json);

/// A remark that is no result: one line on standard error.
void remark(const std::string& line);

/// A number as a reader wants it: at most six significant digits, no trailing zeros.
[[nodiscard]] std::string readable(double number);

}  // namespace cli
