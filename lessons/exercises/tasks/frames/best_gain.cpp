#include <algorithm>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{0, 100},
            {1, 16, 2, 16},
            {1, 16, 2, 15},
            {2, 16, 2, 4, 1, 100},
            {2, 16, 2, 4, 1, 10},
            {2, 4, 1, 8, 2, 8},
            {2, 8, 2, 4, 1, 4},
            {3, 20, 5, 6, 1, 3, 0.25, 19},
            {3, 2, 0.25, 3, 3, 9, 4, 9}};
}

Numbers random_case(lod::Random& random) {
    const int offers = whole(random, 0, 6);
    Numbers numbers{static_cast<double>(offers)};
    int most = 1;
    int a_tests = 0;
    for (int i = 0; i < offers; ++i) {
        a_tests = whole(random, 1, 16);
        most = std::max(most, a_tests);
        numbers.push_back(a_tests);
        numbers.push_back(random.next() < 0.3 ? 0.25 * a_tests : 0.25 * whole(random, 1, 12));
    }
    const bool exactly = a_tests > 0 && random.next() < 0.3;
    numbers.push_back(exactly ? a_tests : whole(random, 0, most + 4));
    return numbers;
}

/// In whole numbers: an offer is the answer if it fits and no other that fits is better, or as good
/// and before it.
Numbers truth(const Numbers& asked) {
    const auto count = static_cast<std::size_t>(asked[0]);
    const auto tests = [&](std::size_t i) { return static_cast<std::int64_t>(asked[1 + 2 * i]); };
    const auto fall = [&](std::size_t i) { return in_quarters(asked[2 + 2 * i]); };
    const auto fits = [&](std::size_t i) { return asked[1 + 2 * i] <= asked.back(); };
    for (std::size_t i = 0; i < count; ++i) {
        bool beaten = !fits(i);
        for (std::size_t other = 0; other < count; ++other) {
            const std::int64_t more = fall(other) * tests(i) - fall(i) * tests(other);
            if (fits(other) && (more > 0 || (more == 0 && other < i))) beaten = true;
        }
        if (!beaten) return {static_cast<double>(i)};
    }
    return {-1};
}

}  // namespace

Task make_best_gain() {
    return {edges, random_case, truth};
}

}  // namespace exercises
