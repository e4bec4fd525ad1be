#pragma once

#include <span>
#include <string_view>

#include "lodlab/scenes/scene.hpp"
#include "lodlab/scenes/toml/toml_document.hpp"

namespace scenes {

/// What the scene says for all bodies that do not say it themselves.
struct Defaults {
    double restitution = 1;
    double density = 1;
    std::string builder;
    std::optional<int> branching;
    std::optional<int> depth;
};

/// What is met while the top of a scene file is read and used after it.
struct Reading {
    int dim = 2;
    Defaults defaults;
    std::vector<TomlTable> bodies;
    std::vector<TomlTable> cameras;
};

/// One key of a scene file: what the documentation says of it and how it is read.
template <class Target>
struct Key {
    std::string_view name;
    std::string_view unit;
    std::string_view otherwise;  ///< the default
    void (*read)(const TomlEntry& entry, Target& target, Reading& reading);
};

[[nodiscard]] std::span<const Key<Scene>> scene_keys();
[[nodiscard]] std::span<const Key<BodySpec>> body_keys();
[[nodiscard]] std::span<const Key<Camera>> camera_keys();

/// 2 or 3: it says how long vectors are, so it is read first.
[[nodiscard]] int read_dim(const TomlEntry& entry);

}  // namespace scenes
