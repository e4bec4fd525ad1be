#include <cmath>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{0, 0, 2, 2, 0, 1}, {0, 0, 2, 3, 0, 1}, {1, 1, 2, 3, 1, 2},      {3, -2, 1, 3, -2, 4},
            {0, 0, 1, 0, 3, 3}, {5, 5, 4, 2, 1, 2}, {-1, -1, 0.25, 0, -1, 8}};
}

Numbers random_case(lod::Random& random) {
    const double radius_a = random.next(0.1, 3);
    const double radius_b = random.next(0.1, 3);
    const double reach = (radius_a + radius_b) / 2;
    const double x = random.next(-5, 5);
    const double y = random.next(-5, 5);
    return {x,       y, radius_a, x + random.next(-reach, reach), y + random.next(-reach, reach),
            radius_b};
}

/// The mean of the centres, each weighed by the other's radius.
Numbers truth(const Numbers& asked) {
    const double whole_weight = asked[2] + asked[5];
    return {(asked[5] * asked[0] + asked[2] * asked[3]) / whole_weight,
            (asked[5] * asked[1] + asked[2] * asked[4]) / whole_weight};
}

}  // namespace

Task make_contact_point() {
    return {edges, random_case, truth};
}

}  // namespace exercises
