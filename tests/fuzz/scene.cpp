// Scene files: TOML, its keys, and the settings that follow.
#include "lodlab/scenes/run.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return try_reading(bytes, size, [](std::string_view text) {
        const scenes::Scene scene = scenes::parse_scene(text, "/nowhere/scene.toml");
        static_cast<void>(scenes::frame_settings(scene, scene.limits));
    });
}
