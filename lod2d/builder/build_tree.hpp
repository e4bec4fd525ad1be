#pragma once

/// \file
/// The circle tree of a shape: one call, and its settings.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

#include "lodlab/core/base/names.hpp"
#include "lodlab/core/tree/tree.hpp"
#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// How a circle tree is made.
enum class Builder {
    quadtree,  ///< squares halved, a circle round each that holds some of the shape: the classical
               ///< one
    pieces,    ///< power diagram and fit, from geometric starts
    medial,    ///< the same from circles on the medial axis too; the default, since it fits best
};

/// Their words in scenes, options and messages.
[[nodiscard]] constexpr std::array<std::string_view, 3> names_of(Builder) {
    return {"quadtree", "pieces", "medial"};
}
static_assert(names_of(Builder{}).size() == static_cast<std::size_t>(Builder::medial) + 1);

/// How a circle tree is built.
struct TreeSettings {
    Builder builder = Builder::medial;
    int branching = 4;  ///< most children of a node, 2 to 64; the quadtree has 4 always
    int depth = 4;      ///< levels below the root, 0 to 12; branching^depth is at most 1048576
    /// A node that stands out of the shape by no more than this share of the root circle's diameter
    /// is not divided further. 0 to 1.
    double least_protrusion = 1e-7;
    /// Levels that would take the whole tree beyond so many nodes are left out. 0: no such limit.
    std::int64_t most_nodes = 0;
    /// Medial only: how much a circle costs whose border faces many ways, 0 to 100. The mean
    /// normals of nodes decide the response (the contact model), and circles of the
    /// medial axis touch two sides. At depth 5, worst protrusion in % of the diameter, and
    /// coherence over the border:
    ///     box 0.001, 0.71 with 0; 0.158, 1.00 with 0.1    (quadtree 0.458, 0.98)
    ///     gear:9 0.136, 0.78 with 0; 0.338, 0.94 with 0.1 (quadtree 4.28, 0.97)
    double normal_weight = 0.1;
    /// Called with the share of the work done, 0 to 1, never decreasing.
    std::function<void(double)> progress{};
};

/// A circle tree of the shape, body frame, whose coverage is certified: at every level each point
/// of the shape lies in a chain of circles from the root to a node of the level or a leaf above it
/// (core/builder/certify.hpp). Deterministic. The root is the least enclosing circle.
/// Throws lod::Error: limit exceeded where a setting is out of range, input refused where rounding
/// leaves a tree without its certificate (never seen).
[[nodiscard]] lod::SphereTree<2> build_tree(const Shape& shape, const TreeSettings& settings = {});

}  // namespace lod2d
