#include "lodlab/core/frame/broad_phase.hpp"

#include <algorithm>
#include <numeric>

#include "lodlab/core/base/refill.hpp"

namespace lod {

template <int Dim>
void BroadPhase<Dim>::find(std::span<const Body<Dim>> bodies,
                           std::span<const PosedTree<Dim>> world_S,
                           std::vector<CandidatePair>& pairs) {
    if (order_.size() != bodies.size()) {
        order_.resize(bodies.size());
        std::iota(order_.begin(), order_.end(), 0);
        boxes_.resize(bodies.size());
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Sphere<Dim> root = world_S[i].sphere(0);
        // Two units of rounding for the sum itself.
        const double reach = (root.radius + 2 * world_S[i].rounding());
        const Vector<Dim> half = Vector<Dim>::Constant(reach);
        boxes_[i] = {root.centre - half, root.centre + half};
    }
    half_spaces_.clear();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!world_S[i].is_half_space()) continue;
        half_spaces_.push_back(static_cast<std::int32_t>(i));
        boxes_[i] = Box<Dim>();  // meets no other, and lies behind all along every axis
    }
    sort_along_first_axis();
    deal_into_rows(bodies);
    pairs.clear();
    for (std::size_t row = 0; row < rows_.count; ++row) sweep(row, pairs);
    for (const std::int32_t wall : half_spaces_) add_pairs(wall, bodies, world_S, pairs);
    sort_pairs(bodies.size(), pairs);
}

/// Every box into all rows that it reaches, those of a row in the order along the first axis.
template <int Dim>
void BroadPhase<Dim>::deal_into_rows(std::span<const Body<Dim>> bodies) {
    Box<Dim> all;
    double heights = 0;
    std::size_t count = 0;
    for (const Box<Dim>& box : boxes_) {
        if (box.is_empty()) continue;
        all.hold(box);
        heights += box.size()[1];
        ++count;
    }
    const double extent = count > 0 ? all.size()[1] : 0;
    const double wanted = heights > 0 ? extent * static_cast<double>(count) / (2 * heights) : 1;
    rows_.count = static_cast<std::size_t>(std::clamp(wanted, 1.0, most_rows));
    rows_.low = all.low[1];
    rows_.height = extent / static_cast<double>(rows_.count);
    refill(row_begin_, rows_.count + 2, 0);
    for (const Box<Dim>& box : boxes_)
        for (std::size_t row = rows_.of(box.low[1]);
             !box.is_empty() && row <= rows_.of(box.high[1]); ++row)
            ++row_begin_[row + 2];
    std::partial_sum(row_begin_.begin(), row_begin_.end(), row_begin_.begin());
    entries_.resize(static_cast<std::size_t>(row_begin_.back()));
    for (const std::int32_t body : order_) {
        const Box<Dim>& box = boxes_[static_cast<std::size_t>(body)];
        const Entry entry{box, body, bodies[static_cast<std::size_t>(body)].is_static()};
        if (box.is_empty()) continue;
        for (std::size_t row = rows_.of(box.low[1]); row <= rows_.of(box.high[1]); ++row)
            entries_[static_cast<std::size_t>(row_begin_[row + 1]++)] = entry;
    }
}

/// Sweeps one row along the first axis. A pair that shares several rows counts in the first.
template <int Dim>
void BroadPhase<Dim>::sweep(std::size_t row, std::vector<CandidatePair>& pairs) const {
    const auto end = static_cast<std::size_t>(row_begin_[row + 1]);
    for (auto i = static_cast<std::size_t>(row_begin_[row]); i < end; ++i) {
        const Entry& a = entries_[i];
        for (std::size_t k = i + 1; k < end; ++k) {
            const Entry& b = entries_[k];
            if (b.box.low[0] > a.box.high[0]) break;
            if ((a.is_static && b.is_static) || !a.box.meets(b.box)) continue;
            if (rows_.of(std::max(a.box.low[1], b.box.low[1])) == row)
                pairs.push_back({std::min(a.body, b.body), std::max(a.body, b.body)});
        }
    }
}

/// Insertion sort: nearly linear on an order that is nearly right already.
template <int Dim>
void BroadPhase<Dim>::sort_along_first_axis() {
    const auto low = [&](std::int32_t body) {
        return boxes_[static_cast<std::size_t>(body)].low[0];
    };
    for (std::size_t i = 1; i < order_.size(); ++i) {
        const std::int32_t body = order_[i];
        std::size_t place = i;
        for (; place > 0 && low(body) < low(order_[place - 1]); --place)
            order_[place] = order_[place - 1];
        order_[place] = body;
    }
}

/// By counting those of each first body.
template <int Dim>
void BroadPhase<Dim>::sort_pairs(std::size_t bodies, std::vector<CandidatePair>& pairs) {
    refill(begin_, bodies + 1, 0);
    for (const CandidatePair& pair : pairs) ++begin_[static_cast<std::size_t>(pair.a) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    unsorted_.resize(pairs.size());
    std::copy(pairs.begin(), pairs.end(), unsorted_.begin());
    for (const CandidatePair& pair : unsorted_)
        pairs[static_cast<std::size_t>(begin_[static_cast<std::size_t>(pair.a)]++)] = pair;
    for (std::size_t first = 0, end = 0; first < pairs.size(); first = end) {
        while (end < pairs.size() && pairs[end].a == pairs[first].a) ++end;
        const auto at = [&](std::size_t i) {
            return pairs.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::sort(at(first), at(end),
                  [](const CandidatePair& x, const CandidatePair& y) { return x.b < y.b; });
    }
}

/// Those of a half-space and all bodies that move.
template <int Dim>
void BroadPhase<Dim>::add_pairs(std::int32_t wall, std::span<const Body<Dim>> bodies,
                                std::span<const PosedTree<Dim>> world_S,
                                std::vector<CandidatePair>& pairs) {
    const PosedTree<Dim>& world = world_S[static_cast<std::size_t>(wall)];
    const HalfSpace<Dim> half_space = world.half_space();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].is_static()) continue;
        const Sphere<Dim> root = world_S[i].sphere(0);
        const double slack = 2 * (world.rounding() + world_S[i].rounding());
        if (half_space.side(root.centre) > root.radius + slack) continue;
        const auto body = static_cast<std::int32_t>(i);
        pairs.push_back({std::min(wall, body), std::max(wall, body)});
    }
}

template class BroadPhase<2>;
template class BroadPhase<3>;

}  // namespace lod
