#pragma once

#include <span>

#include "lodlab/core/math/dimension.hpp"

namespace lod {

/// B's frame in A's, both bodies'.
template <int Dim>
struct RelativePose {
    Matrix<Dim> turn = Matrix<Dim>::Identity();
    Vector<Dim> shift = Vector<Dim>::Zero();

    /// A point of B's frame in A's.
    [[nodiscard]] Vector<Dim> of(const Vector<Dim>& point) const { return turn * point + shift; }
};

/// Whether two convex hulls, each given by its corners in its body's frame, lie more than `slack`
/// [m] apart along one of a few lines: first along `line` (from A to B, of any length, in A's
/// frame), then each time along that between the two corners that lay nearest to each other along
/// the one before. True is a proof; false says nothing. Half-spaces, which have no corners, are not
/// told apart. `slack` must bound the rounding of coordinates of either body, as
/// PosedTree::rounding of both does.
template <int Dim>
[[nodiscard]] bool hulls_apart(std::span<const Vector<Dim>> a, std::span<const Vector<Dim>> b,
                               const RelativePose<Dim>& b_in_a, Vector<Dim> line, double slack);

}  // namespace lod
