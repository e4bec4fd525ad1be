#pragma once

#include <span>
#include <vector>

#include "lodlab/core/math/box.hpp"
#include "lodlab/core/math/half_space.hpp"

namespace lod {

/// Appends the part of a facet (a segment in the plane, a convex polygon in space) that lies in the
/// half-space (clip_corners). Returns how many corners were added; a part of fewer than Dim is
/// dropped.
template <int Dim>
std::size_t clip_facet(std::span<const Vector<Dim>> facet, const HalfSpace<Dim>& side,
                       std::vector<Vector<Dim>>& out);

/// A bounded intersection of half-spaces. Each face is a facet of its own, clipped by the planes of
/// all others, so that no rounding can spoil a structure between them.
template <int Dim>
class ConvexCell {
  public:
    struct Face {
        HalfSpace<Dim> side;
        std::vector<Vector<Dim>> corners;  ///< in order around the face, either way
    };

    ConvexCell() = default;  ///< empty
    explicit ConvexCell(const Box<Dim>& box);

    /// What of the cell lies in the half-space too.
    void clip(const HalfSpace<Dim>& side);

    [[nodiscard]] bool holds(const Vector<Dim>& p) const;
    [[nodiscard]] bool empty() const { return faces_.empty(); }
    /// Corners of all faces; a corner comes once for each face that it is of.
    [[nodiscard]] std::vector<Vector<Dim>> corners() const;
    [[nodiscard]] double measure() const;  ///< area or volume

    [[nodiscard]] std::span<const Face> faces() const { return faces_; }

  private:
    [[nodiscard]] std::vector<Vector<Dim>> section(const HalfSpace<Dim>& side) const;

    std::vector<Face> faces_;
    Box<Dim> box_{Vector<Dim>::Zero(), Vector<Dim>::Zero()};  ///< of the first cell
};

extern template class ConvexCell<2>;
extern template class ConvexCell<3>;

}  // namespace lod
