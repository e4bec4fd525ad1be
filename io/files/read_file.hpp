#pragma once

/// \file
/// A whole file as text, up to a limit.

#include <cstddef>
#include <filesystem>
#include <string>

namespace lod {

/// The whole of a file. Throws Error: input refused when it is missing, unreadable or no regular
/// file; limit exceeded when it is larger than most_bytes.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace lod
