#include <algorithm>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

/// 16 times the power of each circle, in whole numbers.
std::vector<std::int64_t> powers(const Numbers& asked) {
    std::vector<std::int64_t> powers;
    for (std::size_t i = 3; i + 2 < asked.size(); i += 3) {
        const std::int64_t x = in_quarters(asked[i]) - in_quarters(asked[0]);
        const std::int64_t y = in_quarters(asked[i + 1]) - in_quarters(asked[1]);
        const std::int64_t r = in_quarters(asked[i + 2]);
        powers.push_back(x * x + y * y - r * r);
    }
    return powers;
}

std::vector<Numbers> edges() {
    return {{0, 0, 1, 3, 4, 1},
            {2, 0, 2, 0, 0, 0.5, 5, 0, 4},
            {2, 0, 2, 5, 0, 4, 0, 0, 0.5},
            {0, 0, 3, 1, 0, 3, 1, 0, 0.25, 0, 1, 0.5},
            {1, 1, 3, 9, 9, 1, 8, 8, 1, 2, 1, 0.5}};
}

Numbers random_case(lod::Random& random) {
    for (;;) {
        const int circles = whole(random, 2, 6);
        Numbers numbers{quarters(random, -4, 4), quarters(random, -4, 4),
                        static_cast<double>(circles)};
        for (int i = 0; i < circles; ++i)
            for (const double number :
                 {quarters(random, -5, 5), quarters(random, -5, 5), 0.25 * whole(random, 1, 16)})
                numbers.push_back(number);
        std::vector<std::int64_t> sorted = powers(numbers);
        std::sort(sorted.begin(), sorted.end());
        if (sorted[0] < sorted[1]) return numbers;
    }
}

Numbers truth(const Numbers& asked) {
    const std::vector<std::int64_t> all = powers(asked);
    return {static_cast<double>(std::min_element(all.begin(), all.end()) - all.begin())};
}

}  // namespace

Task make_owner() {
    return {edges, random_case, truth};
}

}  // namespace exercises
