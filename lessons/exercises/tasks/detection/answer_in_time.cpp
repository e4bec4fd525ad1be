#include <algorithm>
#include <numeric>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{1, 1, 1, 0},
            {1, 1, 0, 0},
            {2, 1, 1, 4, 2, 0},
            {2, 1, 1, 4, 2, 4},
            {2, 1, 1, 4, 2, 5},
            {3, 1, 1, 16, 3, 9, 0, 25},
            {3, 1, 1, 16, 3, 9, 0, 26},
            {3, 1, 1, 16, 3, 9, 0, 1000},
            {4, 1, 1, 16, 3, 30, 5, 20, 2, 60}};
}

Numbers random_case(lod::Random& random) {
    const int levels = whole(random, 1, 6);
    Numbers numbers{static_cast<double>(levels)};
    int all = 0;
    std::vector<int> ends;
    for (int level = 0; level < levels; ++level) {
        const int tests = level == 0 ? 1 : whole(random, 2, 40);
        all += tests;
        ends.push_back(all);
        const bool proof = level + 1 == levels && random.next() < 0.5;
        numbers.push_back(tests);
        numbers.push_back(proof ? 0 : whole(random, 1, 9));
    }
    const bool exactly = random.next() < 0.3;
    numbers.push_back(exactly ? ends[static_cast<std::size_t>(whole(random, 0, levels - 1))]
                              : whole(random, 0, all + 5));
    return numbers;
}

/// By the sums of the levels.
Numbers truth(const Numbers& asked) {
    const auto count = static_cast<std::size_t>(asked[0]);
    std::vector<double> sums;
    for (std::size_t level = 0; level < count; ++level) sums.push_back(asked[1 + 2 * level]);
    std::partial_sum(sums.begin(), sums.end(), sums.begin());
    const auto finished = std::upper_bound(sums.begin(), sums.end(), asked.back()) - sums.begin();
    const auto level = static_cast<std::size_t>(std::max<std::ptrdiff_t>(finished - 1, 0));
    return {static_cast<double>(level), asked[2 + 2 * level] > 0 ? 1.0 : 0.0};
}

}  // namespace

Task make_answer_in_time() {
    return {edges, random_case, truth};
}

}  // namespace exercises
