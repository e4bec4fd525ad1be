#pragma once

/// \file
/// Shapes by name: "gear:9", "star:5", "L". `lodlab tree --list` shows all.

#include <span>
#include <string_view>

#include "lodlab/core/base/generator.hpp"
#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

using lod::GeneratorParameter;
/// A shape made from a name and a few numbers.
using Generator = lod::Generator<Polygon>;

/// Every generator, in the order in which a reader should meet them.
[[nodiscard]] std::span<const Generator> generators();

/// Whether the spec begins with a generator's name.
[[nodiscard]] bool names_generator(std::string_view spec);

/// Makes "gear:9", "box:2,1", "L", ... Unless a parameter sets it, the longer side of the shape's
/// bounding box is about 1 m (gear, star, disc, ring, polygon: the diameter of their outer circle
/// is 1 m). Curves have their vertices on the curve. The same spec gives the same bits everywhere.
/// Throws lod::Error: usage where the spec is not understood (naming what is), input refused where
/// a number is out of its range (naming the range).
[[nodiscard]] Shape generate(std::string_view spec);

}  // namespace lod2d
