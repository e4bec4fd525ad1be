#pragma once

#include <filesystem>

namespace cli {

/// Whether an input (a mesh, a drawing) names a file that is there: a buffer, a texture, a library
/// of materials and what that names in turn; as the file itself or by a link, in the spelling of
/// JSON, of XML or of an address.
[[nodiscard]] bool names_file(const std::filesystem::path& input,
                              const std::filesystem::path& file);

}  // namespace cli
