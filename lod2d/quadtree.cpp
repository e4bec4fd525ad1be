#include "lod2d/quadtree.hpp"

#include "core/builder/grid_tree.hpp"

namespace lod2d {

lod::SphereTree<2> build_quadtree(const PolygonPiece& whole, const QuadtreeConfig& config) {
    lod::GrowSettings limits;
    limits.depth = config.depth;
    lod::check_grow_settings(limits);
    return lod::grow_grid_tree<2>(whole, config.depth, config.progress);
}

}  // namespace lod2d
