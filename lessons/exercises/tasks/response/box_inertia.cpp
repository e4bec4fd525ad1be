#include <cmath>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{12, 1, 0.6, 0.2}, {6, 1, 1, 1}, {1, 3, 0, 0},
            {1, 0, 2, 0},      {0, 1, 2, 3}, {24, 0, 3, 4}};
}

Numbers random_case(lod::Random& random) {
    return {random.next(0.1, 20), random.next(0.1, 4), random.next(0.1, 4), random.next(0.1, 4)};
}

/// By Gauss's two points along each side, which integrate squares exactly.
Numbers truth(const Numbers& asked) {
    const double share = 1 / std::sqrt(12.0);  // of a side, from the middle
    Numbers moments(3, 0.0);
    for (int corner = 0; corner < 8; ++corner) {
        double place[3];
        for (int axis = 0; axis < 3; ++axis)
            place[axis] = ((corner >> axis) % 2 == 0 ? share : -share) *
                          asked[static_cast<std::size_t>(axis) + 1];
        for (int axis = 0; axis < 3; ++axis) {
            const double u = place[(axis + 1) % 3];
            const double v = place[(axis + 2) % 3];
            moments[static_cast<std::size_t>(axis)] += asked[0] / 8 * (u * u + v * v);
        }
    }
    return moments;
}

}  // namespace

Task make_box_inertia() {
    return {edges, random_case, truth};
}

}  // namespace exercises
