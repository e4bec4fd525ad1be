#include <algorithm>
#include <cmath>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{0, 0, 0, 5, 6, 0, 0, 5},    {0, 0, 0, 2, 3, 4, 0, 3},    {0, 0, 0, 5, 0, 3, 0, 2},
            {0, 0, 0, 1, 0, 0, 3, 1},    {0, 0, 0, 4, 1, 0, 0, 1},    {1, 2, 3, 1, 1, 2, 3, 2},
            {0, 0, 0, 20, 0, 21, 0, 13}, {0, 0, 0, 13, 0, 14, 0, 15}, {0, 0, 0, 0, 1, 0, 0, 0}};
}

Numbers random_case(lod::Random& random) {
    const double radius_a = random.next(0.5, 3);
    const double radius_b = random.next(0.5, 3);
    const double reach = 0.7 * (radius_a + radius_b);
    Numbers numbers{random.next(-4, 4), random.next(-4, 4), random.next(-4, 4), radius_a};
    for (std::size_t axis = 0; axis < 3; ++axis)
        numbers.push_back(numbers[axis] + random.next(-reach, reach));
    numbers.push_back(radius_b);
    return numbers;
}

/// By Heron's area of the triangle whose sides are the radii and the distance, as Kahan has it.
Numbers truth(const Numbers& asked) {
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        squared += (asked[4 + axis] - asked[axis]) * (asked[4 + axis] - asked[axis]);
    const double d = std::sqrt(squared);
    double side[3] = {asked[3], asked[7], d};
    std::sort(side, side + 3, [](double x, double y) { return x > y; });
    const double inner = side[2] - (side[0] - side[1]);
    if (d == 0 || inner <= 0) return {0};
    const double area =
        0.25 * std::sqrt((side[0] + (side[1] + side[2])) * inner * (side[2] + (side[0] - side[1])) *
                         (side[0] + (side[1] - side[2])));
    return {2 * area / d};
}

}  // namespace

Task make_meeting_radius() {
    return {edges, random_case, truth};
}

}  // namespace exercises
