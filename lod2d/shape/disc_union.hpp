#pragma once

#include <span>
#include <vector>

#include "lodlab/core/math/sphere.hpp"
#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// A part of a disc's border that no other disc covers, anticlockwise.
struct Arc {
    std::size_t disc = 0;
    double from = 0;  ///< angle [rad]
    double to = 0;    ///< > from, at most one turn more

    [[nodiscard]] Point at(const lod::Sphere<2>& of, double angle) const;
};

/// The border of a union of discs. Of equal discs the first counts.
[[nodiscard]] std::vector<Arc> exposed_arcs(std::span<const lod::Sphere<2>> discs);

/// Area of a union of discs, by Green's theorem over its arcs: exact up to rounding [m^2].
[[nodiscard]] double union_area(std::span<const lod::Sphere<2>> discs, std::span<const Arc> arcs);

}  // namespace lod2d
