#include "lodlab/lod2d/builder/pieces.hpp"

#include "lodlab/core/builder/seeds.hpp"
#include "lodlab/lod2d/builder/disc_fit.hpp"

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
                                const lod::GrowSettings& settings) {
    const lod::Sphere<2> root = lod::root_ball<2>(whole);
    const GeometricStarts strategy(shape, lod::rounding_bound(root));
    return lod::grow_tree<2>(whole, root, strategy, settings);
}

}  // namespace lod2d
