#include "lodlab/lod2d/shape/convex_hull.hpp"

#include "lodlab/core/math/polygon.hpp"

namespace lod2d {

std::vector<Point> convex_hull(std::span<const Point> points) {
    return lod::convex_hull(std::vector<Point>(points.begin(), points.end()),
                            [](const Point& p) { return p; });
}

}  // namespace lod2d
