#include "lodlab/core/frame/schedule/collision_tree.hpp"

#include <algorithm>

#include "lodlab/core/base/lists.hpp"

namespace lod {

void CollisionTree::clear() {
    levels_.clear();
    node_pairs_.clear();
}

void CollisionTree::add(std::int32_t pair, const ListedFront& front,
                        std::span<const NodePair> node_pairs) {
    levels_.push_back({pair, front});
    levels_.back().front.pairs.first = static_cast<std::int32_t>(node_pairs_.size());
    node_pairs_.insert(node_pairs_.end(), node_pairs.begin(), node_pairs.end());
}

bool CollisionTree::resolve(std::uint64_t most_pairs, std::vector<ListedFront>& fronts,
                            FrontList& list) {
    refill(chosen_, fronts.size(), std::int32_t{-1});
    std::uint64_t node_pairs = 0;
    bool all = true;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const ListedFront& front = levels_[i].front;
        std::int32_t& chosen = chosen_[at(levels_[i].pair)];
        const bool entry = chosen < 0;
        const std::int32_t before = entry ? 0 : levels_[at(chosen)].front.pairs.count;
        // A pair that stays behind at a level stays there.
        const bool follows = entry || levels_[at(chosen)].front.level + 1 == front.level;
        const std::uint64_t after = node_pairs - static_cast<std::uint64_t>(before) +
                                    static_cast<std::uint64_t>(front.pairs.count);
        if (!follows || (!entry && after > most_pairs && after > node_pairs)) {
            all = false;
            continue;
        }
        chosen = static_cast<std::int32_t>(i);
        node_pairs = after;
    }
    list.clear();
    for (std::size_t p = 0; p < fronts.size(); ++p) {
        const std::uint64_t tests = fronts[p].tests;
        fronts[p] = levels_[at(chosen_[p])].front;
        fronts[p].tests = tests;
        fronts[p].list = 0;
        const auto kept = fronts[p].pairs.of(std::span<const NodePair>(node_pairs_));
        fronts[p].pairs.first = static_cast<std::int32_t>(list.size());
        std::copy(kept.begin(), kept.end(), list.room_for(kept.size()));
        list.take(kept.size());
    }
    return all;
}

}  // namespace lod
