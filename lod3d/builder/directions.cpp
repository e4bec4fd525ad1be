#include "lodlab/lod3d/builder/directions.hpp"

#include <cmath>
#include <numbers>

#include "lodlab/core/math/trigonometry.hpp"

namespace lod3d {

std::vector<Point> spread_directions(int count) {
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    std::vector<Point> directions;
    for (int i = 0; i < count; ++i) {
        const double height = 1 - (2 * i + 1.0) / count;
        const double radius = std::sqrt(1 - height * height);
        const lod::SineCosine of = lod::sine_cosine(golden_angle * i);
        directions.emplace_back(radius * of.cosine, radius * of.sine, height);
    }
    return directions;
}

}  // namespace lod3d
