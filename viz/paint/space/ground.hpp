#pragma once

#include <vector>

#include "lodlab/viz/paint/palette.hpp"
#include "lodlab/viz/paint/space/eye.hpp"

namespace viz {

/// The ground as the eye sees it: a grid that fades out, and the soft shadows of what stands near.
class GroundPicture {
  public:
    GroundPicture(const Ground& ground, const Eye& eye, Theme theme, double line);

    struct Seen {
        double depth = 0;
        lod::Vector<3> colour = lod::Vector<3>::Zero();
        double alpha = 0;
    };
    [[nodiscard]] Seen look(const Eye::Ray& ray) const;

  private:
    [[nodiscard]] double shade(double x, double z) const;  ///< from -1 to 1 over the reach
    void cast(const Ground& ground);

    const Eye& eye_;
    double height_;
    double spacing_;
    double reach_;
    lod::Vector<3> centre_;
    lod::Vector<3> world_up_;  ///< in the eye's frame
    double half_line_;         ///< pixels
    lod::Vector<3> shadow_ink_;
    lod::Vector<3> grid_ink_;
    double shadow_strength_;
    std::vector<float> shade_;  ///< how much of the sky is hidden, on a lattice over the reach
};

}  // namespace viz
