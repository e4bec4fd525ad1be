#include "lodlab/scenes/places.hpp"

#include <algorithm>
#include <system_error>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/ending.hpp"
#include "lodlab/lod3d/source/file_mesh.hpp"
#include "lodlab/scenes/spelling.hpp"

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
                         "; name a file, one of " + listed(candidates) +
                         ", or a crowd, as in gas:1000");
}

namespace {

constexpr std::string_view package_prefix = "package:";

constexpr SharedFolder shared[] = {
    {"glmark2-data", "/usr/share/glmark2/models"},
    {"openclipart-svg", "/usr/share/openclipart/svg"},
    {"assimp-testmodels", "/usr/share/assimp/models"},
};

}  // namespace

std::span<const SharedFolder> shared_folders() {
    return shared;
}

bool in_package(std::string_view name) {
    return name.starts_with(package_prefix);
}

std::filesystem::path package_file(std::string_view name) {
    const auto refuse = [&](const std::string& why) {
        throw lod::Error(lod::ErrorKind::input_refused, std::string(name) + ": " + why);
    };
    const std::string_view rest = name.substr(package_prefix.size());
    const std::string_view package = rest.substr(0, rest.find('/'));
    const auto* place = std::find_if(std::begin(shared), std::end(shared),
                                     [&](const auto& one) { return one.package == package; });
    if (place == std::end(shared)) {
        std::vector<std::string_view> packages;
        for (const SharedFolder& one : shared) packages.push_back(one.package);
        refuse("no such package" + did_you_mean(package, packages) + "; write package:NAME/FILE, " +
               "NAME being one of " + listed(packages));
    }
    const std::filesystem::path inside =
        rest.size() > package.size() ? rest.substr(package.size() + 1) : std::string_view();
    const auto normal = inside.lexically_normal();
    if (inside.empty() || inside.is_absolute() || *normal.begin() == "..")
        refuse("names no file of the package; write package:NAME/FILE");
    std::error_code ignored;
    const std::filesystem::path folder(place->folder);
    if (!std::filesystem::is_directory(folder, ignored))
        throw lod::Error(lod::ErrorKind::not_installed,
                         std::string(name) + ": the package is not installed; sudo apt-get " +
                             "install -y " + std::string(package));
    if (!std::filesystem::exists(folder / normal, ignored))
        refuse("there is no such file in " + folder.string() + "; check the name");
    return folder / normal;
}

std::vector<std::string> shapes_in(const std::string& list) {
    std::vector<std::string> shapes;
    for (const std::string& part : parted(list, ',')) {
        const bool number = !part.empty() && std::string_view("0123456789-.").find(part[0]) !=
                                                 std::string_view::npos;
        const bool goes_on =
            number && !shapes.empty() && shapes.back().find(':') != std::string::npos;
        if (goes_on)
            shapes.back().append(",").append(part);
        else if (!part.empty())
            shapes.push_back(part);
    }
    return shapes;
}

bool looks_like_file(std::string_view name) {
    const std::string ending = lod::ending_of(name);
    return name.find('/') != std::string_view::npos || ending == "svg" ||
           lod3d::is_mesh_format(ending);
}

}  // namespace scenes
