#include "lodlab/lod3d/builder/distance_field.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/stop.hpp"

namespace lod3d {

DistanceField::DistanceField(const MeshDistance& distance, const Box& box, int cells) {
    const Point extent = box.high - box.low;
    step_ = extent.maxCoeff() / cells;
    const Point beyond = Point::Constant(extent.maxCoeff() / 6);
    low_ = box.low - beyond;
    for (int d = 0; d < 3; ++d)
        count_[static_cast<std::size_t>(d)] =
            static_cast<int>((extent[d] + 2 * beyond[d]) / step_) + 2;
    value_.resize(number(0, 0, count_[2]));
    // The nearest point of a neighbour bounds how far there is to look.
    std::vector<Point> below(static_cast<std::size_t>(count_[0]));
    for (int z = 0; z < count_[2]; ++z) {
        lod::check_interrupted();
        for (int y = 0; y < count_[1]; ++y) {
            for (int x = 0; x < count_[0]; ++x) {
                const Point p = low_ + step_ * Point(x, y, z);
                double reach = std::numeric_limits<double>::infinity();
                const auto bound_by = [&](const Point& q) {
                    reach = std::min(reach, (p - q).norm() * (1 + 1e-9) + 1e-12 * step_);
                };
                if (x > 0) bound_by(below[static_cast<std::size_t>(x - 1)]);
                if (y > 0) bound_by(below[static_cast<std::size_t>(x)]);
                const Nearest nearest = distance.nearest(p, reach);
                below[static_cast<std::size_t>(x)] = nearest.point;
                const bool inside = distance.is_inside(p, nearest);
                value_[number(x, y, z)] =
                    static_cast<float>(inside ? -nearest.distance : nearest.distance);
            }
        }
    }
}

lod::SlopedDistance<3> DistanceField::at(const Point& p) const {
    std::array<int, 3> cell;
    Point share;
    double beyond = 0;
    for (int d = 0; d < 3; ++d) {
        const auto axis = static_cast<std::size_t>(d);
        const double place = (p[d] - low_[d]) / step_;
        const double within = std::clamp(place, 0.0, count_[axis] - 1.001);
        beyond += (place - within) * (place - within);
        cell[axis] = static_cast<int>(within);
        share[d] = within - cell[axis];
    }
    const auto sample = [&](int x, int y, int z) {
        return static_cast<double>(value_[number(cell[0] + x, cell[1] + y, cell[2] + z)]);
    };
    // Along x on the four edges, then along y, then along z.
    std::array<double, 4> value;
    std::array<double, 4> slope;
    for (int edge = 0; edge < 4; ++edge) {
        const double from = sample(0, edge & 1, edge >> 1);
        const auto i = static_cast<std::size_t>(edge);
        slope[i] = sample(1, edge & 1, edge >> 1) - from;
        value[i] = from + share.x() * slope[i];
    }
    const double low = value[0] + share.y() * (value[1] - value[0]);
    const double high = value[2] + share.y() * (value[3] - value[2]);
    const double slope_low = slope[0] + share.y() * (slope[1] - slope[0]);
    const double slope_high = slope[2] + share.y() * (slope[3] - slope[2]);
    lod::SlopedDistance<3> result;
    result.value = low + share.z() * (high - low) + step_ * std::sqrt(beyond);
    result.gradient =
        Point(slope_low + share.z() * (slope_high - slope_low),
              (value[1] - value[0]) + share.z() * ((value[3] - value[2]) - (value[1] - value[0])),
              high - low) /
        step_;
    return result;
}

}  // namespace lod3d
