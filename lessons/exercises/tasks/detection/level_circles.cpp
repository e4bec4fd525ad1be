#include <algorithm>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

/// A tree by the parent of each circle, -1 for the root; parents stand before their children.
using Parents = std::vector<int>;

Numbers told_in(const Parents& parents, int level) {
    Numbers numbers{static_cast<double>(parents.size())};
    for (int i = 0; i < static_cast<int>(parents.size()); ++i) {
        Numbers children;
        for (int k = 0; k < static_cast<int>(parents.size()); ++k)
            if (parents[static_cast<std::size_t>(k)] == i) children.push_back(k);
        numbers.push_back(static_cast<double>(children.size()));
        numbers.insert(numbers.end(), children.begin(), children.end());
    }
    numbers.push_back(level);
    return numbers;
}

std::vector<Numbers> edges() {
    const Parents leaf{-1};
    const Parents two{-1, 0, 0};
    const Parents uneven{-1, 0, 0, 2, 2};
    const Parents chain{-1, 0, 1, 2};
    return {told_in(leaf, 0),   told_in(leaf, 2),   told_in(two, 0),   told_in(two, 1),
            told_in(uneven, 1), told_in(uneven, 2), told_in(chain, 3), told_in(uneven, 5)};
}

Numbers random_case(lod::Random& random) {
    Parents parents{-1};
    for (std::size_t i = 0; i < parents.size() && parents.size() < 14; ++i) {
        if (i > 0 && random.next() < 0.4) continue;
        for (int child = whole(random, 1, 4); child > 0; --child)
            parents.push_back(static_cast<int>(i));
    }
    return told_in(parents, whole(random, 0, 4));
}

/// Asks each circle: how deep does it lie, and is it a leaf?
Numbers truth(const Numbers& asked) {
    const auto size = static_cast<std::size_t>(asked[0]);
    std::vector<int> depth(size, 0);
    std::vector<char> leaf(size, 1);
    std::size_t at = 1;
    for (std::size_t i = 0; i < size; ++i)
        for (auto children = static_cast<int>(asked[at++]); children > 0; --children) {
            depth[static_cast<std::size_t>(asked[at++])] = depth[i] + 1;
            leaf[i] = 0;
        }
    const auto level = static_cast<int>(asked[at]);
    Numbers answer{static_cast<double>(size)};
    for (std::size_t i = 0; i < size; ++i)
        answer.push_back(depth[i] == level || (leaf[i] != 0 && depth[i] < level) ? 1 : 0);
    return answer;
}

}  // namespace

Task make_level_circles() {
    return {edges, random_case, truth};
}

}  // namespace exercises
