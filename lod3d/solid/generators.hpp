#pragma once

/// \file
/// Solids by name: "gear:9", "box:2,1,1", "knot". `lodlab tree --list` shows all.

#include <span>
#include <string_view>

#include "lodlab/core/base/generator.hpp"
#include "lodlab/lod3d/solid/solid.hpp"

namespace lod3d {

using lod::GeneratorParameter;
/// A mesh made from a name and a few numbers.
using Generator = lod::Generator<Mesh>;

/// Every generator, in the order in which a reader should meet them.
[[nodiscard]] std::span<const Generator> generators();

/// Whether the spec begins with a generator's name.
[[nodiscard]] bool names_generator(std::string_view spec);

/// Makes "gear:9", "box:2,1,1", "knot", ... Closed, manifold and oriented outwards. Unless a
/// parameter sets it, the longest side of the bounding box is about 1 m. Curved surfaces have their
/// vertices on the surface. The same spec gives the same bits everywhere. Throws lod::Error: usage
/// where the spec is not understood (naming what is), input refused where a number is out of its
/// range (naming the range).
[[nodiscard]] Solid generate(std::string_view spec);

}  // namespace lod3d
