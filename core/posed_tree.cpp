#include "core/posed_tree.hpp"

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
        for (auto& axis : centre_) axis.resize(nodes);
    }
    ++pose_number_;
    carried_nodes_ = 0;
    const Sphere<Dim> root = tree_->sphere(0);
    // A rotated coordinate is a sum of Dim products, each factor rounded: below 8 units of the
    // largest magnitude that enters.
    rounding_ = 8 * std::numeric_limits<double>::epsilon() *
                (position_.cwiseAbs().maxCoeff() + root.centre.norm() + root.radius);
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
    carried_nodes_ += count;
}

template <int Dim>
Sphere<Dim> PosedTree<Dim>::sphere(int node) const {
    Sphere<Dim> s;
    for (int axis = 0; axis < Dim; ++axis) s.centre[axis] = centres(axis)[node];
    s.radius = tree_->radius[static_cast<std::size_t>(node)];
    return s;
}

template class PosedTree<2>;
template class PosedTree<3>;

}  // namespace lod
