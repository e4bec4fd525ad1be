#include "lodlab/core/frame/broad_phase.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

/// Whether a ball is beyond a border by its box alone: most are. What rounding does to the middle,
/// its side and the radius is a few units of the coordinates; `rounding` is the border's.
template <int Dim>
bool is_surely_beyond(const HalfSpace<Dim>& border, double rounding, const Box<Dim>& box) {
    constexpr double share = 64 * std::numeric_limits<double>::epsilon();
    const Vector<Dim> middle = box.centre();
    const double radius = 0.5 * (box.high[0] - box.low[0]);
    const double size = middle.cwiseAbs().maxCoeff() + radius + std::abs(border.offset);
    return border.side(middle) > radius + 2 * rounding + share * size;
}

}  // namespace

template <int Dim>
void BroadPhase<Dim>::find(std::span<const Body<Dim>> bodies,
                           std::span<const PosedTree<Dim>> world_S,
                           std::vector<CandidatePair>& pairs, Executor* executor) {
    sort_out(bodies, world_S);
    pairs.clear();
    grid_.find(movers_, executor, pairs);
    check_candidates(pairs.size());  // of all threads
    static_bodies_.update(static_, bodies, world_S, largest_);
    const std::uint64_t before = static_bodies_.steps();
    for (const BodyBox<Dim>& mover : movers_) {
        static_bodies_.find(mover, pairs);
        check_candidates(pairs.size());
    }
    steps_ =
        grid_.steps() + (static_bodies_.steps() - before) + half_spaces_.size() * movers_.size();
    if (!half_spaces_.empty()) add_half_spaces(world_S, executor, pairs);
    sort_pairs(bodies.size(), pairs);
}

/// By what they are to the broad phase.
template <int Dim>
void BroadPhase<Dim>::sort_out(std::span<const Body<Dim>> bodies,
                               std::span<const PosedTree<Dim>> world_S) {
    movers_.clear();
    half_spaces_.clear();
    static_.clear();
    largest_ = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto number = static_cast<std::int32_t>(i);
        if (world_S[i].is_half_space()) {
            half_spaces_.push_back(number);
        } else if (bodies[i].is_static()) {
            static_.push_back(number);
        } else {
            const Box<Dim> box = box_of(world_S[i], 0);
            if (!is_somewhere(box)) continue;
            movers_.push_back({box, number});
            largest_ = std::max(largest_, world_S[i].root().radius);
        }
    }
}

/// The pairs of half-spaces, in one pass over what moves for each.
template <int Dim>
void BroadPhase<Dim>::add_half_spaces(std::span<const PosedTree<Dim>> world_S, Executor* executor,
                                      std::vector<CandidatePair>& pairs) {
    at_half_spaces_.resize(workers_of(executor));
    for (std::vector<CandidatePair>& found : at_half_spaces_) found.clear();
    const std::span<const BodyBox<Dim>> movers(movers_);
    each_part(executor, movers.size(), bodies_of_a_part, [&](const Part& part) {
        meet_half_spaces(movers.subspan(part.begin, part.end - part.begin), world_S,
                         at_half_spaces_[part.worker]);
    });
    for (const std::vector<CandidatePair>& found : at_half_spaces_)
        pairs.insert(pairs.end(), found.begin(), found.end());
    check_candidates(pairs.size());
}

template <int Dim>
void BroadPhase<Dim>::meet_half_spaces(std::span<const BodyBox<Dim>> movers,
                                       std::span<const PosedTree<Dim>> world_S,
                                       std::vector<CandidatePair>& pairs) const {
    for (const std::int32_t wall : half_spaces_) {
        const HalfSpace<Dim> border = world_S[at(wall)].half_space();
        const double rounding = world_S[at(wall)].rounding();
        for (const BodyBox<Dim>& mover : movers) {
            if (is_surely_beyond(border, rounding, mover.box)) continue;
            const PosedTree<Dim>& world = world_S[at(mover.body)];
            const double slack = 2 * (rounding + world.rounding());
            if (border.side(world.root().centre) > world.root().radius + slack) continue;
            pairs.push_back({std::min(wall, mover.body), std::max(wall, mover.body)});
        }
        check_candidates(pairs.size());
    }
}

/// By counting: those of each second body, then, in that order, those of each first.
template <int Dim>
void BroadPhase<Dim>::sort_pairs(std::size_t bodies, std::vector<CandidatePair>& pairs) {
    unsorted_.resize(pairs.size());
    for (const auto number : {&CandidatePair::b, &CandidatePair::a}) {
        refill(begin_, bodies + 1, 0);
        for (const CandidatePair& pair : pairs) ++begin_[at(pair.*number) + 1];
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        pairs.swap(unsorted_);
        for (const CandidatePair& pair : unsorted_) pairs[at(begin_[at(pair.*number)]++)] = pair;
    }
}

template class BroadPhase<2>;
template class BroadPhase<3>;

}  // namespace lod
