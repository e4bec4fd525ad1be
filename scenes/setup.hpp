#pragma once

/// \file
/// From a scene file's data to bodies that can move: shapes loaded, trees built.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lodlab/scenes/scene.hpp"
#include "lodlab/scenes/shapes.hpp"

namespace scenes {

/// A scene, ready to run: shapes loaded, trees built, masses exact.
/// Entry k of `bodies` and `shapes` belongs to scene.bodies[k]. Bodies with the same shape, size
/// and tree settings share one shape and one tree.
template <int Dim>
struct Setup {
    Scene scene;
    std::vector<lod::Body<Dim>> bodies;
    std::vector<std::shared_ptr<const Shape<Dim>>> shapes;
    /// One line each: bodies that start inside each other, what of a shape is not exact.
    std::vector<std::string> warnings;
};

/// How shapes are read and trees found.
struct SetupOptions {
    double raise_limits = 1;  ///< factor of the limits on the size of shape files, >= 1
    io::TreeCache cache{};    ///< where trees that were built before are found
    std::function<void(double share)> progress{};  ///< 0 to 1, never decreasing
};

/// Throws lod::Error, naming the body's place in the file, when a shape or its tree is refused.
/// Requires: scene.dim is Dim.
template <int Dim>
[[nodiscard]] Setup<Dim> set_up(const Scene& scene, const SetupOptions& options = {});

}  // namespace scenes
