#include "lodlab/io/files/user_folder.hpp"

#include <cstdlib>
#include <system_error>

namespace lod {

std::filesystem::path user_folder(const char* variable, const std::filesystem::path& below_home) {
    const char* named = std::getenv(variable);
    if (named != nullptr && std::filesystem::path(named).is_absolute())
        return std::filesystem::path(named) / "lodlab";
    const char* home = std::getenv("HOME");
    std::error_code ignored;
    if (home == nullptr || !std::filesystem::is_directory(home, ignored)) return {};
    return std::filesystem::path(home) / below_home / "lodlab";
}

}  // namespace lod
