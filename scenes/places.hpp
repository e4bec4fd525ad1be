#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scenes {

/// The folder of the scenes that come with lodlab: beside an installed program
/// (../share/lodlab/scenes), else in the source tree that it was built from.
/// Throws lod::Error (not installed) when there is neither.
[[nodiscard]] std::filesystem::path folder();

/// The scenes that come with lodlab, by name, sorted.
[[nodiscard]] std::vector<std::string> names();

/// A scene as the user names it: an existing file, or the name of a scene that comes with lodlab.
/// Throws lod::Error (input refused) when it is neither.
[[nodiscard]] std::filesystem::path scene_file(const std::string& name);

}  // namespace scenes
