#include "lodlab/core/broad_phase.hpp"

#include <algorithm>
#include <numeric>

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
    const auto box = [&](std::int32_t body) -> const Box<Dim>& {
        return boxes_[static_cast<std::size_t>(body)];
    };
    // Insertion sort: nearly linear on an order that is nearly right already.
    for (std::size_t i = 1; i < order_.size(); ++i) {
        const std::int32_t body = order_[i];
        std::size_t place = i;
        for (; place > 0 && box(body).low[0] < box(order_[place - 1]).low[0]; --place)
            order_[place] = order_[place - 1];
        order_[place] = body;
    }
    pairs.clear();
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const std::int32_t a = order_[i];
        for (std::size_t k = i + 1; k < order_.size(); ++k) {
            const std::int32_t b = order_[k];
            if (box(b).low[0] > box(a).high[0]) break;
            const bool both_static = bodies[static_cast<std::size_t>(a)].is_static() &&
                                     bodies[static_cast<std::size_t>(b)].is_static();
            if (!both_static && box(a).meets(box(b)))
                pairs.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    std::sort(pairs.begin(), pairs.end(), [](const CandidatePair& x, const CandidatePair& y) {
        return x.a != y.a ? x.a < y.a : x.b < y.b;
    });
}

template class BroadPhase<2>;
template class BroadPhase<3>;

}  // namespace lod
