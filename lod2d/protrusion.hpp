#pragma once

#include <span>

#include "core/builder/protrusion.hpp"
#include "lod2d/distance.hpp"

namespace lod2d {

using Protrusion = lod::Protrusion<2>;

/// See lod::protrusion_bound and lod::find_protrusion.
[[nodiscard]] double protrusion_bound(const BoundaryIndex& shape, const lod::Sphere<2>& disc);
[[nodiscard]] Protrusion find_protrusion(const BoundaryIndex& shape,
                                         std::span<const lod::Sphere<2>> discs, double tolerance,
                                         int most_queries = 2'000'000);

}  // namespace lod2d
