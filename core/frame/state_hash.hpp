#pragma once

/// \file
/// A hash of bodies, or of a tree, to compare two runs bit for bit.

#include <cstdint>
#include <span>

#include "lodlab/core/tree/body.hpp"

namespace lod {

/// FNV-1a over the bits of every body's position, orientation, velocity and spin, in order. Two
/// runs of a scene that agree in every bit have the same hash, whatever the compiler.
template <int Dim>
[[nodiscard]] std::uint64_t state_hash(std::span<const Body<Dim>> bodies);

/// The same over every number of a tree: balls, mean normals and who is whose child.
template <int Dim>
[[nodiscard]] std::uint64_t tree_hash(const SphereTree<Dim>& tree);

}  // namespace lod
