#include "lodlab/measure/plane_bodies.hpp"

#include <algorithm>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"

namespace measure {
namespace {

/// How deep the deepest corner of one outline lies within another; both in the world frame.
double deepest_corner(const lod2d::BoundaryIndex& of, const lod2d::BoundaryIndex& within) {
    double depth = 0;
    for (const lod2d::BoundaryIndex::Node& node : of.nodes()) {
        if (node.right != 0) continue;
        for (std::int32_t edge = node.first_edge; edge < node.last_edge; ++edge) {
            const lod2d::Point& corner = of.edge_start(edge);
            if (!within.nodes()[0].box.holds(corner)) continue;
            depth = std::max(depth, -within.signed_distance(corner));
        }
    }
    return depth;
}

}  // namespace

PlaneBodies::PlaneBodies(std::span<const lod2d::Shape* const> shapes) {
    for (const lod2d::Shape* shape : shapes) {
        outlines_.emplace_back(shape->polygon);
        double squared = 0;
        for (const lod2d::Ring& ring : shape->polygon.rings)
            for (const lod2d::Point& point : ring) squared = std::max(squared, point.squaredNorm());
        sizes_.push_back(2 * std::sqrt(squared));
    }
}

double PlaneBodies::size(int body) const {
    return sizes_[lod::at(body)];
}

double PlaneBodies::separation(int a, const lod::Body<2>& state_a, int b,
                               const lod::Body<2>& state_b) const {
    const auto outline_a = outlines_[lod::at(a)].carried({state_a.position, state_a.orientation});
    const auto outline_b = outlines_[lod::at(b)].carried({state_b.position, state_b.orientation});
    const double distance = lod2d::distance(outline_a, outline_b);
    if (distance > 0) return distance;
    return -std::max(deepest_corner(outline_a, outline_b), deepest_corner(outline_b, outline_a));
}

}  // namespace measure
