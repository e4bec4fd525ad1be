// Plays every scene of the plane by the calls that a page makes, and writes what came of it.
//
// Usage: play_scenes FOLDER    FOLDER/NAME.json: the scene; FOLDER/NAME.txt: a line after each
// turn, the
//                              hash of the state and the SHA-256 of the figure
// tests/live/play_scenes.js makes the same turns by the module.

#include <cstdio>
#include <filesystem>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/live/sources.hpp"
#include "lodlab/live/take.hpp"
#include "lodlab/scenes/places.hpp"
#include "tests/live/played.hpp"

namespace {

/// The scene as pages hold it, with shallow trees.
std::string scene_named(const std::string& name) {
    scenes::Scene scene = scenes::load_scene(scenes::scene_file(name));
    for (scenes::BodySpec& body : scene.bodies) body.depth = 3;
    return live::scene_text(live::scene_of(scenes::set_up<2>(scene)));
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    const std::filesystem::path folder = arguments[1];
    std::filesystem::create_directories(folder);
    lod::write_text_file(folder / "sources", live::sources());
    for (const std::string& name : scenes::names()) {
        if (scenes::load_scene(scenes::scene_file(name)).dim != 2) continue;
        try {
            const std::string scene = scene_named(name);
            lod::write_text_file(folder / (name + ".json"), scene);
            lod::write_text_file(folder / (name + ".txt"), lodtest::played(scene));
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
            return 1;
        }
    }
    return 0;
}
