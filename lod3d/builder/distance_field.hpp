#pragma once

#include "lodlab/core/builder/cover.hpp"
#include "lodlab/lod3d/mesh/distance.hpp"

namespace lod3d {

/// Signed distances from a mesh sampled on a grid of cubes: quick, and right to within a cube.
/// Builders search with it; what they promise is measured on the mesh.
class DistanceField {
  public:
    /// The longest side of the box takes `cells` cubes; the grid goes a sixth beyond it.
    DistanceField(const MeshDistance& distance, const Box& box, int cells);

    /// Interpolated. Beyond the grid: that of the nearest point of the grid and the way to it.
    [[nodiscard]] lod::SlopedDistance<3> at(const Point& p) const;

    [[nodiscard]] double step() const { return step_; }  ///< side of a cube [m]

  private:
    [[nodiscard]] std::size_t number(int x, int y, int z) const {
        return static_cast<std::size_t>(x) +
               static_cast<std::size_t>(count_[0]) *
                   (static_cast<std::size_t>(y) +
                    static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(z));
    }

    Point low_;
    double step_ = 0;
    std::array<int, 3> count_{};
    std::vector<float> value_;
};

}  // namespace lod3d
