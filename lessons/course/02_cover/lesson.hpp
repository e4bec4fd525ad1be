#pragma once

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/lod2d/builder/piece.hpp"

namespace lessons::cover {

using Circles = std::vector<lod::Sphere<2>>;
using Vec = lod::Vector<2>;

constexpr double bound = 1e-12;  ///< what rounding can do to a radius here, and more [m]
constexpr double shrunk = 0.6;   ///< what is left of the radius of a circle that is too small

/// Whether each circle holds the piece of the shape that it answers for.
[[nodiscard]] bool covers(const Circles& circles, const lod2d::PolygonPiece& shape);

/// The corners of a piece, each once.
[[nodiscard]] std::vector<Vec> corners_of(const lod2d::PolygonPiece& piece);

/// What is seen on a plank of 4 m by 1 m (plank.cpp).
void give_plank(Lesson& lesson);

}  // namespace lessons::cover
