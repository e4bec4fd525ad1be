#include "lodlab/lod3d/builder/build_tree.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/builder/complete_tree.hpp"
#include "lodlab/core/builder/grid_tree.hpp"
#include "lodlab/lod3d/builder/ball_fit.hpp"
#include "lodlab/lod3d/builder/piece.hpp"

namespace lod3d {
namespace {

lod::SphereTree<3> grow_cover(const Solid& solid, const MeshPiece& whole,
                              const MeshDistance& distance, const lod::GrowSettings& limits,
                              double effort) {
    constexpr int field_cells = 64;
    const lod::Sphere<3> root = lod::root_ball<3>(whole);
    if (limits.depth == 0)  // nothing to search for
        return lod::lay_out<3>(std::array{lod::TreeNode<3>{root, lod::mean_normal<3>(whole), {}}});
    const DistanceField field(distance, bounding_box(solid.mesh), field_cells);
    BallFitSettings fit;
    fit.quick = lod::scaled(fit.quick, effort);
    fit.thorough = lod::scaled(fit.thorough, effort);
    const BallFit strategy(distance, field, lod::rounding_bound(root), fit);
    lod::GrowSettings settings = limits;
    settings.starts_are_covers = true;
    settings.most_failures = static_cast<int>(std::ceil(6 * effort));
    settings.look_ahead_above = std::numeric_limits<double>::infinity();  // the strategy does
    return lod::grow_tree<3>(whole, root, strategy, settings);
}

lod::SphereTree<3> grow_spheres(const Solid& solid, const MeshPiece& whole,
                                const MeshDistance& distance, const TreeSettings& settings) {
    if (settings.builder == Builder::octree && settings.branching != 8)
        throw lod::Error(lod::ErrorKind::usage,
                         "an octree has branching 8; choose that or another builder");
    if (!(settings.effort >= 0 && settings.effort <= 100))
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         "cannot build the tree: the effort is out of range; choose 0 to 100");
    const lod::GrowSettings grow = lod::grow_settings_of(settings);
    if (settings.builder == Builder::octree)
        return lod::grow_grid_tree<3>(whole, grow.depth, grow.progress);
    return grow_cover(solid, whole, distance, grow, settings.effort);
}

}  // namespace

lod::SphereTree<3> build_tree(const Solid& solid, const TreeSettings& settings) {
    const MeshDistance distance(solid.mesh, solid.inside_rule);
    const MeshPiece whole(solid, distance);
    return lod::complete_tree<3>(grow_spheres(solid, whole, distance, settings), solid.name, whole,
                                 distance);
}

}  // namespace lod3d
