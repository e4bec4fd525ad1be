#include "lodlab/lod2d/shape/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lodlab/lod2d/shape/orientation.hpp"

namespace lod2d {
Point nearest_on_segment(const Point& a, const Point& b, const Point& p) {
    const Point along = b - a;
    const double length2 = along.squaredNorm();
    if (length2 == 0) return a;
    const double t = (p - a).dot(along) / length2;
    if (t <= 0) return a;
    if (t >= 1) return b;
    return a + t * along;
}

BoundaryIndex::BoundaryIndex(const Polygon& polygon) {
    std::vector<Box> boxes;
    for (const Ring& ring : polygon.rings) {
        ring_starts_.push_back(static_cast<std::int32_t>(points_.size()));
        points_.insert(points_.end(), ring.begin(), ring.end());
        ring_ends_.push_back(static_cast<std::int32_t>(points_.size()));
        points_.push_back(ring.front());
        boxes.emplace_back();
        for (const Point& p : ring) boxes.back().hold(p);
    }
    std::vector<std::int32_t> rings(ring_starts_.size());
    std::iota(rings.begin(), rings.end(), 0);
    nodes_.reserve(points_.size());
    build_rings(rings, boxes);
    fit_boxes();
}

/// Halves the rings by the middles of their boxes, along the longer side.
void BoundaryIndex::build_rings(std::span<std::int32_t> rings, std::span<const Box> boxes) {
    if (rings.empty()) return;
    if (rings.size() == 1) {
        build_run(ring_starts_[index(rings[0])], ring_ends_[index(rings[0])]);
        return;
    }
    Box middles;
    for (std::int32_t ring : rings) middles.hold(boxes[index(ring)].centre());
    const int axis = middles.size().x() >= middles.size().y() ? 0 : 1;
    const std::size_t half = rings.size() / 2;
    std::nth_element(rings.begin(), rings.begin() + static_cast<std::ptrdiff_t>(half), rings.end(),
                     [&](std::int32_t a, std::int32_t b) {
                         const double at_a = boxes[index(a)].centre()[axis];
                         const double at_b = boxes[index(b)].centre()[axis];
                         return at_a < at_b || (at_a == at_b && a < b);
                     });
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    build_rings(rings.first(half), boxes);
    nodes_[node].right = static_cast<std::int32_t>(nodes_.size());
    build_rings(rings.subspan(half), boxes);
    nodes_[node].after = static_cast<std::uint32_t>(nodes_.size());
}

void BoundaryIndex::build_run(std::int32_t first_edge, std::int32_t last_edge) {
    const std::size_t node = nodes_.size();
    nodes_.push_back({{}, 0, 0, first_edge, last_edge, true});
    if (last_edge - first_edge > edges_in_leaf) {
        const std::int32_t middle = first_edge + (last_edge - first_edge) / 2;
        build_run(first_edge, middle);
        nodes_[node].right = static_cast<std::int32_t>(nodes_.size());
        build_run(middle, last_edge);
    }
    nodes_[node].after = static_cast<std::uint32_t>(nodes_.size());
}

Box BoundaryIndex::box_of_run(const Node& node) const {
    Box box;
    for (std::int32_t i = node.first_edge; i <= node.last_edge; ++i) box.hold(points_[index(i)]);
    return box;
}

/// Children stand after their parents, so one pass from the back fits every box.
void BoundaryIndex::fit_boxes() {
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        Node& node = nodes_[i];
        if (node.right == 0) {
            node.box = box_of_run(node);
        } else {
            node.box = nodes_[i + 1].box;
            node.box.hold(nodes_[index(node.right)].box);
        }
    }
}

bool BoundaryIndex::inside(const Point& p) const {
    if (nodes_.empty()) return false;
    bool odd = false;  // crossings of the ray from p towards +x
    std::int32_t stack[deepest];
    int waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
        const std::int32_t at = stack[--waiting];
        const Node& node = nodes_[index(at)];
        const Box& box = node.box;
        if (box.high.y() < p.y() || box.low.y() > p.y() || box.high.x() < p.x()) continue;
        if (node.one_run && box.low.x() > p.x()) {
            const bool starts_above = points_[index(node.first_edge)].y() > p.y();
            const bool ends_above = points_[index(node.last_edge)].y() > p.y();
            odd ^= starts_above != ends_above;
        } else if (node.right != 0) {
            stack[waiting++] = node.right;
            stack[waiting++] = at + 1;
        } else {
            for (std::int32_t e = node.first_edge; e < node.last_edge; ++e) {
                const Point& a = edge_start(e);
                const Point& b = edge_end(e);
                if (on_segment(a, b, p)) return true;
                if ((a.y() > p.y()) == (b.y() > p.y())) continue;
                const bool upwards = b.y() > a.y();
                odd ^= (orientation(a, b, p) > 0) == upwards;
            }
        }
    }
    return odd;
}

NearestPoint BoundaryIndex::nearest(const Point& p) const {
    struct Waiting {
        double least;  // no edge of the node is nearer [m^2]
        std::int32_t node;
    };
    NearestPoint best;
    double best2 = std::numeric_limits<double>::infinity();
    Waiting stack[deepest];
    int waiting = 0;
    if (!nodes_.empty()) stack[waiting++] = {0.0, 0};
    while (waiting > 0) {
        const Waiting next = stack[--waiting];
        if (next.least >= best2) continue;
        const Node& node = nodes_[index(next.node)];
        if (node.right != 0) {
            Waiting near{nodes_[index(next.node + 1)].box.squared_distance(p), next.node + 1};
            Waiting far{nodes_[index(node.right)].box.squared_distance(p), node.right};
            if (far.least < near.least) std::swap(near, far);
            stack[waiting++] = far;
            stack[waiting++] = near;
            continue;
        }
        for (std::int32_t e = node.first_edge; e < node.last_edge; ++e) {
            const Point foot = nearest_on_segment(edge_start(e), edge_end(e), p);
            const double distance2 = (p - foot).squaredNorm();
            if (distance2 < best2) {
                best2 = distance2;
                best = {foot, 0, e};
            }
        }
    }
    best.distance = std::sqrt(best2);
    return best;
}

double BoundaryIndex::distance(const Point& p) const {
    return inside(p) ? 0 : nearest(p).distance;
}

double BoundaryIndex::signed_distance(const Point& p) const {
    const double to_boundary = nearest(p).distance;
    return inside(p) ? -to_boundary : to_boundary;
}

void BoundaryIndex::carry(const Pose& pose, BoundaryIndex& result) const {
    const lod::Matrix<2> rotation = lod::Space<2>::rotation(pose.angle);
    result.points_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
        result.points_[i] = rotation * points_[i] + pose.position;
    result.ring_starts_ = ring_starts_;
    result.ring_ends_ = ring_ends_;
    result.nodes_ = nodes_;
    result.fit_boxes();
}

BoundaryIndex BoundaryIndex::carried(const Pose& pose) const {
    BoundaryIndex result{Polygon{}};
    carry(pose, result);
    return result;
}

}  // namespace lod2d
