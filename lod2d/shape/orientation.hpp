#pragma once

#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// On which side of the line from a to b the point c lies: +1 to the left, -1 to the right, 0 on
/// it. Exact for every finite input whose products neither overflow nor underflow (Shewchuk 1997: a
/// filter in doubles, then a sum without rounding).
[[nodiscard]] int orientation(const Point& a, const Point& b, const Point& c);

/// Whether c lies between a and b on their segment, ends included. Exact.
[[nodiscard]] bool on_segment(const Point& a, const Point& b, const Point& c);

/// Whether the closed segments ab and cd share a point. Exact; segments may be points.
[[nodiscard]] bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace lod2d
