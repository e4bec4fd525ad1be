#pragma once

#include <filesystem>

namespace lod {

/// How often a part is tried under another name before nothing can be written.
constexpr int most_parts = 100;

/// Where what shall be a file or a folder is made: beside it, NAME.lodlab-partN-M, where N is this
/// process and M the attempt; of its own name as much as a name may hold.
[[nodiscard]] std::filesystem::path part_of(const std::filesystem::path& path, int attempt);

/// Says to other processes, also of other machines, that the part behind this descriptor is being
/// written, until the descriptor is closed, at the latest by the end of the process.
void hold_part(int descriptor);

/// Removes the parts, files and folders, that processes left in a folder which ended without a
/// chance to do so.
void sweep_parts(const std::filesystem::path& folder);

}  // namespace lod
