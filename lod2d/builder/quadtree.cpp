#include "lodlab/lod2d/builder/quadtree.hpp"

#include "lodlab/core/builder/grid_tree.hpp"

namespace lod2d {

lod::SphereTree<2> build_quadtree(const PolygonPiece& whole, const lod::GrowSettings& settings) {
    lod::check_grow_settings(settings);
    return lod::grow_grid_tree<2>(whole, settings.depth, settings.progress);
}

}  // namespace lod2d
