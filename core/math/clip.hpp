#pragma once

#include <span>

#include "lodlab/core/math/dimension.hpp"

namespace lod {

/// Cuts a chain of corners by a half-space (Sutherland and Hodgman): calls keep(point) for every
/// corner within and every cut, in order. side(point) is negative inside, 0 on the border.
/// `closed`: the last corner is joined to the first. A cut stands between the two corners of the
/// cut side, so that it strays from neither.
template <int Dim, class Side, class Keep>
void clip_corners(std::span<const Vector<Dim>> corners, bool closed, const Side& side,
                  const Keep& keep) {
    if (corners.empty()) return;
    const Vector<Dim>* from = closed ? &corners.back() : &corners.front();
    double side_from = side(*from);
    for (const Vector<Dim>& to : corners) {
        const double side_to = side(to);
        if ((side_from < 0 && side_to > 0) || (side_from > 0 && side_to < 0))
            keep(*from + (side_from / (side_from - side_to)) * (to - *from));
        if (side_to <= 0) keep(to);
        from = &to;
        side_from = side_to;
    }
}

}  // namespace lod
