#pragma once

/// \file
/// A rigid shape of the plane: a polygon with holes in its body frame, with its area, inertia and
/// centre of mass.

#include <string>
#include <vector>

#include "lodlab/core/math/box.hpp"

namespace lod2d {

/// A point of the plane [m].
using Point = lod::Vector<2>;
using Ring =
    std::vector<Point>;  ///< closed: the last point joins the first; no point twice in a row

/// A region of the plane: outer rings anticlockwise, holes clockwise. Rings are simple, do not
/// cross each other (they may touch in single points), and bound a region of positive area. Metres.
struct Polygon {
    std::vector<Ring> rings;
};

/// A box of the plane [m].
using Box = lod::Box<2>;

[[nodiscard]] double polygon_area(const Polygon& polygon);  ///< by Green's theorem [m^2]
/// Polar second moment of area about the origin, by Green's theorem [m^4].
[[nodiscard]] double polar_moment(const Polygon& polygon);
[[nodiscard]] Box bounds(const Polygon& polygon);  ///< empty for an empty polygon

/// A rigid shape in its body frame: the origin is the centre of mass.
struct Shape {
    std::string name;         ///< what the reader calls it: "gear:9", "text:R", a file's stem
    Polygon polygon;          ///< body frame [m]
    double area = 0;          ///< exact [m^2], > 0
    Point centroid = {0, 0};  ///< centre of mass in the frame of the source [m]
    double second_moment =
        0;  ///< polar, about the centre of mass [m^4]; times the density: inertia
    /// What of the source is left out or taken in another way, and how it was read: a line each.
    std::vector<std::string> remarks;
};

/// Centres a polygon on its centre of mass and takes its exact integrals.
/// Throws lod::Error (input refused) where the polygon is empty, not finite or has no area (less
/// than 1e-12 of the square about it). Requires: rings as Polygon says; only the whole area is
/// checked. For raw outlines see lod2d/source/paths/clean.hpp (library lod2d_source).
[[nodiscard]] Shape make_shape(std::string name, const Polygon& polygon);

}  // namespace lod2d
