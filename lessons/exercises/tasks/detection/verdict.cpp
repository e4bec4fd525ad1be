#include <algorithm>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{0},
            {1, 0, 0},
            {1, 1, 0},
            {1, 0, 1},
            {1, 1, 1},
            {2, 1, 1, 0, 0},
            {2, 0, 0, 1, 1},
            {2, 1, 0, 0, 1},
            {3, 0, 0, 1, 1, 1, 0}};
}

Numbers random_case(lod::Random& random) {
    const int pairs = whole(random, 0, 5);
    constexpr double shares[] = {0.2, 0.5, 0.8};
    const double leaves = shares[whole(random, 0, 2)];
    Numbers numbers{static_cast<double>(pairs)};
    for (int i = 0; i < 2 * pairs; ++i) numbers.push_back(random.next() < leaves ? 1 : 0);
    return numbers;
}

/// By the pair with the most leaves, of none, one and two.
Numbers truth(const Numbers& asked) {
    double leaves = 0;
    for (std::size_t i = 1; i + 1 < asked.size(); i += 2)
        leaves = std::max(leaves, asked[i] + asked[i + 1]);
    constexpr double verdicts[] = {1, 1, 2};
    return {asked[0] == 0 ? 0.0 : verdicts[static_cast<std::size_t>(leaves)]};
}

}  // namespace

Task make_verdict() {
    return {edges, random_case, truth};
}

}  // namespace exercises
