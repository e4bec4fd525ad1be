#include "lodlab/lod3d/builder/sphere_tree.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "lodlab/core/builder/grid_tree.hpp"
#include "lodlab/core/builder/node_hulls.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/lod3d/builder/ball_fit.hpp"
#include "lodlab/lod3d/builder/directions.hpp"

namespace lod3d {
namespace {

constexpr std::array<SolidBuilder, 2> all_builders{SolidBuilder::octree, SolidBuilder::cover};

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

/// Samples the part of every sphere that no other ball covers. Its volume is a third of the
/// integral of x . n over it (Gauss).
lod::UnionMeasures sample_union(std::span<const lod::Sphere<3>> balls, const MeshDistance& distance,
                                int samples) {
    const int each = std::max(100, samples / static_cast<int>(balls.size()));
    const std::vector<Point> directions = spread_directions(each);
    double area = 0;
    double distances = 0;
    lod::UnionMeasures result;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        lod::check_interrupted();
        const lod::Sphere<3>& own = balls[i];
        std::vector<const lod::Sphere<3>*> near;
        for (std::size_t j = 0; j < balls.size(); ++j)
            if (j != i && lod::overlap(own, balls[j])) near.push_back(&balls[j]);
        const double patch = 4 * std::numbers::pi * own.radius * own.radius / each;
        for (const Point& u : directions) {
            const Point p = own.centre + own.radius * u;
            const bool hidden = std::any_of(near.begin(), near.end(), [&](const auto* ball) {
                return (p - ball->centre).squaredNorm() < ball->radius * ball->radius;
            });
            if (hidden) continue;
            area += patch;
            distances += patch * distance.distance(p);
            result.measure += patch * p.dot(u) / 3;
        }
    }
    if (area > 0) result.mean_protrusion = distances / area;
    return result;
}

}  // namespace

lod::SphereTree<3> build_sphere_tree(const Solid& solid, const SphereTreeSettings& settings) {
    lod::GrowSettings limits;
    limits.branching = settings.branching;
    limits.depth = settings.depth;
    limits.least_protrusion = settings.least_protrusion;
    limits.progress = settings.progress;
    if (settings.builder == SolidBuilder::octree && settings.branching != 8)
        throw lod::Error(lod::ErrorKind::usage,
                         "an octree has branching 8; choose that or another builder");
    if (!(settings.effort >= 0 && settings.effort <= 100))
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         "cannot build the tree: the effort is out of range; choose 0 to 100");
    lod::check_grow_settings(limits);
    limits.depth = lod::depth_within(settings.branching, settings.depth, settings.most_nodes);
    const MeshDistance distance(solid.mesh, solid.inside_rule);
    const MeshPiece whole(solid, distance);
    lod::SphereTree<3> tree = settings.builder == SolidBuilder::octree
                                  ? lod::grow_grid_tree<3>(whole, limits.depth, limits.progress)
                                  : grow_cover(solid, whole, distance, limits, settings.effort);
    if (!lod::certify<3>(tree, whole).back().certified)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "the sphere tree of " + solid.name +
                             " does not cover it to within rounding; simplify the mesh or choose "
                             "a smaller depth");
    lod::give_hulls<3>(tree, whole, distance);
    return tree;
}

std::span<const SolidBuilder> solid_builders() {
    return all_builders;
}

std::string_view name_of(SolidBuilder builder) {
    return builder == SolidBuilder::octree ? "octree" : "cover";
}

SolidBuilder solid_builder_named(std::string_view name) {
    for (const SolidBuilder builder : all_builders)
        if (name == name_of(builder)) return builder;
    throw lod::Error(lod::ErrorKind::usage, "no builder of sphere trees is called \"" +
                                                std::string(name) + "\"; choose octree or cover");
}

lod::TreeReport report_sphere_tree(const Solid& solid, const lod::SphereTree<3>& tree,
                                   const SphereTreeReportSettings& settings) {
    const MeshDistance distance(solid.mesh, solid.inside_rule);
    const MeshPiece whole(solid, distance);
    return lod::report_levels<3>(tree, whole, distance, solid.volume, settings.tolerance,
                                 [&](std::span<const lod::Sphere<3>> balls) {
                                     return sample_union(balls, distance, settings.samples);
                                 });
}

}  // namespace lod3d
