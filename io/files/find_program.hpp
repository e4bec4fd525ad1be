#pragma once

#include <filesystem>
#include <string>

namespace lod {

/// The file that a shell would run for this name: itself where the name holds a slash, else the
/// first of that name in the folders of $PATH that are named from the root. Empty where there is no
/// such file, or none that may be run.
[[nodiscard]] std::filesystem::path find_program(const std::string& name);

}  // namespace lod
