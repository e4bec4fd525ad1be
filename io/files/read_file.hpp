#pragma once

/// \file
/// A whole file as text, up to a limit, or one that is open for reading.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace lod {

/// A regular file that is open for reading at any place.
struct OpenFile {
    std::ifstream in;
    std::uintmax_t bytes = 0;  ///< in it
};

/// Opens a file. Throws Error (input refused) when it is missing, unreadable or no regular file.
[[nodiscard]] OpenFile open_file(const std::filesystem::path& path);

/// The whole of a file. Throws Error: input refused when it is missing, unreadable or no regular
/// file; limit exceeded when it is larger than most_bytes.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace lod
