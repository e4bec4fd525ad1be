#pragma once

/// \file
/// Scenes of many bodies that are made, not written: "gas:1000", "implode:500,3".

#include <span>
#include <string>
#include <string_view>

#include "lodlab/core/base/generator.hpp"
#include "lodlab/scenes/scene.hpp"

namespace scenes {

using lod::GeneratorParameter;
/// A scene made from a name, a number of bodies and a seed.
using Crowd = lod::Generator<Scene>;

/// Every crowd. Those of the plane are stars, gears and Ls in turn, each within a circle of half a
/// metre; that of space is bunnies. Half-spaces keep them in; nothing overlaps at the start. The
/// same spec gives the same bits everywhere.
[[nodiscard]] std::span<const Crowd> crowds();

/// Whether the spec begins with a crowd's name and a colon.
[[nodiscard]] bool names_crowd(std::string_view spec);

/// Makes "gas:1000". Throws lod::Error: usage where the spec is not understood (naming what is),
/// input refused where a number is out of its range (naming the range).
[[nodiscard]] Scene crowd(std::string_view spec);

/// A scene as the user names it: a file, one that comes with lodlab, or a crowd. Throws as
/// scene_file, load_scene and crowd do.
[[nodiscard]] Scene named_scene(const std::string& name);

}  // namespace scenes
