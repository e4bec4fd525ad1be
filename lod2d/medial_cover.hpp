#pragma once

#include <span>
#include <vector>

#include "core/sphere.hpp"
#include "lod2d/shape.hpp"

namespace lod2d {

/// Chooses at most `count` of the discs which, with their radii grown by an allowance as small as a
/// greedy choice finds, hold all the points. Each comes back grown by what its own points need.
/// Cover by discs of equal allowance is k-centre with the distance |q - c| - r.
[[nodiscard]] std::vector<lod::Sphere<2>> least_growth_cover(std::span<const Point> points,
                                                             std::span<const lod::Sphere<2>> discs,
                                                             int count);

}  // namespace lod2d
