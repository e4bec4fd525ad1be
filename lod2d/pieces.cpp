#include "lod2d/pieces.hpp"

#include "core/builder/seeds.hpp"
#include "lod2d/disc_fit.hpp"

namespace lod2d {
namespace {

struct GeometricStarts : DiscFit {
    using DiscFit::DiscFit;

    [[nodiscard]] std::vector<std::vector<lod::Sphere<2>>> starts(const PolygonPiece& piece,
                                                                  const lod::Sphere<2>&,
                                                                  int count) const {
        const std::vector<Point> corners = convex_hull(piece.vertices());
        return {lod::far_apart<2>(piece.vertices(), count),
                lod::along_longest_axis<2>(corners, count)};
    }
};

}  // namespace

lod::SphereTree<2> build_pieces(const PolygonPiece& whole, const BoundaryIndex& shape,
                                const PiecesConfig& config) {
    lod::Sphere<2> root = lod::enclosing_ball<2>(whole.vertices());
    root.radius += lod::rounding_bound(root);
    const GeometricStarts strategy(shape, lod::rounding_bound(root));
    lod::GrowSettings settings;
    settings.branching = config.branching;
    settings.depth = config.depth;
    settings.least_protrusion = config.least_protrusion * 2 * root.radius;
    settings.look_ahead_above = config.look_ahead_above * 2 * root.radius;
    settings.most_rounds = config.most_rounds;
    settings.progress = config.progress;
    return lod::grow_tree<2>(whole, root, strategy, settings);
}

}  // namespace lod2d
