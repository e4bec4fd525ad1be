#include "lodlab/lod2d/builder/build_tree.hpp"

#include <array>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/builder/certify.hpp"
#include "lodlab/core/builder/grow.hpp"
#include "lodlab/core/builder/node_hulls.hpp"
#include "lodlab/lod2d/builder/medial.hpp"
#include "lodlab/lod2d/builder/pieces.hpp"
#include "lodlab/lod2d/builder/quadtree.hpp"
#include "lodlab/lod2d/shape/distance.hpp"

namespace lod2d {
namespace {

constexpr std::array<Builder, 3> all_builders{Builder::quadtree, Builder::pieces, Builder::medial};

lod::SphereTree<2> built(const Shape& shape, const PolygonPiece& whole,
                         const TreeSettings& settings) {
    const BoundaryIndex index(shape.polygon);
    lod::GrowSettings grow;
    grow.branching = settings.branching;
    grow.depth = settings.depth;
    grow.least_protrusion = settings.least_protrusion;
    grow.progress = settings.progress;
    switch (settings.builder) {
        case Builder::quadtree:
            if (settings.branching != 4)
                throw lod::Error(lod::ErrorKind::usage,
                                 "a quadtree has branching 4; choose that or another builder");
            return build_quadtree(whole, grow);
        case Builder::pieces:
            return build_pieces(whole, index, grow);
        case Builder::medial:
            grow.normal_weight = settings.normal_weight;
            return build_medial(shape.polygon, whole, index, {.grow = grow});
    }
    throw lod::Error(lod::ErrorKind::usage, "there is no such builder of circle trees");
}

}  // namespace

std::span<const Builder> builders() {
    return all_builders;
}

std::string_view builder_name(Builder builder) {
    switch (builder) {
        case Builder::quadtree:
            return "quadtree";
        case Builder::pieces:
            return "pieces";
        case Builder::medial:
            return "medial";
    }
    return "?";
}

Builder builder_named(std::string_view name) {
    for (const Builder builder : all_builders)
        if (name == builder_name(builder)) return builder;
    throw lod::Error(lod::ErrorKind::usage, "no builder is called \"" + std::string(name) +
                                                "\"; choose quadtree, pieces or medial");
}

lod::SphereTree<2> build_tree(const Shape& shape, const TreeSettings& settings) {
    const PolygonPiece whole(shape.polygon);
    TreeSettings limited = settings;
    limited.depth = lod::depth_within(settings.branching, settings.depth, settings.most_nodes);
    lod::SphereTree<2> tree = built(shape, whole, limited);
    if (!lod::certify<2>(tree, whole).back().certified)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "the circle tree of " + shape.name +
                             " does not cover it to within rounding; simplify the outline or "
                             "choose a smaller depth");
    lod::give_hulls<2>(tree, whole, BoundaryIndex(shape.polygon));
    return tree;
}

}  // namespace lod2d
