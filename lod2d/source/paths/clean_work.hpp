#pragma once

#include <cstdint>
#include <span>

#include "lodlab/lod2d/source/paths/clean.hpp"

namespace lod2d {

/// How many pairs of edges have boxes that meet, neighbours left out; stops counting past `most`.
[[nodiscard]] std::uint64_t count_edge_pairs(const Polygon& rings, std::uint64_t most);

/// How many pairs of edges cross, or lie on one another over more than a point; stops counting past
/// `most`.
[[nodiscard]] std::uint64_t count_crossings(const Polygon& rings, std::uint64_t most);

/// How many edges a sweep along an axis (0: x, 1: y) passes, summed over its stops at the points.
[[nodiscard]] std::uint64_t count_sweep_steps(const Polygon& rings, int axis);

/// Whether two edges cross, or lie on one another over more than a point. Exact.
[[nodiscard]] bool crosses_itself(const Polygon& rings);

}  // namespace lod2d
