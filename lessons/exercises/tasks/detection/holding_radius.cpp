#include <cmath>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{1, 2, 0},
            {1, 2, 1, 1, 2},
            {1, 2, 1, 4, 6},
            {0, 0, 3, 3, 4, 1, 0, 0, 1},
            {-2, 1, 4, 3, 1, 3, 2, -3, 2, -3, 1},
            {10, 10, 3, 10, 11, 11, 10, 9, 9}};
}

Numbers random_case(lod::Random& random) {
    const int corners = whole(random, 1, 8);
    Numbers numbers{quarters(random, -5, 5), quarters(random, -5, 5), static_cast<double>(corners)};
    for (int i = 0; i < 2 * corners; ++i) numbers.push_back(quarters(random, -6, 6));
    return numbers;
}

/// The largest square in whole numbers, then its root.
Numbers truth(const Numbers& asked) {
    std::int64_t largest = 0;
    for (std::size_t i = 3; i + 1 < asked.size(); i += 2) {
        const std::int64_t x = in_quarters(asked[i]) - in_quarters(asked[0]);
        const std::int64_t y = in_quarters(asked[i + 1]) - in_quarters(asked[1]);
        if (x * x + y * y > largest) largest = x * x + y * y;
    }
    return {std::sqrt(static_cast<double>(largest) / 16)};
}

}  // namespace

Task make_holding_radius() {
    return {edges, random_case, truth};
}

}  // namespace exercises
