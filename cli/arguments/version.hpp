#pragma once

#include <string>

namespace cli {

/// What `lodlab --version` prints: version, commit, and the libraries in use.
[[nodiscard]] std::string version_text();

}  // namespace cli
