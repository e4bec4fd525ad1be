#include "lodlab/core/tree/posed_tree.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace lod {

template <int Dim>
void PosedTree<Dim>::pose_all(std::span<const Body<Dim>> bodies, std::span<PosedTree> posed) {
    constexpr std::size_t some = 32;
    std::array<Orientation<Dim>, some> orientations;
    std::array<Matrix<Dim>, some> rotations;
    for (std::size_t begin = 0; begin < bodies.size(); begin += some) {
        const std::size_t count = std::min(some, bodies.size() - begin);
        for (std::size_t i = 0; i < count; ++i) orientations[i] = bodies[begin + i].orientation;
        Space<Dim>::rotations(std::span(orientations).first(count), rotations);
        for (std::size_t i = 0; i < count; ++i)
            posed[begin + i].pose(bodies[begin + i], rotations[i]);
    }
}

template <int Dim>
void PosedTree<Dim>::pose(const Body<Dim>& body, const Matrix<Dim>& rotation) {
    tree_ = body.tree.get();
    placement_ = {rotation, body.position};
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
