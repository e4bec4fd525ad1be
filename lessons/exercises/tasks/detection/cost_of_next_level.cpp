#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{0},
            {1, 0, 0},
            {1, 4, 4},
            {1, 0, 4},
            {1, 3, 0},
            {1, 1, 1},
            {3, 4, 4, 4, 4, 0, 4},
            {3, 0, 0, 2, 3, 0, 0},
            {2, 0, 5, 2, 0}};
}

Numbers random_case(lod::Random& random) {
    const int pairs = whole(random, 0, 6);
    Numbers numbers{static_cast<double>(pairs)};
    for (int i = 0; i < 2 * pairs; ++i)
        numbers.push_back(random.next() < 0.35 ? 0 : whole(random, 1, 6));
    return numbers;
}

/// Where both have children, these multiply; else the one that has some has a test for each.
Numbers truth(const Numbers& asked) {
    double tests = 0;
    for (std::size_t i = 1; i + 1 < asked.size(); i += 2) {
        const double both = asked[i] * asked[i + 1];
        tests += both > 0 ? both : asked[i] + asked[i + 1];
    }
    return {tests};
}

}  // namespace

Task make_cost_of_next_level() {
    return {edges, random_case, truth};
}

}  // namespace exercises
