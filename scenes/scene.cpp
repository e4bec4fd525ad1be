#include "lodlab/scenes/scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/scenes/keys.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/spelling.hpp"

namespace scenes {
namespace {

constexpr std::size_t most_bytes = 16'000'000;

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
    throw lod::Error(lod::ErrorKind::input_refused, where + ": " + why);
}

/// Lets every entry of the table be read by the key of its name.
template <class Target>
void read_table(const TomlTable& table, std::span<const Key<Target>> keys, std::string_view section,
                Target& target, Reading& reading) {
    for (const TomlEntry& entry : table.entries) {
        const auto key = std::find_if(keys.begin(), keys.end(),
                                      [&](const Key<Target>& k) { return k.name == entry.key; });
        if (key == keys.end()) {
            std::vector<std::string_view> names;
            for (const Key<Target>& known : keys) names.push_back(known.name);
            refuse(entry.where, "unknown key " + entry.key + " in " + std::string(section) +
                                    did_you_mean(entry.key, names) +
                                    "; scenes/README.md lists all");
        }
        key->read(entry, target, reading);
    }
}

/// Where the shape names a file beside the scene, finds it.
std::filesystem::path shape_file(const BodySpec& body, const std::filesystem::path& scene) {
    if (body.shape.starts_with("text:") || in_package(body.shape) || !looks_like_file(body.shape))
        return {};
    const std::filesystem::path named(body.shape);
    const auto folder =
        std::filesystem::weakly_canonical(std::filesystem::absolute(scene)).parent_path();
    const auto file = std::filesystem::weakly_canonical(folder / named);
    const auto inside = file.lexically_relative(folder);
    if (named.is_absolute() || inside.empty() || *inside.begin() == "..")
        refuse(
            body.where,
            "shape " + body.shape +
                " lies outside the folder of the scene; copy the file beside the scene, or name a "
                "file of a package as in package:glmark2-data/bunny.obj");
    if (!std::filesystem::exists(file))
        refuse(body.where, "there is no shape file " + file.string() + "; check the name");
    return scene.parent_path() / named;
}

/// It has no extent that could be chosen, and never moves.
void complete_half_space(BodySpec& body) {
    const auto drop = [&](bool given, const char* key) {
        if (given)
            refuse(body.where, "body " + body.name + " is a half-space, which has no " + key +
                                   "; drop the key");
    };
    drop(body.size.has_value(), "size");
    drop(body.mass.has_value(), "mass");
    drop(body.fill, "mesh to fill");
    drop(body.strokes || body.page || body.strict, "drawing");
    drop(!body.sha256.empty(), "file");
    body.is_static = true;
}

void complete(BodySpec& body, std::size_t number, const std::filesystem::path& path,
              std::set<std::string>& names) {
    if (body.shape.empty())
        refuse(body.where, "the body has no shape; add shape = \"box\", for example");
    if (body.name.empty()) body.name = "body " + std::to_string(number);
    if (!names.insert(body.name).second)
        refuse(body.where, "a second body is called " + body.name + "; give it another name");
    if (body.shape == half_space_name) complete_half_space(body);
    if (body.is_static && (body.velocity != Triple{} || body.spin != Triple{}))
        refuse(body.where,
               "body " + body.name + " is static and has a velocity or a spin; drop one of them");
    body.file = shape_file(body, path);
}

const TomlEntry* find(const TomlTable& table, std::string_view key) {
    for (const TomlEntry& entry : table.entries)
        if (entry.key == key) return &entry;
    return nullptr;
}

}  // namespace

std::int64_t Scene::frames() const {
    return std::max<std::int64_t>(1, std::llround(std::ceil(duration / time_step - 1e-9)));
}

Scene parse_scene(std::string_view text, const std::filesystem::path& path) {
    const TomlTable document = parse_toml(text, path);
    Scene scene;
    scene.name = path.stem().string();
    Reading reading;
    const Defaults& defaults = reading.defaults;
    // dim says how long vectors are, so it comes first wherever it stands.
    if (const TomlEntry* dim = find(document, "dim")) reading.dim = read_dim(*dim);
    read_table<Scene>(document, scene_keys(), "the scene", scene, reading);

    std::set<std::string> names;
    for (const TomlTable& table : reading.bodies) {
        BodySpec body;
        body.where = table.where;
        body.restitution = defaults.restitution;
        body.density = defaults.density;
        body.builder = defaults.builder;
        body.branching = defaults.branching;
        body.depth = defaults.depth;
        read_table<BodySpec>(table, body_keys(), "a body", body, reading);
        complete(body, scene.bodies.size() + 1, path, names);
        scene.bodies.push_back(std::move(body));
    }
    for (const TomlTable& table : reading.cameras) {
        Camera camera;
        read_table<Camera>(table, camera_keys(), "the camera", camera, reading);
        if (camera.width == 0 && scene.dim == 2)
            refuse(table.where, "the camera has no width; add width = 4, for example");
        scene.camera = camera;
    }
    if (scene.bodies.empty())
        refuse(path.string() + ":1:1", "the scene has no body; add a [[body]] with a shape");
    return scene;
}

Scene load_scene(const std::filesystem::path& path) {
    return parse_scene(lod::read_text_file(path, most_bytes), path);
}

}  // namespace scenes
