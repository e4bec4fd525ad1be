#pragma once

/// \file
/// The sphere tree of a solid: one call, and its settings.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

#include "lodlab/core/base/names.hpp"
#include "lodlab/core/tree/tree.hpp"
#include "lodlab/lod3d/solid/solid.hpp"

namespace lod3d {

/// How a sphere tree is made.
enum class Builder {
    octree,  ///< cubes halved, a sphere round each that holds some of the solid: the classical one
    cover,   ///< spheres searched for, so that they stand out little on their level and the next
};

/// Their words in scenes, options and messages.
[[nodiscard]] constexpr std::array<std::string_view, 2> names_of(Builder) {
    return {"octree", "cover"};
}
static_assert(names_of(Builder{}).size() == static_cast<std::size_t>(Builder::cover) + 1);

/// How a sphere tree is built.
struct TreeSettings {
    Builder builder = Builder::cover;
    int branching = 8;  ///< most children of a node, 2 to 64; the octree has 8 always
    int depth = 3;      ///< levels below the root, 0 to 12; branching^depth is at most 1048576
    /// A node that stands out of the solid by no more than this share of the root sphere's diameter
    /// is not divided further: an error target. 0 to 1. The octree has none.
    double least_protrusion = 1e-7;
    /// How long the cover searches: its random starts are this times the usual number. With 0.1 it
    /// takes a quarter of the time, and spheres stand out up to a third further. 0 to 100.
    double effort = 1;
    /// Levels that would take the whole tree beyond so many nodes are left out. 0: no such limit.
    std::int64_t most_nodes = 0;
    /// Called with the share of the work done, 0 to 1, never decreasing.
    std::function<void(double)> progress{};
};

/// A sphere tree of the solid, body frame, whose coverage is certified: at every level each point
/// of the solid, surface and interior, lies in a chain of spheres from the root to a node of the
/// level or a leaf above it (core/builder/certify.hpp). Deterministic.
/// Throws lod::Error: limit exceeded where a setting is out of range, input refused where rounding
/// leaves a tree without its certificate.
[[nodiscard]] lod::SphereTree<3> build_tree(const Solid& solid, const TreeSettings& settings = {});

}  // namespace lod3d
