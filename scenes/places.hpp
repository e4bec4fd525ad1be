#pragma once

/// \file
/// Where the scenes that come with lodlab lie, and the files that Debian packages bring.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
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

/// A folder of files that nobody here made, as a Debian package brings it.
struct SharedFolder {
    std::string_view package;
    std::string_view folder;
};
/// Those that "package:NAME/FILE" may name.
[[nodiscard]] std::span<const SharedFolder> shared_folders();

/// Whether the name has the form "package:NAME/FILE".
[[nodiscard]] bool in_package(std::string_view name);

/// The file that such a name stands for: "package:glmark2-data/bunny.obj". Throws lod::Error: input
/// refused for a package that is not in shared_folders(), a path that leaves its folder, or a file
/// that the package does not have; not installed, with the mend, where the package is missing.
[[nodiscard]] std::filesystem::path package_file(std::string_view name);

/// Whether a shape's name can only be a file: it has a folder in it, or the ending of a drawing or
/// of a mesh.
[[nodiscard]] bool looks_like_file(std::string_view name);

/// The shapes in a list: "box:2,1,L" is box:2,1 and L, since a number goes on with the shape
/// before.
[[nodiscard]] std::vector<std::string> shapes_in(const std::string& list);

}  // namespace scenes
