#include "lodlab/core/tree/posed_tree.hpp"

#include <limits>

namespace lod {

template <int Dim>
void PosedTree<Dim>::pose(const Body<Dim>& body) {
    tree_ = body.tree.get();
    placement_ = lod::placement(body);
    root_ = sphere(0);
    // In units of u = epsilon / 2, worst case, in space (less in the plane): the matrix of a
    // quaternion that is a unit to 4 u is off by 27 u, the sums of a carried centre by 7 u of the
    // extent and 6 u of the position, the distance test by 5 u of the two radii.
    rounding_ = 24 * std::numeric_limits<double>::epsilon() *
                (position().cwiseAbs().maxCoeff() + tree_->extent);
}

template class PosedTree<2>;
template class PosedTree<3>;

}  // namespace lod
