#pragma once

#include <cstdint>

#include "lodlab/core/math/box.hpp"
#include "lodlab/core/tree/posed_tree.hpp"

namespace lod {

/// A body's box.
template <int Dim>
struct BodyBox {
    Box<Dim> box;
    std::int32_t body = 0;
};

/// The box of a node's ball, wider by what rounding may hide from a distance test, as
/// PosedTree::rounding has it.
template <int Dim>
[[nodiscard]] Box<Dim> box_of(const PosedTree<Dim>& posed, int node) {
    const Sphere<Dim> ball = posed.sphere(node);
    // Two units of rounding for the sum itself.
    const Vector<Dim> half = Vector<Dim>::Constant(ball.radius + 2 * posed.rounding());
    return {ball.centre - half, ball.centre + half};
}

/// Whether a box lies where numbers can tell one place from another. Bodies elsewhere meet none.
template <int Dim>
[[nodiscard]] bool is_somewhere(const Box<Dim>& box) {
    constexpr double furthest = 1e300;  // [m]
    return Vector<Dim>::Constant(-furthest).all_at_most(box.low) &&
           box.high.all_at_most(Vector<Dim>::Constant(furthest));
}

}  // namespace lod
