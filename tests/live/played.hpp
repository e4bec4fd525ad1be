#pragma once

#include <stdexcept>
#include <string>

#include "lodlab/io/sha256.hpp"
#include "lodlab/live/module.hpp"

// A scene played by the calls that a page makes; tests/live/play_scenes.js makes the same turns by
// the module.
namespace lodtest {

inline constexpr int most_events = 60;  // of a frame that are looked at

inline void need(bool done) {
    if (!done) throw std::runtime_error(lodlab_live_error());
}

inline std::string line_of(lodlab_live* live) {
    const std::string state = lodlab_live_state(live);
    const std::string key = "\"hash\":\"";
    return state.substr(state.find(key) + key.size(), 16) + " " +
           io::sha256(lodlab_live_figure(live)) + "\n";
}

/// A line after each turn, and at events of the next frame: the hash of the state and the SHA-256
/// of the figure.
inline std::string played(const std::string& scene) {
    lodlab_live* live = lodlab_live_open(scene.c_str());
    need(live != nullptr);
    std::string lines = line_of(live);
    const auto turn = [&](int frames) {
        need(lodlab_live_step(live, frames) == 0);
        lines += line_of(live);
        lines += io::sha256(lodlab_live_events(live)) + "\n";
        for (int event = 0; event < most_events; event += event < 12 ? 1 : 7) {
            if (lodlab_live_set(live, "event", event) != 0) break;
            lines += line_of(live);
        }
        need(lodlab_live_set(live, "event", -1) == 0);
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
    static_cast<void>(lodlab_live_move(live, 1, -1, 0.5, 2));  // refused where there is no body 1
    turn(60);
    need(lodlab_live_reset(live) == 0);
    lines += line_of(live);
    lodlab_live_close(live);
    return lines;
}

}  // namespace lodtest
