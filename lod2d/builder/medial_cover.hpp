#pragma once

#include <span>
#include <vector>

#include "lodlab/core/math/sphere.hpp"
#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// A point to be held, or a disc to hold it, and the outward unit normal of the border there; zero
/// where there is none.
struct FacingPoint {
    Point at = {0, 0};
    Point normal = {0, 0};
};
struct FacingDisc {
    lod::Sphere<2> disc;
    Point normal = {0, 0};
};

/// Chooses at most `count` of the discs which, with their radii grown by an allowance as small as a
/// greedy choice finds, hold all the points. Each comes back grown by what its own points need.
/// Cover by discs of equal allowance is k-centre with the distance |q - c| - r, to which
/// normal_weight r (1 - cos)/2 is added, of the angle between the two normals.
[[nodiscard]] std::vector<lod::Sphere<2>> least_growth_cover(std::span<const FacingPoint> points,
                                                             std::span<const FacingDisc> discs,
                                                             int count, double normal_weight = 0);

}  // namespace lod2d
