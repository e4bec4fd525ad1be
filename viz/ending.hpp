#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

namespace viz {

/// A path's ending in small letters: ".png".
[[nodiscard]] inline std::string ending_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return ending;
}

}  // namespace viz
