#pragma once

#include <filesystem>

namespace lod {

/// lodlab's folder of one kind of the user's files, by the XDG base directories: in the folder that
/// the variable names by an absolute path, else below the home. Empty where there is no home.
[[nodiscard]] std::filesystem::path user_folder(const char* variable,
                                                const std::filesystem::path& below_home);

}  // namespace lod
