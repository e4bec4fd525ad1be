#include "lodlab/lod2d/shape/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/shape/orientation.hpp"

namespace lod2d {
namespace {

using Node = BoundaryIndex::Node;

/// An edge, or a node, of A and one of B.
struct IndexPair {
    std::int32_t a = 0;
    std::int32_t b = 0;
};

const Node& node_at(const BoundaryIndex& index, std::int32_t node) {
    return index.nodes()[static_cast<std::size_t>(node)];
}

/// Of two nodes that are not both leaves, the one to open: the larger that has children.
bool opens_a(const Node& a, const Node& b) {
    if (a.right == 0) return false;
    if (b.right == 0) return true;
    return a.box.size().maxCoeff() >= b.box.size().maxCoeff();
}

/// Calls visit(edge of a, edge of b) for edges that share a point until it returns false.
template <typename Visit>
bool visit_leaf_pair(const BoundaryIndex& a, const Node& node_a, const BoundaryIndex& b,
                     const Node& node_b, Visit&& visit) {
    for (std::int32_t i = node_a.first_edge; i < node_a.last_edge; ++i) {
        Box edge;
        edge.hold(a.edge_start(i));
        edge.hold(a.edge_end(i));
        if (!edge.meets(node_b.box)) continue;
        for (std::int32_t j = node_b.first_edge; j < node_b.last_edge; ++j)
            if (segments_meet(a.edge_start(i), a.edge_end(i), b.edge_start(j), b.edge_end(j)) &&
                !visit(IndexPair{i, j}))
                return false;
    }
    return true;
}

template <typename Visit>
void visit_crossings(const BoundaryIndex& a, const BoundaryIndex& b, Visit&& visit) {
    if (a.nodes().empty() || b.nodes().empty()) return;
    std::vector<IndexPair> waiting{{0, 0}};  // pairs of nodes
    while (!waiting.empty()) {
        const IndexPair at = waiting.back();
        waiting.pop_back();
        const Node& node_a = node_at(a, at.a);
        const Node& node_b = node_at(b, at.b);
        if (!node_a.box.meets(node_b.box)) continue;
        if (node_a.right == 0 && node_b.right == 0) {
            if (!visit_leaf_pair(a, node_a, b, node_b, visit)) return;
        } else if (opens_a(node_a, node_b)) {
            waiting.push_back({at.a + 1, at.b});
            waiting.push_back({node_a.right, at.b});
        } else {
            waiting.push_back({at.a, at.b + 1});
            waiting.push_back({at.a, node_b.right});
        }
    }
}

/// Where no edges meet, a ring lies wholly inside the other region or wholly outside.
bool holds_a_ring(const BoundaryIndex& region, const BoundaryIndex& rings) {
    const auto starts = rings.ring_starts();
    return std::any_of(starts.begin(), starts.end(),
                       [&](std::int32_t start) { return region.inside(rings.edge_start(start)); });
}

Point foot_on(const BoundaryIndex& index, std::int32_t edge, const Point& p) {
    return nearest_on_segment(index.edge_start(edge), index.edge_end(edge), p);
}

/// The edges of a leaf.
struct LeafEdges {
    const BoundaryIndex& index;
    const Node& node;
};

/// Of edges that do not cross, the shortest way begins or ends at one of their four ends.
void shorten(const LeafEdges& of_a, const LeafEdges& of_b, ClosestPoints& best, double& best2) {
    const BoundaryIndex& a = of_a.index;
    const BoundaryIndex& b = of_b.index;
    const auto offer = [&](const Point& on_a, const Point& on_b) {
        const double length2 = (on_b - on_a).squaredNorm();
        if (length2 >= best2) return;
        best2 = length2;
        best.on_a = on_a;
        best.on_b = on_b;
    };
    for (std::int32_t i = of_a.node.first_edge; i < of_a.node.last_edge; ++i)
        for (std::int32_t j = of_b.node.first_edge; j < of_b.node.last_edge; ++j) {
            offer(a.edge_start(i), foot_on(b, j, a.edge_start(i)));
            offer(a.edge_end(i), foot_on(b, j, a.edge_end(i)));
            offer(foot_on(a, i, b.edge_start(j)), b.edge_start(j));
            offer(foot_on(a, i, b.edge_end(j)), b.edge_end(j));
        }
}

struct WaitingPair {
    double least;
    IndexPair nodes;
};

}  // namespace

bool overlap(const BoundaryIndex& a, const BoundaryIndex& b) {
    bool meet = false;
    visit_crossings(a, b, [&](IndexPair) {
        meet = true;
        return false;
    });
    return meet || holds_a_ring(a, b) || holds_a_ring(b, a);
}

bool overlap(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
    return overlap(BoundaryIndex(a.polygon).carried(pose_a),
                   BoundaryIndex(b.polygon).carried(pose_b));
}

ClosestPoints closest_points(const BoundaryIndex& a, const BoundaryIndex& b) {
    ClosestPoints best;
    if (a.nodes().empty() || b.nodes().empty())
        throw lod::Error(lod::ErrorKind::input_refused, "an empty region is near nothing");
    if (overlap(a, b)) return best;
    double best2 = std::numeric_limits<double>::infinity();
    std::vector<WaitingPair> waiting{{0.0, {0, 0}}};
    const auto pair_of = [&](std::int32_t i, std::int32_t j) {
        return WaitingPair{node_at(a, i).box.squared_distance(node_at(b, j).box), {i, j}};
    };
    while (!waiting.empty()) {
        const auto [least, at] = waiting.back();
        waiting.pop_back();
        if (least >= best2) continue;
        const Node& node_a = node_at(a, at.a);
        const Node& node_b = node_at(b, at.b);
        if (node_a.right == 0 && node_b.right == 0) {
            shorten({a, node_a}, {b, node_b}, best, best2);
            continue;
        }
        const bool open_a = opens_a(node_a, node_b);
        WaitingPair near = open_a ? pair_of(at.a + 1, at.b) : pair_of(at.a, at.b + 1);
        WaitingPair far = open_a ? pair_of(node_a.right, at.b) : pair_of(at.a, node_b.right);
        if (far.least < near.least) std::swap(near, far);
        waiting.push_back(far);
        waiting.push_back(near);
    }
    best.distance = std::sqrt(best2);
    return best;
}

double distance(const BoundaryIndex& a, const BoundaryIndex& b) {
    return closest_points(a, b).distance;
}

}  // namespace lod2d
