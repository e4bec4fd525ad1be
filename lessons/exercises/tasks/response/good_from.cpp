#include <algorithm>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{1, 0.25, 0.5},
            {1, 0.5, 0.5},
            {1, 0.75, 0.5},
            {5, 0.5, 0.75, 0.5, 0.25, 0.25, 0.5},
            {4, 1, 0.75, 0.5, 0.25, 0.5},
            {4, 1, 0.25, 0.5, 0.75, 0.5},
            {3, 0.25, 0.5, 0.25, 0.5},
            {2, 0, 0, 0},
            {4, 0.25, 0.75, 1, 0.25, 0.5}};
}

Numbers random_case(lod::Random& random) {
    const int levels = whole(random, 1, 6);
    Numbers numbers{static_cast<double>(levels)};
    for (int level = 0; level < levels; ++level)
        numbers.push_back(0.25 * whole(random, 0, level < levels / 2 ? 7 : 4));
    numbers.push_back(0.25 * whole(random, 1, 4));
    return numbers;
}

/// Asks of each level whether all from there on are good.
Numbers truth(const Numbers& asked) {
    const auto bad = [&](double error) { return error > asked.back(); };
    for (auto level = asked.begin() + 1; level + 1 != asked.end(); ++level)
        if (std::none_of(level, asked.end() - 1, bad))
            return {static_cast<double>(level - asked.begin() - 1)};
    return {-1};
}

}  // namespace

Task make_good_from() {
    return {edges, random_case, truth};
}

}  // namespace exercises
