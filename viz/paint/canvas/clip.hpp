#pragma once

#include <vector>

#include "lodlab/viz/paint/canvas/canvas.hpp"

namespace viz {

/// The parts of an open line that lie within a rectangle, in order.
[[nodiscard]] std::vector<Ring> clipped_line(const std::vector<Point>& line, const Rect& to);

/// The part of a ring within a rectangle, closed along its border; empty when nothing is left.
[[nodiscard]] Ring clipped_ring(const Ring& ring, const Rect& to);

/// A huge disc as a ring that agrees with it within the rectangle; empty when it lies outside, the
/// rectangle's own ring when it covers all of it.
[[nodiscard]] Ring clipped_disc(Point centre, double radius, const Rect& to);

/// The share of the segment p-q within the rectangle, as parameters from 0 to 1; false when none
/// is.
[[nodiscard]] bool clip_segment(Point p, Point q, const Rect& to, double& from, double& until);

[[nodiscard]] Rect grown(const Rect& rect, double by);
[[nodiscard]] bool contains(const Rect& rect, Point p);

}  // namespace viz
