#include "lod2d/protrusion.hpp"

namespace lod2d {

double protrusion_bound(const BoundaryIndex& shape, const lod::Sphere<2>& disc) {
    return lod::protrusion_bound<2>(shape, disc);
}

Protrusion find_protrusion(const BoundaryIndex& shape, std::span<const lod::Sphere<2>> discs,
                           double tolerance, int most_queries) {
    return lod::find_protrusion<2>(shape, discs, tolerance, most_queries);
}

}  // namespace lod2d
