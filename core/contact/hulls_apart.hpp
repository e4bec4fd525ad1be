#pragma once

#include <span>

#include "lodlab/core/tree/placement.hpp"

namespace lod {

/// Whether two convex hulls, each given by its corners in its body's frame, lie more than `slack`
/// [m] apart along one of a few lines: first along `line` (from A to B, of any length, in A's
/// frame), then each time along that between the two corners that lay nearest to each other along
/// the one before. True is a proof; false says nothing. Half-spaces, which have no corners, are not
/// told apart. `slack` must bound the rounding of coordinates of either body, as
/// PosedTree::rounding of both does.
template <int Dim>
[[nodiscard]] bool hulls_apart(std::span<const Vector<Dim>> a, std::span<const Vector<Dim>> b,
                               const Placement<Dim>& b_in_a, Vector<Dim> line, double slack);

}  // namespace lod
