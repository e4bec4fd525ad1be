#pragma once

/// \file
/// All on one side of a line or a plane.

#include "lodlab/core/math/dimension.hpp"

namespace lod {

/// The points x with normal . x <= offset. The normal need not be of unit length; where it is zero
/// the half-space is everything (offset >= 0) or nothing.
template <int Dim>
struct HalfSpace {
    Vector<Dim> normal = Vector<Dim>::Zero();
    double offset = 0;
    bool keeps_border = true;  ///< which of two neighbours owns what lies wholly in the border

    /// Negative inside, in units of |normal| times metres.
    [[nodiscard]] double side(const Vector<Dim>& x) const { return normal.dot(x) - offset; }
};

}  // namespace lod
