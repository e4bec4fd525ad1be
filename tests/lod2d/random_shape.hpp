#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <string>

#include "lodlab/lod2d/shape/distance.hpp"
#include "lodlab/lod2d/shape/generators.hpp"

namespace lod2d {

inline double number_between(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1 << 24) / double(1 << 24);
}

/// A generated shape of any kind, convex or not, with holes or without.
inline Shape random_shape() {
    static const std::vector<std::string> specs = {
        "box",   "rod",      "triangle", "polygon:5", "disc:24",   "ring:0.7",     "capsule",
        "L",     "T",        "U",        "cross",     "star:5",    "star:9",       "gear:7",
        "arrow", "crescent", "comb:5",   "spiral:2",  "box:2,0.3", "gear:12,0.2,0"};
    const int kind = *rc::gen::inRange(0, static_cast<int>(specs.size()) + 8);
    if (kind < static_cast<int>(specs.size()))
        return generate(specs[static_cast<std::size_t>(kind)]);
    return generate("blob:" + std::to_string(*rc::gen::inRange(0, 1000)));
}

/// Up to `reach` metres from the origin along each axis, at any angle.
inline Pose random_pose(double reach) {
    return {{number_between(-reach, reach), number_between(-reach, reach)},
            number_between(-3.2, 3.2)};
}

/// Near the shape or on its boundary (corners and middles of edges, up to rounding).
inline Point random_point(const Shape& shape) {
    const Ring& ring = shape.polygon.rings[static_cast<std::size_t>(
        *rc::gen::inRange(0, static_cast<int>(shape.polygon.rings.size())))];
    const auto i = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(ring.size())));
    switch (*rc::gen::inRange(0, 4)) {
        case 0:
            return ring[i];
        case 1:
            return {number_between(-1, 1), ring[i].y()};  // a ray through a corner
        case 2:
            return (ring[i] + ring[(i + 1) % ring.size()]) / 2;
        default:
            return {number_between(-1, 1), number_between(-1, 1)};
    }
}

}  // namespace lod2d
