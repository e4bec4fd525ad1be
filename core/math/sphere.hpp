#pragma once

/// \file
/// A ball: a disc in the plane, a sphere in space; and whether two of them overlap.

#include "lodlab/core/math/dimension.hpp"

namespace lod {

/// A ball: a disc in the plane, a sphere in space. Metres.
template <int Dim>
struct Sphere {
    Vector<Dim> centre = Vector<Dim>::Zero();
    double radius = 0;  ///< >= 0
};

/// Whether two balls share a point: the distance test at the heart of the method (section 3).
/// Balls that only touch overlap.
template <int Dim>
[[nodiscard]] bool overlap(const Sphere<Dim>& a, const Sphere<Dim>& b) {
    const double reach = a.radius + b.radius;
    return (b.centre - a.centre).squaredNorm() <= reach * reach;
}

}  // namespace lod
