#include "lodlab/core/tree/posed_tree.hpp"

#include <algorithm>
#include <limits>

namespace lod {

template <int Dim>
void PosedTree<Dim>::pose(const Body<Dim>& body) {
    tree_ = body.tree.get();
    rotation_ = Space<Dim>::rotation(body.orientation);
    position_ = body.position;
    const auto nodes = static_cast<std::size_t>(tree_->size());
    if (carried_for_.size() < nodes) {
        carried_for_.resize(nodes, 0);
        for (auto& axis : centre_) axis.resize(nodes + lanes - 1);
        radius_.resize(nodes + lanes - 1);
    }
    ++pose_number_;
    carried_nodes_ = 0;
    // In units of u = epsilon / 2, worst case, in space (less in the plane): the matrix of a
    // quaternion that is a unit to 4 u is off by 27 u, the sums of a carried centre by 7 u of the
    // extent and 6 u of the position, the distance test by 5 u of the two radii.
    rounding_ = 24 * std::numeric_limits<double>::epsilon() *
                (position_.cwiseAbs().maxCoeff() + tree_->extent);
    carry(0, 1);
}

template <int Dim>
void PosedTree<Dim>::carry_children(int parent) {
    const auto p = static_cast<std::size_t>(parent);
    if (carried_for_[p] == pose_number_) return;
    carried_for_[p] = pose_number_;
    carry(tree_->first_child[p], tree_->child_count[p]);
}

template <int Dim>
void PosedTree<Dim>::carry(int first, int count) {
    for (int axis = 0; axis < Dim; ++axis) {
        double* out = centre_[static_cast<std::size_t>(axis)].data();
        for (int node = first; node < first + count; ++node) {
            double x = position_[axis];
            for (int d = 0; d < Dim; ++d)
                x += rotation_(axis, d) *
                     tree_->centre[static_cast<std::size_t>(d)][static_cast<std::size_t>(node)];
            out[node] = x;
        }
    }
    std::copy_n(tree_->radius.data() + first, count, radius_.data() + first);
    carried_nodes_ += count;
}

template <int Dim>
Sphere<Dim> PosedTree<Dim>::sphere(int node) const {
    Sphere<Dim> s;
    for (int axis = 0; axis < Dim; ++axis) s.centre[axis] = centres(axis)[node];
    s.radius = radii()[node];
    return s;
}

template class PosedTree<2>;
template class PosedTree<3>;

}  // namespace lod
