#include "lodlab/core/frame/schedule/collision_tree.hpp"

#include "tests/catch.hpp"

using namespace lod;

namespace {

/// Two pairs: the first finishes levels of 1, 3 and 2 node pairs, the second of 1 and 4.
struct Stored {
    CollisionTree tree;
    std::vector<ListedFront> fronts{2};
    FrontList list;

    Stored() {
        add(0, 0, {{0, 0}});
        add(1, 0, {{0, 0}});
        add(0, 1, {{1, 1}, {1, 2}, {2, 2}});
        add(1, 1, {{5, 1}, {5, 2}, {5, 3}, {5, 4}});
        add(0, 2, {{7, 7}, {8, 8}});
    }
    void add(std::int32_t pair, int level, const std::vector<NodePair>& nodes) {
        ListedFront front;
        front.level = level;
        front.pairs.count = static_cast<std::int32_t>(nodes.size());
        tree.add(pair, front, nodes);
    }
    std::vector<int> levels_with(std::uint64_t most_pairs, bool all) {
        CHECK(tree.resolve(most_pairs, fronts, list) == all);
        return {fronts[0].level, fronts[1].level};
    }
};

}  // namespace

TEST_CASE("each pair is answered at its last stored level that can be paid for", "[stored]") {
    Stored stored;
    CHECK(stored.levels_with(0, false) == std::vector{0, 0});  // entry levels in any case
    CHECK(stored.levels_with(3, false) == std::vector{0, 0});
    CHECK(stored.levels_with(4, false) == std::vector{2, 0});  // 3 + 1, and fewer after that
    CHECK(stored.levels_with(6, false) == std::vector{2, 0});
    CHECK(stored.levels_with(7, true) == std::vector{2, 1});
    const auto first = stored.list.pairs_of(stored.fronts[0]);
    CHECK(std::vector(first.begin(), first.end()) == std::vector<NodePair>{{7, 7}, {8, 8}});
    CHECK(stored.list.pairs_of(stored.fronts[1]).size() == 4);
}

TEST_CASE("a pair that stays behind at a level skips none", "[stored]") {
    Stored stored;
    stored.add(1, 2, {});  // apart
    CHECK(stored.levels_with(6, false) == std::vector{2, 0});
    CHECK(stored.levels_with(7, true) == std::vector{2, 2});
    CHECK(stored.tree.size() == 6);
    stored.tree.clear();
    CHECK(stored.tree.size() == 0);
}
