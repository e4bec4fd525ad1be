#pragma once

/// \file
/// The ending of a path, by which formats are chosen.

#include <filesystem>
#include <string>

namespace lod {

/// A path's ending in small letters, without its dot: "png"; empty where there is none.
[[nodiscard]] inline std::string ending_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    if (!ending.empty()) ending.erase(0, 1);
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return ending;
}

}  // namespace lod
