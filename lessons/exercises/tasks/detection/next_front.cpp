#include <algorithm>
#include <set>
#include <utility>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

/// A node of quarters, and which node it is a child of.
struct Circle {
    std::int64_t x, y, r;
    int parent;
    bool leaf = true;
};
using Circles = std::vector<Circle>;
using Front = std::set<std::pair<int, int>>;

bool overlap(const Circle& a, const Circle& b) {
    const std::int64_t reach = a.r + b.r;
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) <= reach * reach;
}

/// Asks every pair of circles whether it comes from one of the front.
Front next(const Circles& a, const Circles& b, const Front& front) {
    const auto source = [](const Circles& tree, int i, bool stays) {
        const Circle& circle = tree[static_cast<std::size_t>(i)];
        return stays ? (circle.leaf ? i : -1) : circle.parent;
    };
    Front found;
    for (int i = 0; i < static_cast<int>(a.size()); ++i)
        for (int k = 0; k < static_cast<int>(b.size()); ++k)
            for (const bool i_stays : {false, true})
                for (const bool k_stays : {false, true})
                    if (front.count({source(a, i, i_stays), source(b, k, k_stays)}) > 0 &&
                        overlap(a[static_cast<std::size_t>(i)], b[static_cast<std::size_t>(k)]))
                        found.insert({i, k});
    return found;
}

Circles random_tree(lod::Random& random) {
    Circles tree{{whole(random, -8, 8), whole(random, -8, 8), 16, -1}};
    for (std::size_t i = 0; i < tree.size() && tree.size() < 12; ++i) {
        if (i > 0 && random.next() < 0.4) continue;
        for (int child = whole(random, i == 0 ? 1 : 0, 3); child > 0; --child) {
            const Circle around = tree[i];
            const int r = static_cast<int>(around.r);
            tree[i].leaf = false;
            tree.push_back({around.x + whole(random, -r / 2, r / 2),
                            around.y + whole(random, -r / 2, r / 2),
                            whole(random, r / 4, r - r / 3), static_cast<int>(i)});
        }
    }
    return tree;
}

Numbers told_in(const Front& front) {
    Numbers numbers{static_cast<double>(front.size())};
    for (const auto& [a, b] : front) {
        numbers.push_back(a);
        numbers.push_back(b);
    }
    return numbers;
}

Numbers told_in(const Circles& a, const Circles& b, const Front& front) {
    return joined({tree_in_numbers(a), tree_in_numbers(b), told_in(front)});
}

std::vector<Numbers> edges() {
    const Circles leaf{{0, 0, 8, -1}};
    const Circles pair{{0, 0, 8, -1, false}, {-4, 0, 4, 0}, {4, 0, 4, 0}};
    const Circles touching{{16, 0, 8, -1, false}, {12, 0, 4, 0}, {20, 0, 4, 0}};
    const Circles far{{14, 8, 8, -1, false}, {16, 8, 2, 0}};
    return {told_in(leaf, leaf, {{0, 0}}), told_in(leaf, pair, {{0, 0}}),
            told_in(pair, leaf, {{0, 0}}), told_in(pair, touching, {{0, 0}}),
            told_in(pair, pair, {{1, 1}}), told_in(pair, far, {{0, 0}}),
            told_in(pair, touching, {}),   told_in(pair, pair, {{1, 1}, {1, 2}, {2, 2}})};
}

Numbers random_case(lod::Random& random) {
    const Circles a = random_tree(random);
    const Circles b = random_tree(random);
    Front front{{0, 0}};
    for (int level = whole(random, 0, 2); level > 0; --level) front = next(a, b, front);
    return told_in(a, b, front);
}

std::size_t read_tree(const Numbers& asked, std::size_t at, Circles& tree) {
    tree.assign(static_cast<std::size_t>(asked[at++]), {0, 0, 0, -1});
    for (std::size_t i = 0; i < tree.size(); ++i) {
        tree[i].x = in_quarters(asked[at++]);
        tree[i].y = in_quarters(asked[at++]);
        tree[i].r = in_quarters(asked[at++]);
        const auto children = static_cast<std::size_t>(asked[at++]);
        tree[i].leaf = children == 0;
        for (std::size_t k = 0; k < children; ++k)
            tree[static_cast<std::size_t>(asked[at++])].parent = static_cast<int>(i);
    }
    return at;
}

Numbers truth(const Numbers& asked) {
    Circles a;
    Circles b;
    std::size_t at = read_tree(asked, read_tree(asked, 0, a), b);
    Front front;
    for (auto pairs = static_cast<int>(asked[at++]); pairs > 0; --pairs, at += 2)
        front.insert({static_cast<int>(asked[at]), static_cast<int>(asked[at + 1])});
    return told_in(next(a, b, front));
}

}  // namespace

Task make_next_front() {
    return {edges, random_case, truth};
}

}  // namespace exercises
