#include "lodlab/lod2d/source/paths/clean_work.hpp"

#include <algorithm>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod2d/shape/distance.hpp"
#include "lodlab/lod2d/shape/orientation.hpp"

namespace lod2d {
namespace {

Box box_of_edge(const BoundaryIndex& index, std::int32_t edge) {
    Box box;
    box.hold(index.edge_start(edge));
    box.hold(index.edge_end(edge));
    return box;
}

/// Calls visit(i, j), i < j, for edges whose boxes meet, until it returns false.
template <typename Visit>
bool visit_leaves(const BoundaryIndex& index, const BoundaryIndex::Node& a,
                  const BoundaryIndex::Node& b, Visit&& visit) {
    for (std::int32_t i = a.first_edge; i < a.last_edge; ++i) {
        const Box box = box_of_edge(index, i);
        for (std::int32_t j = std::max(b.first_edge, i + 1); j < b.last_edge; ++j)
            if (box.meets(box_of_edge(index, j)) && !visit(i, j)) return false;
    }
    return true;
}

template <typename Visit>
void visit_edge_pairs(const BoundaryIndex& index, Visit&& visit) {
    struct Pair {
        std::int32_t a;
        std::int32_t b;
    };
    std::vector<Pair> waiting;
    if (!index.nodes().empty()) waiting.push_back({0, 0});
    while (!waiting.empty()) {
        const Pair at = waiting.back();
        waiting.pop_back();
        const auto& a = index.nodes()[static_cast<std::size_t>(at.a)];
        const auto& b = index.nodes()[static_cast<std::size_t>(at.b)];
        if (!a.box.meets(b.box)) continue;
        if (a.right == 0 && b.right == 0) {
            const bool in_order = a.first_edge <= b.first_edge;
            if (!visit_leaves(index, in_order ? a : b, in_order ? b : a, visit)) return;
        } else if (at.a == at.b) {
            waiting.push_back({at.a + 1, at.a + 1});
            waiting.push_back({a.right, a.right});
            waiting.push_back({at.a + 1, a.right});
        } else if (a.right != 0) {
            waiting.push_back({at.a + 1, at.b});
            waiting.push_back({a.right, at.b});
        } else {
            waiting.push_back({at.a, at.b + 1});
            waiting.push_back({at.a, b.right});
        }
        lod::check_interrupted();
    }
}

/// Of two segments on one line: whether they share more than a point.
bool share_a_stretch(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Point along = (b - a).cwiseAbs();
    const int axis = along.x() >= along.y() ? 0 : 1;
    const double low = std::max(std::min(a[axis], b[axis]), std::min(c[axis], d[axis]));
    const double high = std::min(std::max(a[axis], b[axis]), std::max(c[axis], d[axis]));
    return low < high;
}

bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
    const int side_c = orientation(a, b, c);
    const int side_d = orientation(a, b, d);
    if (side_c == 0 && side_d == 0) return share_a_stretch(a, b, c, d);
    return side_c * side_d < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

}  // namespace

std::uint64_t count_edge_pairs(const Polygon& rings, std::uint64_t most) {
    std::uint64_t count = 0;
    visit_edge_pairs(BoundaryIndex(rings), [&](std::int32_t i, std::int32_t j) {
        count += j > i + 1;
        return count <= most;
    });
    return count;
}

std::uint64_t count_crossings(const Polygon& rings, std::uint64_t most) {
    const BoundaryIndex index(rings);
    std::uint64_t count = 0;
    visit_edge_pairs(index, [&](std::int32_t i, std::int32_t j) {
        count += segments_cross(index.edge_start(i), index.edge_end(i), index.edge_start(j),
                                index.edge_end(j));
        return count <= most;
    });
    return count;
}

bool crosses_itself(const Polygon& rings) {
    const BoundaryIndex index(rings);
    bool crosses = false;
    visit_edge_pairs(index, [&](std::int32_t i, std::int32_t j) {
        crosses = segments_cross(index.edge_start(i), index.edge_end(i), index.edge_start(j),
                                 index.edge_end(j));
        return !crosses;
    });
    return crosses;
}

std::uint64_t count_sweep_steps(const Polygon& rings, int axis) {
    std::vector<double> stops;
    for (const Ring& ring : rings.rings)
        for (const Point& p : ring) stops.push_back(p[axis]);
    std::ranges::sort(stops);
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    std::uint64_t steps = 0;
    for (const Ring& ring : rings.rings) {
        if (ring.empty()) continue;
        double from = ring.back()[axis];
        for (const Point& p : ring) {
            const auto [low, high] = std::minmax(from, p[axis]);
            const auto begin = std::lower_bound(stops.begin(), stops.end(), low);
            steps += static_cast<std::uint64_t>(std::upper_bound(begin, stops.end(), high) - begin);
            from = p[axis];
        }
    }
    return steps;
}

}  // namespace lod2d
