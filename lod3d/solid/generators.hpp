#pragma once

#include "lodlab/core/base/generator.hpp"
#include "lodlab/lod3d/solid/solid.hpp"

namespace lod3d {

/// Every named solid, in the order in which a reader should meet them.
[[nodiscard]] std::span<const lod::Generator<Mesh>> solid_generators();

/// Makes "gear:9", "box:2,1,1", "knot", ... Closed, manifold and oriented outwards. Unless a
/// parameter sets it, the longest side of the bounding box is about 1 m. Curved surfaces have their
/// vertices on the surface. The same spec gives the same bits everywhere. Throws lod::Error: usage
/// where the spec is not understood (naming what is), input refused where a number is out of its
/// range (naming the range).
[[nodiscard]] Solid solid_from_spec(std::string_view spec);

}  // namespace lod3d
