#include <algorithm>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{1, 0, 1, 0, 0},
            {1, 0, 1, 0, 0.25},
            {1, 2, 1, 1, 3},
            {1, 2, 1, 1, 3.25},
            {3, 4, 2, 1, 3, 4, 5, 1, 3.5},
            {3, 4, 1, 3, 3, 4, 1, 3, 4},
            {1, 1, 4, 4, 2, 1, 0.5, 1.75},
            {4, 4, 2, 1, 0.5, 1, 1, 1.5},
            {2, 2, 1, 2, 2, 1, 0}};
}

/// How far each level stands out: less and less on the whole, yet not at every one.
Numbers random_tree(lod::Random& random) {
    const int levels = whole(random, 1, 5);
    Numbers numbers{static_cast<double>(levels)};
    for (int level = 0; level < levels; ++level)
        numbers.push_back(0.25 * whole(random, 1, 16 - 3 * level));
    return numbers;
}

Numbers random_case(lod::Random& random) {
    const Numbers a = random_tree(random);
    const Numbers b = random_tree(random);
    return joined({a, b, {quarters(random, 0, random.next() < 0.5 ? 3 : 8)}});
}

/// In whole numbers, from the deepest level up.
Numbers truth(const Numbers& asked) {
    const auto levels_a = static_cast<std::size_t>(asked[0]);
    const auto levels_b = static_cast<std::size_t>(asked[1 + levels_a]);
    const std::int64_t gap = in_quarters(asked.back());
    double latest = -1;
    for (std::size_t level = std::max(levels_a, levels_b); level-- > 0;) {
        const std::int64_t a = in_quarters(asked[1 + std::min(level, levels_a - 1)]);
        const std::int64_t b = in_quarters(asked[2 + levels_a + std::min(level, levels_b - 1)]);
        if (gap - a > b) latest = static_cast<double>(level);
    }
    return {latest};
}

}  // namespace

Task make_latest_proof() {
    return {edges, random_case, truth};
}

}  // namespace exercises
