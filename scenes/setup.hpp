#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lod2d/build_tree.hpp"
#include "lod2d/shape.hpp"
#include "scenes/scene.hpp"

namespace scenes {

/// A scene of the plane, ready to run: shapes loaded, trees built, masses exact.
/// Entry k of `bodies` and `shapes` belongs to scene.bodies[k]. Bodies with the same shape, size
/// and tree settings share one shape and one tree.
struct Setup {
    Scene scene;
    std::vector<lod::Body<2>> bodies;
    std::vector<std::shared_ptr<const lod2d::Shape>> shapes;
    std::vector<std::string> warnings;  ///< one line each: bodies that start inside each other
};

/// Throws lod::Error, naming the body's place in the file, when a shape or its tree is refused.
/// Limits on the size of shape files are multiplied by `raise_limits`, >= 1.
[[nodiscard]] Setup set_up(const Scene& scene, double raise_limits = 1);

/// A shape by its name: a file, "text:R", or a generator. `size`: longer side of its box [m];
/// nothing: 1 m for files and texts, as its numbers say for a generator.
/// Throws lod::Error as lod2d::load_shape does.
[[nodiscard]] lod2d::Shape shape_named(const std::string& spec, std::optional<double> size = {},
                                       double raise_limits = 1);

/// How a tree is built: the builders' defaults where nothing is said (an empty builder).
/// Throws lod::Error (usage) for an unknown builder.
[[nodiscard]] lod2d::TreeSettings tree_settings(const std::string& builder,
                                                std::optional<int> branching,
                                                std::optional<int> depth);

}  // namespace scenes
