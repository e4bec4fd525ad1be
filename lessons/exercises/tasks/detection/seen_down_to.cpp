#include <algorithm>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

/// In quarters; parents stand before their children.
struct Circle {
    std::int64_t x, y, r;
    int parent;
};
using Circles = std::vector<Circle>;

Numbers told_in(std::int64_t x, std::int64_t y, const Circles& tree) {
    const auto metres = [](std::int64_t quarters) { return static_cast<double>(quarters) / 4; };
    return joined({{metres(x), metres(y)}, tree_in_numbers(tree)});
}

std::vector<Numbers> edges() {
    const Circles leaf{{0, 0, 5, -1}};
    const Circles chain{{0, 0, 20, -1}, {3, 4, 5, 0}, {3, 4, 2, 1}};
    // The second child leads deeper than the first; the third holds the point below one that does
    // not.
    const Circles fork{{0, 0, 20, -1}, {1, 0, 8, 0}, {2, 0, 8, 0}, {20, 0, 2, 0},
                       {9, 0, 1, 1},   {2, 0, 4, 2}, {0, 0, 9, 3}, {0, 0, 9, 6}};
    return {told_in(3, 4, leaf),  told_in(6, 8, leaf),  told_in(0, 0, chain), told_in(3, 4, chain),
            told_in(3, 9, chain), told_in(0, 0, fork),  told_in(9, 0, fork),  told_in(30, 0, fork),
            told_in(2, 0, fork),  told_in(-8, 0, fork), told_in(0, 25, chain)};
}

Numbers random_case(lod::Random& random) {
    Circles tree{{whole(random, -6, 6), whole(random, -6, 6), 16, -1}};
    for (std::size_t i = 0; i < tree.size() && tree.size() < 14; ++i) {
        if (i > 0 && random.next() < 0.3) continue;
        for (int child = whole(random, 1, 3); child > 0; --child) {
            const Circle around = tree[i];
            const int r = static_cast<int>(around.r);
            tree.push_back({around.x + whole(random, -r / 2, r / 2),
                            around.y + whole(random, -r / 2, r / 2),
                            whole(random, r / 2, r - r / 4), static_cast<int>(i)});
        }
    }
    return told_in(whole(random, -12, 12), whole(random, -12, 12), tree);
}

/// Asks each circle whether it and all above it hold the point.
Numbers truth(const Numbers& asked) {
    const std::int64_t x = in_quarters(asked[0]);
    const std::int64_t y = in_quarters(asked[1]);
    const auto size = static_cast<std::size_t>(asked[2]);
    std::vector<int> depth(size, 0);
    std::vector<char> reached(size, 1);
    int deepest = -1;
    std::size_t at = 3;
    for (std::size_t i = 0; i < size; ++i) {
        const std::int64_t dx = in_quarters(asked[at]) - x;
        const std::int64_t dy = in_quarters(asked[at + 1]) - y;
        const std::int64_t r = in_quarters(asked[at + 2]);
        if (dx * dx + dy * dy > r * r) reached[i] = 0;
        if (reached[i] != 0) deepest = std::max(deepest, depth[i]);
        at += 3;
        for (auto children = static_cast<int>(asked[at++]); children > 0; --children) {
            const auto child = static_cast<std::size_t>(asked[at++]);
            depth[child] = depth[i] + 1;
            reached[child] = reached[i];
        }
    }
    return {static_cast<double>(deepest)};
}

}  // namespace

Task make_seen_down_to() {
    return {edges, random_case, truth};
}

}  // namespace exercises
