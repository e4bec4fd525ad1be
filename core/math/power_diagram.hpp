#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lodlab/core/math/half_space.hpp"
#include "lodlab/core/math/sphere.hpp"

namespace lod {

/// The half-spaces whose intersection is the power cell of balls[own]: where |x - c|^2 - r^2 is
/// least for this ball. Seen from the other side a border has exactly the opposite numbers, so that
/// two cells clipped from one piece share their cut points to the last bit. Of balls that are equal
/// the first owns the cell, and the others' cells are empty.
template <int Dim>
[[nodiscard]] std::vector<HalfSpace<Dim>> power_cell(std::span<const Sphere<Dim>> balls,
                                                     std::size_t own);

}  // namespace lod
