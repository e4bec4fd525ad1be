#pragma once

#include "lodlab/core/base/random.hpp"
#include "lodlab/lod3d/mesh/intersect.hpp"

/// A uniform random direction.
inline lod3d::Point random_direction(lod::Random& random) {
    lod3d::Point p;
    do
        for (int d = 0; d < 3; ++d) p[d] = random.next(-1, 1);
    while (p.squaredNorm() > 1 || p.squaredNorm() < 1e-4);
    return p.normalized();
}

inline lod::Quaternion random_orientation(lod::Random& random) {
    const double angle = random.next(0, 6.283);
    return lod::Space<3>::turned(lod::Quaternion::Identity(), angle * random_direction(random));
}

inline lod::Matrix<3> random_rotation(lod::Random& random) {
    return random_orientation(random).toRotationMatrix();
}
