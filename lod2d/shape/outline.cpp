#include "lodlab/lod2d/shape/outline.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/math/bit_hash.hpp"
#include "lodlab/lod2d/shape/orientation.hpp"

namespace lod2d {
namespace {

using Pair = lod::PartPair<2>;

}  // namespace

lod::PartPair<2> nearest_edges(const lod::Facet<2>& a, const lod::Facet<2>& b, double feet_within) {
    Pair pair;
    pair.a = lod::part_of<2>(a);
    pair.b = lod::part_of<2>(b);
    if (segments_meet(a[0], a[1], b[0], b[1])) return pair;
    const std::array<Pair::Feet, 4> feet{{{a[0], nearest_on_segment(b[0], b[1], a[0])},
                                          {a[1], nearest_on_segment(b[0], b[1], a[1])},
                                          {nearest_on_segment(a[0], a[1], b[0]), b[0]},
                                          {nearest_on_segment(a[0], a[1], b[1]), b[1]}}};
    const auto length = [](const Pair::Feet& f) { return (f.on_b - f.on_a).norm(); };
    pair.nearest = *std::min_element(
        feet.begin(), feet.end(),
        [&](const Pair::Feet& f, const Pair::Feet& g) { return length(f) < length(g); });
    pair.distance = length(pair.nearest);
    for (const Pair::Feet& f : feet)
        if (length(f) <= feet_within) pair.feet[pair.feet_count++] = f;
    pair.add_direction(lod::Space<2>::facet_normal(a).normalized());
    pair.add_direction(-lod::Space<2>::facet_normal(b).normalized());
    pair.firm_directions = pair.directions;
    if (pair.distance > 0)
        pair.add_direction((pair.nearest.on_b - pair.nearest.on_a) / pair.distance);
    return pair;
}

ExactOutline::ExactOutline(const Shape& shape) : index_(shape.polygon) {
    lod::BitHash hash;
    for (const Ring& ring : shape.polygon.rings) {
        hash.add_all(ring);
        witnesses_.push_back(ring.front());
        for (const Point& p : ring) radius_ = std::max(radius_, p.norm());
    }
    hash_ = hash.value();
    if (witnesses_.empty())
        throw lod::Error(lod::ErrorKind::input_refused,
                         shape.name + ": an empty polygon has no outline");
}

lod::BoxNode<2> ExactOutline::box_node(std::int32_t i) const {
    const BoundaryIndex::Node& node = index_.nodes()[static_cast<std::size_t>(i)];
    return {node.box.low, node.box.high, node.right, node.first_edge, node.last_edge};
}

lod::Facet<2> ExactOutline::facet(std::int32_t edge) const {
    return {index_.edge_start(edge), index_.edge_end(edge)};
}

void ExactOutline::visit_pairs(const lod::ExactShape<2>& b, const lod::Placement<2>& b_in_a,
                               lod::PartVisitor<2>& visitor) const {
    lod::walk_pairs<2>(*this, lod::of_kind<ExactOutline>(b, "an outline"), b_in_a, nearest_edges,
                       visitor);
}

void ExactOutline::keep_corners(const Point& normal, double tolerance,
                                std::vector<lod::Contact<2>>& contacts) const {
    const Point along(-normal.y(), normal.x());
    const auto place = [&](const lod::Contact<2>& c) { return along.dot(c.point); };
    const auto ends = std::minmax_element(
        contacts.begin(), contacts.end(),
        [&](const lod::Contact<2>& c, const lod::Contact<2>& d) { return place(c) < place(d); });
    const lod::Contact<2> first = *ends.first;
    const lod::Contact<2> last = *ends.second;
    contacts = {first};
    if (place(last) - place(first) > tolerance) contacts.push_back(last);
}

}  // namespace lod2d
