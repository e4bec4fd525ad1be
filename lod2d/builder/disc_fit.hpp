#pragma once

#include <vector>

#include "lodlab/core/math/sphere.hpp"
#include "lodlab/lod2d/builder/piece.hpp"
#include "lodlab/lod2d/shape/convex_hull.hpp"
#include "lodlab/lod2d/shape/distance.hpp"

namespace lod2d {

/// Fits discs to pieces so that they stand out of the shape as little as can be.
class DiscFit {
  public:
    /// The index must outlive this. A disc holds its piece with `spare` left [m], and is at most
    /// `most_growth` times (>= 1) as large as the piece's least enclosing disc: without a limit the
    /// discs of two sides meet on the medial axis, and one power cell takes both.
    DiscFit(const BoundaryIndex& shape, double spare, double most_growth = 1e9)
        : shape_(shape), spare_(spare), most_growth_(most_growth) {}

    /// A disc that holds the piece's vertices. Of the starting disc's centre and the centre of the
    /// least enclosing disc it takes the better and walks downhill: about a centre x the disc needs
    /// the radius R(x), the farthest vertex, and stands out by R(x) - depth(x) at most.
    [[nodiscard]] lod::Sphere<2> fit(const PolygonPiece& piece, const lod::Sphere<2>& start) const;

    /// How far a disc stands out, from above, within a twentieth.
    [[nodiscard]] double protrusion(const lod::Sphere<2>& disc) const;

    [[nodiscard]] const BoundaryIndex& shape() const { return shape_; }

  private:
    const BoundaryIndex& shape_;
    double spare_;
    double most_growth_;
};

}  // namespace lod2d
