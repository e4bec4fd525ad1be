#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

/// How much farther than the reach the shadows' centres are apart, times what is positive, in whole
/// numbers: |line x light|^2 - reach^2 |light|^2.
std::int64_t beyond(const Numbers& asked) {
    std::int64_t line[3];
    std::int64_t light[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        line[axis] = in_quarters(asked[4 + axis]) - in_quarters(asked[axis]);
        light[axis] = in_quarters(asked[8 + axis]);
    }
    std::int64_t across = 0;
    std::int64_t length = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::int64_t part = line[i] * light[j] - line[j] * light[i];
        across += part * part;
        length += light[i] * light[i];
    }
    const std::int64_t reach = in_quarters(asked[3]) + in_quarters(asked[7]);
    return across - reach * reach * length;
}

std::vector<Numbers> edges() {
    return {{0, 0, 0, 2, 3, 4, 50, 3, 0, 0, 1},    {0, 0, 0, 2, 3, 4, 50, 3, 0, 0, 4},
            {0, 0, 0, 2, 3, 9, 4, 3, 0, -2, 0},    {0, 0, 0, 2, 9, 3, 4, 3, 0.5, 0, 0},
            {0, 0, 0, 1, 0, 0, 9, 1, 0, 0, 1},     {0, 0, 0, 1, 0, 0, 9, 1, 1, 0, 0},
            {0, 0, 0, 2, 3, 4, 50, 2.75, 0, 0, 1}, {1, 2, 3, 1, 1, 2, 3, 1, 1, 1, 1},
            {0, 0, 0, 1, 2, 4, 4, 1, 1, 2, 2},     {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}};
}

/// Shadows that touch are drawn along an axis, where doubles say so exactly.
Numbers touching(lod::Random& random) {
    const WholeWay way = whole_way(random);
    const auto axis = static_cast<std::size_t>(whole(random, 0, 2));
    const double radius = 0.25 * whole(random, 0, static_cast<int>(4 * way.length));
    Numbers numbers{0, 0, 0, radius, 0, 0, 0, way.length - radius, 0, 0, 0};
    numbers[4 + (axis + 1) % 3] = way.x;
    numbers[4 + (axis + 2) % 3] = way.y;
    numbers[4 + axis] = quarters(random, -5, 5);
    constexpr double lengths[] = {1, -2, 4, 0.5};
    numbers[8 + axis] = lengths[whole(random, 0, 3)];
    return numbers;
}

Numbers random_case(lod::Random& random) {
    if (random.next() < 0.25) return touching(random);
    for (;;) {
        Numbers numbers;
        for (const double radius : {quarters(random, 0, 3), quarters(random, 0, 3)}) {
            for (int axis = 0; axis < 3; ++axis) numbers.push_back(quarters(random, -4, 4));
            numbers.push_back(radius);
        }
        for (int axis = 0; axis < 3; ++axis) numbers.push_back(quarters(random, -3, 3));
        const bool lit = numbers[8] != 0 || numbers[9] != 0 || numbers[10] != 0;
        if (lit && beyond(numbers) != 0) return numbers;
    }
}

Numbers truth(const Numbers& asked) {
    return {beyond(asked) <= 0 ? 1.0 : 0.0};
}

}  // namespace

Task make_shadows_meet() {
    return {edges, random_case, truth};
}

}  // namespace exercises
