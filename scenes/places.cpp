#include "scenes/places.hpp"

#include <algorithm>
#include <system_error>

#include "core/error.hpp"
#include "scenes/spelling.hpp"

namespace scenes {

std::filesystem::path folder() {
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const std::filesystem::path installed =
        program.parent_path().parent_path() / "share" / "lodlab" / "scenes";
    for (const std::filesystem::path& place : {installed, std::filesystem::path(LODLAB_SCENES)})
        if (std::filesystem::is_directory(place, ignored)) return place;
    throw lod::Error(lod::ErrorKind::not_installed,
                     "the scenes of lodlab are missing: there is no " + installed.string() +
                         "; install lodlab again");
}

std::vector<std::string> names() {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder()))
        if (entry.path().extension() == ".toml") found.push_back(entry.path().stem().string());
    std::sort(found.begin(), found.end());
    return found;
}

std::filesystem::path scene_file(const std::string& name) {
    std::error_code ignored;
    if (std::filesystem::exists(name, ignored)) return name;
    const bool is_path = name.find('/') != std::string::npos || name.ends_with(".toml");
    if (is_path)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot read " + name + ": no such file; check the name");
    const auto known = names();
    if (std::find(known.begin(), known.end(), name) != known.end())
        return folder() / (name + ".toml");
    const std::vector<std::string_view> candidates(known.begin(), known.end());
    throw lod::Error(lod::ErrorKind::input_refused,
                     "no scene file " + name + did_you_mean(name, candidates) +
                         "; name a file, or one of " + listed(candidates));
}

}  // namespace scenes
