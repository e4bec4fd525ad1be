// Plays every scene of the plane by the calls that a page makes, and writes what came of it.
//
// Usage: play_scenes FOLDER    FOLDER/NAME.json: the scene; FOLDER/NAME.txt: a line after each
// turn, the
//                              hash of the state and the SHA-256 of the figure
// tests/live/play_scenes.js makes the same turns by the module.

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/io/sha256.hpp"
#include "lodlab/live/module.hpp"
#include "lodlab/live/take.hpp"
#include "lodlab/scenes/places.hpp"

namespace {

void need(bool done) {
    if (!done) throw std::runtime_error(lodlab_live_error());
}

std::string line_of(lodlab_live* live) {
    const std::string state = lodlab_live_state(live);
    const std::string key = "\"hash\":\"";
    return state.substr(state.find(key) + key.size(), 16) + " " +
           io::sha256(lodlab_live_figure(live)) + "\n";
}

std::string played(const std::string& scene) {
    lodlab_live* live = lodlab_live_open(scene.c_str());
    need(live != nullptr);
    std::string lines = line_of(live);
    const auto turn = [&](int frames) {
        need(lodlab_live_step(live, frames) == 0);
        lines += line_of(live);
    };
    turn(100);
    need(lodlab_live_set(live, "level", 1) == 0);
    need(lodlab_live_place(live, 0, 0.125, -0.25, 0.5) == 0);
    turn(60);
    need(lodlab_live_set(live, "level", 1000) == 0);
    need(lodlab_live_set(live, "budget", 40) == 0);
    need(lodlab_live_set(live, "pair_cost", 2) == 0);
    need(lodlab_live_choose(live, "policy", "perceptual") == 0);
    need(lodlab_live_fixate(live, 0.5, 0.25) == 0);
    turn(60);
    need(lodlab_live_set(live, "restitution", 0.5) == 0);
    need(lodlab_live_choose(live, "contact_model", "node_normal") == 0);
    need(lodlab_live_choose(live, "response", "sum") == 0);
    need(lodlab_live_move(live, 1, -1, 0.5, 2) == 0);
    turn(60);
    need(lodlab_live_reset(live) == 0);
    lines += line_of(live);
    lodlab_live_close(live);
    return lines;
}

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
    for (const std::string& name : scenes::names()) {
        if (scenes::load_scene(scenes::scene_file(name)).dim != 2) continue;
        try {
            const std::string scene = scene_named(name);
            lod::write_text_file(folder / (name + ".json"), scene);
            lod::write_text_file(folder / (name + ".txt"), played(scene));
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
            return 1;
        }
    }
    return 0;
}
