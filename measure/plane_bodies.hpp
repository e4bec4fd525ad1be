#pragma once

/// \file
/// The bodies of a scene of the plane as the measures take them.

#include <memory>

#include "lodlab/lod2d/shape/distance.hpp"
#include "lodlab/measure/collisions.hpp"

namespace measure {

/// The true shapes of a scene of the plane.
class PlaneBodies final : public BodyShapes<2> {
  public:
    /// Entry k is the shape of body k, body frame; they must outlive this.
    explicit PlaneBodies(std::span<const lod2d::Shape* const> shapes);

    [[nodiscard]] double size(int body) const override;
    /// The depth counts corners of either outline that lie within the other, each to the nearest
    /// point of that outline; shapes that cross without a corner inside have depth 0.
    [[nodiscard]] double separation(int a, const lod::Body<2>& state_a, int b,
                                    const lod::Body<2>& state_b) const override;

  private:
    std::vector<lod2d::BoundaryIndex> outlines_;  ///< body frame
    std::vector<double> sizes_;
};

}  // namespace measure
