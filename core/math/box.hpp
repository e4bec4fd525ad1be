#pragma once

/// \file
/// A box along the axes.

#include <limits>

#include "lodlab/core/math/dimension.hpp"

namespace lod {

/// A box along the axes; empty at first, when its low end lies above its high one. Metres.
template <int Dim>
struct Box {
    Vector<Dim> low = Vector<Dim>::Constant(std::numeric_limits<double>::infinity());
    Vector<Dim> high = Vector<Dim>::Constant(-std::numeric_limits<double>::infinity());

    Box() = default;
    /// From its two ends.
    LOD_INLINE Box(const Vector<Dim>& low_end, const Vector<Dim>& high_end)
        : low(low_end), high(high_end) {}

    /// Grows until it holds a point.
    LOD_INLINE void hold(const Vector<Dim>& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    /// Grows until it holds another box.
    LOD_INLINE void hold(const Box& box) {
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    /// Whether it holds nothing.
    [[nodiscard]] LOD_INLINE bool is_empty() const { return high.any_below(low); }
    /// Whether a point lies in it; its border belongs to it.
    [[nodiscard]] LOD_INLINE bool holds(const Vector<Dim>& p) const {
        return low.all_at_most(p) && p.all_at_most(high);
    }
    /// Boxes that only touch meet.
    [[nodiscard]] LOD_INLINE bool meets(const Box& box) const {
        return low.all_at_most(box.high) && box.low.all_at_most(high);
    }
    /// Its sides. Requires: not empty.
    [[nodiscard]] LOD_INLINE Vector<Dim> size() const { return high - low; }
    /// Its middle. Requires: not empty.
    [[nodiscard]] LOD_INLINE Vector<Dim> centre() const { return (low + high) / 2; }
    /// Squared distance of the nearest points of two boxes; 0 where they meet.
    [[nodiscard]] LOD_INLINE double squared_distance(const Box& box) const {
        return (low - box.high).cwiseMax(box.low - high).cwiseMax(0.0).squaredNorm();
    }
    /// Squared distance of a point from the box; 0 inside.
    [[nodiscard]] LOD_INLINE double squared_distance(const Vector<Dim>& p) const {
        return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
    }
};

}  // namespace lod
