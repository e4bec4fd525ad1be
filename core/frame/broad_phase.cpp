#include "lodlab/core/frame/broad_phase.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

/// Shifts a body beyond which sorting anew is cheaper than insertion: about what std::sort compares
/// a body among some thousands, 2 log2 n.
constexpr std::uint64_t most_shifts = 24;

}  // namespace

template <int Dim>
void BroadPhase<Dim>::find(std::span<const Body<Dim>> bodies,
                           std::span<const PosedTree<Dim>> world_S,
                           std::vector<CandidatePair>& pairs) {
    if (order_.size() != bodies.size()) {
        order_.resize(bodies.size());
        std::iota(order_.begin(), order_.end(), 0);
        boxes_.resize(bodies.size());
        in_order_ = false;
    }
    steps_ = 0;
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
    Box<Dim> all;
    for (const Box<Dim>& box : boxes_)
        if (!box.is_empty()) all.hold(box);
    choose_axes(all);
    sort_along_sweep();
    deal_into_rows(bodies, all);
    pairs.clear();
    for (std::size_t row = 0; row < rows_.count; ++row) sweep(row, pairs);
    for (const std::int32_t wall : half_spaces_) add_pairs(wall, bodies, world_S, pairs);
    sort_pairs(bodies.size(), pairs);
}

/// The widest for the sweep, the next for the rows; of equal ones the lower.
template <int Dim>
void BroadPhase<Dim>::choose_axes(const Box<Dim>& all) {
    const Vector<Dim> size = all.is_empty() ? Vector<Dim>(Vector<Dim>::Zero()) : all.size();
    const int before = along_;
    std::array<int, Dim> axes;
    std::iota(axes.begin(), axes.end(), 0);
    std::sort(axes.begin(), axes.end(),
              [&](int i, int k) { return size[i] > size[k] || (size[i] == size[k] && i < k); });
    along_ = axes[0];
    across_ = axes[1];
    if (along_ != before) in_order_ = false;
}

/// Every box into all rows that it reaches, those of a row in the order along the sweep.
template <int Dim>
void BroadPhase<Dim>::deal_into_rows(std::span<const Body<Dim>> bodies, const Box<Dim>& all) {
    double heights = 0;
    std::size_t count = 0;
    for (const Box<Dim>& box : boxes_) {
        if (box.is_empty()) continue;
        heights += box.size()[across_];
        ++count;
    }
    const double extent = count > 0 ? all.size()[across_] : 0;
    const double wanted = heights > 0 ? extent * static_cast<double>(count) / (2 * heights) : 1;
    rows_.count = static_cast<std::size_t>(std::clamp(wanted, 1.0, most_rows));
    rows_.low = all.low[across_];
    rows_.height = extent / static_cast<double>(rows_.count);
    refill(row_begin_, rows_.count + 2, 0);
    for (const Box<Dim>& box : boxes_)
        for (std::size_t row = rows_.of(box.low[across_]);
             !box.is_empty() && row <= rows_.of(box.high[across_]); ++row)
            ++row_begin_[row + 2];
    std::partial_sum(row_begin_.begin(), row_begin_.end(), row_begin_.begin());
    entries_.resize(static_cast<std::size_t>(row_begin_.back()));
    for (const std::int32_t body : order_) {
        const Box<Dim>& box = boxes_[static_cast<std::size_t>(body)];
        const Entry entry{box, body, bodies[static_cast<std::size_t>(body)].is_static()};
        if (box.is_empty()) continue;
        for (std::size_t row = rows_.of(box.low[across_]); row <= rows_.of(box.high[across_]);
             ++row)
            entries_[static_cast<std::size_t>(row_begin_[row + 1]++)] = entry;
    }
}

/// Sweeps one row. A pair that shares several rows counts in the first.
template <int Dim>
void BroadPhase<Dim>::sweep(std::size_t row, std::vector<CandidatePair>& pairs) {
    const auto end = static_cast<std::size_t>(row_begin_[row + 1]);
    for (auto i = static_cast<std::size_t>(row_begin_[row]); i < end; ++i) {
        const Entry& a = entries_[i];
        for (std::size_t k = i + 1; k < end; ++k) {
            const Entry& b = entries_[k];
            ++steps_;
            if (b.box.low[along_] > a.box.high[along_]) break;
            if ((a.is_static && b.is_static) || !a.box.meets(b.box)) continue;
            if (rows_.of(std::max(a.box.low[across_], b.box.low[across_])) == row)
                pairs.push_back({std::min(a.body, b.body), std::max(a.body, b.body)});
        }
    }
}

template <int Dim>
void BroadPhase<Dim>::sort_along_sweep() {
    if (!in_order_ || !insert_in_order())
        std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
            const double low_a = boxes_[static_cast<std::size_t>(a)].low[along_];
            const double low_b = boxes_[static_cast<std::size_t>(b)].low[along_];
            return low_a < low_b || (low_a == low_b && a < b);
        });
    in_order_ = true;
}

/// Insertion sort: nearly linear on an order that is nearly right already. Returns false where it
/// gave up, because the order is far from right.
template <int Dim>
bool BroadPhase<Dim>::insert_in_order() {
    const auto low = [&](std::int32_t body) {
        return boxes_[static_cast<std::size_t>(body)].low[along_];
    };
    const std::uint64_t most_steps = steps_ + most_shifts * order_.size();
    for (std::size_t i = 1; i < order_.size(); ++i) {
        const std::int32_t body = order_[i];
        std::size_t place = i;
        for (; place > 0 && low(body) < low(order_[place - 1]); --place)
            order_[place] = order_[place - 1];
        order_[place] = body;
        steps_ += i - place;
        if (steps_ > most_steps) return false;
    }
    return true;
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
