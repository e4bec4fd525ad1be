#include "lodlab/core/broad/static_bodies.hpp"

#include <algorithm>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

/// The first level at which no node with children is larger than `large`, within most_nodes.
template <int Dim>
int coarse_level(const SphereTree<Dim>& tree, double large, int most_nodes) {
    int leaves_above = 0;
    for (int level = 0; level + 1 < tree.levels(); ++level) {
        bool is_coarse = false;
        for (int node = tree.level_begin[at(level)]; node < tree.level_begin[at(level + 1)]; ++node)
            if (tree.is_leaf(node))
                ++leaves_above;
            else
                is_coarse = is_coarse || tree.radius[at(node)] > large;
        const int next = tree.level_begin[at(level + 2)] - tree.level_begin[at(level + 1)];
        if (!is_coarse || leaves_above + next > most_nodes) return level;
    }
    return tree.levels() - 1;
}

}  // namespace

template <int Dim>
void StaticBodies<Dim>::update(std::span<const std::int32_t> numbers,
                               std::span<const Body<Dim>> bodies,
                               std::span<const PosedTree<Dim>> world_S, double largest) {
    if (largest == largest_ && stand_as_before(numbers, bodies, world_S)) return;
    largest_ = largest;
    standing_.clear();
    node_boxes_.clear();
    owner_.clear();
    for (const std::int32_t number : numbers) add(number, bodies);
    boxes_.build(node_boxes_);
    ++built_;
}

template <int Dim>
bool StaticBodies<Dim>::stand_as_before(std::span<const std::int32_t> numbers,
                                        std::span<const Body<Dim>> bodies,
                                        std::span<const PosedTree<Dim>> world_S) const {
    if (numbers.size() != standing_.size()) return false;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Standing& before = standing_[i];
        const PosedTree<Dim>& now = world_S[at(numbers[i])];
        if (before.body != numbers[i] || before.tree != bodies[at(numbers[i])].tree ||
            !(before.position == now.position()) || !(before.rotation == now.rotation()))
            return false;
    }
    return true;
}

template <int Dim>
void StaticBodies<Dim>::add(std::int32_t body, std::span<const Body<Dim>> bodies) {
    posed_.pose(bodies[at(body)]);
    const SphereTree<Dim>& tree = posed_.tree();
    const Box<Dim> root = box_of(posed_, 0);
    standing_.push_back(
        {body, bodies[at(body)].tree, posed_.rotation(), posed_.position(), root, 0});
    const int level = coarse_level(tree, much_larger * largest_, most_nodes);
    const std::int32_t begin = tree.level_begin[at(level)];
    for (std::int32_t node = 0; node < tree.level_begin[at(level + 1)]; ++node) {
        if (node < begin && !tree.is_leaf(node)) continue;
        const Box<Dim> box = box_of(posed_, node);
        if (!is_somewhere(box)) continue;
        node_boxes_.push_back(box);
        owner_.push_back(standing_.size() - 1);
    }
}

template <int Dim>
void StaticBodies<Dim>::find(const BodyBox<Dim>& mover, std::vector<CandidatePair>& pairs) {
    ++finds_;
    boxes_.each_meeting(mover.box, [&](std::size_t node) {
        Standing& wall = standing_[owner_[node]];
        if (wall.met_by == finds_) return;
        wall.met_by = finds_;
        if (!wall.root.meets(mover.box)) return;
        pairs.push_back({std::min(wall.body, mover.body), std::max(wall.body, mover.body)});
    });
}

template class StaticBodies<2>;
template class StaticBodies<3>;

}  // namespace lod
