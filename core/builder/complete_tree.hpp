#pragma once

/// \file
/// The last step of a builder of one's own: the proof of the cover, and the hulls of the nodes.

#include <string>
#include <string_view>
#include <utility>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/builder/certify.hpp"
#include "lodlab/core/builder/node_hulls.hpp"
#include "lodlab/core/builder/piece.hpp"
#include "lodlab/core/builder/protrusion.hpp"
#include "lodlab/core/tree/tree.hpp"

namespace lod {

/// The last step of every builder: proves that the tree covers the whole shape, by name, and gives
/// its nodes their hulls. Throws Error (input refused) where rounding leaves no proof.
template <int Dim, PieceOf<Dim> Piece, DistanceFrom<Dim> Distance>
[[nodiscard]] SphereTree<Dim> complete_tree(SphereTree<Dim> tree, std::string_view name,
                                            const Piece& whole, const Distance& shape) {
    if (!certify<Dim>(tree, whole).back().certified)
        refuse_input(std::string(name),
                     "its tree does not cover it to within rounding; simplify the shape or choose "
                     "a smaller depth");
    give_hulls<Dim>(tree, whole, shape);
    return tree;
}

}  // namespace lod
