#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{0, 0, 2, 3, 4, 3},  {0, 0, 2, 5.25, 0, 3}, {1, -2, 1, 1, -2, 3},
            {0, 0, 0, 0, 0, 0},  {0, 0, 0, 0.25, 0, 0}, {0, 0, 1, 2, 2, 1},
            {0, 0, 1, 2, -2, 1}, {0, 0, 5, 1, 0, 1},    {0, 0, 1, 5, 0, 5},
            {0, 0, 5, 5, 0, 1},  {-3, -4, 5, 0, 0, 0},  {0, 0, 0.25, 0.5, 0, 0.5}};
}

Numbers random_case(lod::Random& random) {
    const double x = quarters(random, -5, 5);
    const double y = quarters(random, -5, 5);
    if (random.next() < 0.6)
        return {x,
                y,
                quarters(random, 0, 3),
                quarters(random, -5, 5),
                quarters(random, -5, 5),
                quarters(random, 0, 3)};
    const WholeWay way = whole_way(random);  // they touch
    const double radius = 0.25 * whole(random, 0, static_cast<int>(4 * way.length));
    return {x, y, radius, x + way.x, y + way.y, way.length - radius};
}

/// In whole numbers.
Numbers truth(const Numbers& asked) {
    const std::int64_t x = in_quarters(asked[3]) - in_quarters(asked[0]);
    const std::int64_t y = in_quarters(asked[4]) - in_quarters(asked[1]);
    const std::int64_t reach = in_quarters(asked[2]) + in_quarters(asked[5]);
    return {x * x + y * y <= reach * reach ? 1.0 : 0.0};
}

}  // namespace

Task make_meet() {
    return {edges, random_case, truth};
}

}  // namespace exercises
