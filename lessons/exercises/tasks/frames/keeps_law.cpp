#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

/// The row of three of the lesson is the first and the second: by Box2D's law, and as lodlab's net
/// impulse has it.
std::vector<Numbers> edges() {
    return {{2, -1, 1, 4.0 / 3, 0, 0, 2.0 / 3, 1},
            {2, -1, 0, 1, 0, 1, 1, 1},
            {0, 1},
            {1, -2, 1, 3, 0.5},
            {1, -2, 2, 3, 0.5},
            {1, -2, 2, 0, 0.5},
            {1, 1, 1, 0, 1},
            {1, 1, -1, 0, 1},
            {1, -1, 1, -1, 1},
            {1, -1, 0, 2, 0}};
}

/// Most contacts keep the law, in one of two ways; some break it, in one of three.
Numbers random_case(lod::Random& random) {
    const int contacts = whole(random, 1, 4);
    const double e = 0.25 * whole(random, 0, 4);
    Numbers numbers{static_cast<double>(contacts)};
    for (int i = 0; i < contacts; ++i) {
        const double u = quarters(random, -3, 1);
        const bool pushes = random.next() < 0.5;
        double more = pushes ? 0 : 0.25 * whole(random, 0, 4);
        double j = pushes ? 0.25 * whole(random, 1, 8) : 0;
        const double breaks = random.next();
        if (breaks < 0.07) more = -0.25 * whole(random, 1, 4);
        if (breaks >= 0.07 && breaks < 0.14) j = -0.25 * whole(random, 1, 4);
        if (breaks >= 0.14 && breaks < 0.21) j = more = 0.5;
        numbers.insert(numbers.end(), {u, more - e * u, j});
    }
    numbers.push_back(e);
    return numbers;
}

/// In sixteenths: each contact is one that pushed, or one that did not.
Numbers truth(const Numbers& asked) {
    for (std::size_t at = 1; at + 3 < asked.size(); at += 3) {
        const auto after = static_cast<std::int64_t>(16 * asked[at + 1]);
        const std::int64_t least = -in_quarters(asked.back()) * in_quarters(asked[at]);
        const std::int64_t j = in_quarters(asked[at + 2]);
        const bool pushed = j > 0 && after == least;
        const bool let_go = j == 0 && after >= least;
        if (!pushed && !let_go) return {0};
    }
    return {1};
}

}  // namespace

Task make_keeps_law() {
    return {edges, random_case, truth};
}

}  // namespace exercises
