#pragma once

#include <string>
#include <vector>

/// What the tools share that put texts into the program.
namespace lessons {

/// A file's bytes. Throws lod::Error (input refused).
[[nodiscard]] std::string read(const std::string& path);

/// Throws lod::Error (input refused).
void write(const std::string& path, const std::string& text);

/// A literal of any length: raw strings side by side, for compilers limit one.
[[nodiscard]] std::string literal(const std::string& text);

/// A tool's main: does its work, or says why not. Returns the exit code.
[[nodiscard]] int run_tool(int count, char** values,
                           void (*work)(const std::vector<std::string>& arguments));

}  // namespace lessons
