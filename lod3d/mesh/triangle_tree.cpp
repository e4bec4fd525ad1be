#include "lodlab/lod3d/mesh/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>

namespace lod3d {
namespace {

constexpr int bins = 16;

struct Bounds {
    Point low = Point::Constant(std::numeric_limits<double>::infinity());
    Point high = Point::Constant(-std::numeric_limits<double>::infinity());

    void hold(const Point& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    void hold(const Bounds& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    [[nodiscard]] double half_area() const {
        const Point e = (high - low).cwiseMax(0.0);
        return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
    }
};

Bounds bounds_of(const Mesh& mesh, std::int32_t triangle) {
    Bounds bounds;
    for (int k = 0; k < 3; ++k) bounds.hold(mesh.corner(static_cast<std::size_t>(triangle), k));
    return bounds;
}

/// Where to cut a range of triangles: along the axis, before the bin.
struct Cut {
    int axis = -1;  ///< -1: no cut is worth while
    int bin = 0;
    double cost = std::numeric_limits<double>::infinity();
};

int bin_of(double middle, double low, double high) {
    const double share = (middle - low) / (high - low);
    return std::clamp(static_cast<int>(share * bins), 0, bins - 1);
}

/// The cut of least cost by the surface area heuristic.
Cut best_cut(const Mesh& mesh, std::span<const std::int32_t> triangles, const Bounds& middles_box,
             const std::vector<Point>& middles) {
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = middles_box.low[axis];
        const double high = middles_box.high[axis];
        if (!(high > low)) continue;
        std::array<Bounds, bins> bounds;
        std::array<int, bins> count{};
        for (std::int32_t t : triangles) {
            const auto bin = static_cast<std::size_t>(
                bin_of(middles[static_cast<std::size_t>(t)][axis], low, high));
            bounds[bin].hold(bounds_of(mesh, t));
            ++count[bin];
        }
        std::array<double, bins> cost_after{};
        Bounds side;
        int members = 0;
        for (int bin = bins - 1; bin > 0; --bin) {
            side.hold(bounds[static_cast<std::size_t>(bin)]);
            members += count[static_cast<std::size_t>(bin)];
            cost_after[static_cast<std::size_t>(bin)] =
                members > 0 ? members * side.half_area() : 0;
        }
        side = Bounds();
        members = 0;
        for (int bin = 1; bin < bins; ++bin) {
            side.hold(bounds[static_cast<std::size_t>(bin - 1)]);
            members += count[static_cast<std::size_t>(bin - 1)];
            if (members == 0 || members == static_cast<int>(triangles.size())) continue;
            const double cost =
                members * side.half_area() + cost_after[static_cast<std::size_t>(bin)];
            if (cost < best.cost) best = {axis, bin, cost};
        }
    }
    return best;
}

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh) : order_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    std::vector<Point> middles;
    middles.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        middles.push_back((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3);
    nodes_.reserve(mesh.triangles.size());
    build(0, static_cast<std::int32_t>(order_.size()), 0, middles, mesh);
    corners_.reserve(order_.size());
    for (std::int32_t t : order_) {
        const auto i = static_cast<std::size_t>(t);
        corners_.push_back({mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2)});
    }
}

std::int32_t TriangleTree::build(std::int32_t first, std::int32_t count, int depth,
                                 const std::vector<Point>& middles, const Mesh& mesh) {
    const std::span<std::int32_t> range =
        std::span(order_).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
    Bounds box;
    Bounds middles_box;
    for (std::int32_t t : range) {
        box.hold(bounds_of(mesh, t));
        middles_box.hold(middles[static_cast<std::size_t>(t)]);
    }
    const auto here = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({box.low, box.high, first, count});
    if (count <= most_in_leaf) return here;

    const Cut cut = depth < deepest / 2 ? best_cut(mesh, range, middles_box, middles) : Cut();
    auto middle = range.begin() + count / 2;  // halves, where no cut is better
    if (cut.axis >= 0) {
        const double low = middles_box.low[cut.axis];
        const double high = middles_box.high[cut.axis];
        middle = std::partition(range.begin(), range.end(), [&](std::int32_t t) {
            return bin_of(middles[static_cast<std::size_t>(t)][cut.axis], low, high) < cut.bin;
        });
    }
    const auto in_first = static_cast<std::int32_t>(middle - range.begin());
    build(first, in_first, depth + 1, middles, mesh);
    const std::int32_t second = build(first + in_first, count - in_first, depth + 1, middles, mesh);
    nodes_[static_cast<std::size_t>(here)].first = second;
    nodes_[static_cast<std::size_t>(here)].count = 0;
    return here;
}

}  // namespace lod3d
