#include "lodlab/lod2d/builder/build_tree.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/builder/complete_tree.hpp"
#include "lodlab/core/builder/grow.hpp"
#include "lodlab/lod2d/builder/medial.hpp"
#include "lodlab/lod2d/builder/pieces.hpp"
#include "lodlab/lod2d/builder/quadtree.hpp"
#include "lodlab/lod2d/shape/distance.hpp"

namespace lod2d {
namespace {

lod::SphereTree<2> grow_circles(const Shape& shape, const PolygonPiece& whole,
                                const BoundaryIndex& index, const TreeSettings& settings) {
    if (settings.builder == Builder::quadtree && settings.branching != 4)
        throw lod::Error(lod::ErrorKind::usage,
                         "a quadtree has branching 4; choose that or another builder");
    lod::GrowSettings grow = lod::grow_settings_of(settings);
    if (settings.builder == Builder::quadtree) return build_quadtree(whole, grow);
    if (settings.builder == Builder::pieces) return build_pieces(whole, index, grow);
    grow.normal_weight = settings.normal_weight;
    return build_medial(shape.polygon, whole, index, {.grow = grow});
}

}  // namespace

lod::SphereTree<2> build_tree(const Shape& shape, const TreeSettings& settings) {
    const PolygonPiece whole(shape.polygon);
    const BoundaryIndex index(shape.polygon);
    return lod::complete_tree<2>(grow_circles(shape, whole, index, settings), shape.name, whole,
                                 index);
}

}  // namespace lod2d
