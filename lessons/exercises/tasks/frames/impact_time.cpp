#include "lessons/exercises/tasks/cases.hpp"
#include "lodlab/core/math/sphere.hpp"

namespace exercises {
namespace {

/// How b moves, seen from a, in quarters.
struct Approach {
    std::int64_t x, y, v_x, v_y, reach;

    std::int64_t beyond() const { return x * x + y * y - reach * reach; }
    std::int64_t parting() const { return x * v_x + y * v_y; }
    std::int64_t speed() const { return v_x * v_x + v_y * v_y; }
    /// Negative where b passes by.
    std::int64_t root() const { return parting() * parting() - speed() * beyond(); }
    bool touches() const { return beyond() <= 0 || (parting() < 0 && root() >= 0); }
};

Approach approach_in(const Numbers& asked) {
    const auto apart = [&](std::size_t i) {
        return in_quarters(asked[5 + i]) - in_quarters(asked[i]);
    };
    return {apart(0), apart(1), apart(3), apart(4), in_quarters(asked[2]) + in_quarters(asked[7])};
}

std::vector<Numbers> edges() {
    return {{0, 0, 1, 1, 0, 5, 0, 1, 0, 0},  {0, 0, 1, 1, 0, 5, 0, 1, -2, 0},
            {0, 0, 1, 0, 0, 5, 0, 1, 1, 0},  {0, 0, 1, 1, 0, 5, 0, 1, 1, 0},
            {0, 0, 1, 0, 0, 2, 0, 1, 1, 0},  {0, 0, 1, 0, 0, 1, 0, 1, -1, 0},
            {0, 0, 1, 0, 0, 1, 0, 1, 3, 0},  {0, 0, 1, 0, 0, 5, 3, 1, -1, 0},
            {0, 0, 2, 0, 0, 9, 3, 3, -3, 0}, {-4, 0, 0.5, 2, 0, 4, 0, 2.5, -1, 0},
            {0, 0, 1, 0, 1, 0, 6, 1, 0, -1}};
}

/// Circles that graze each other are told apart by rounding alone: none of these.
Numbers random_case(lod::Random& random) {
    const bool aimed = random.next() < 0.7;
    for (;;) {
        Numbers numbers;
        for (int disc = 0; disc < 2; ++disc) {
            for (int axis = 0; axis < 2; ++axis) numbers.push_back(quarters(random, -6, 6));
            numbers.push_back(0.25 * whole(random, 0, 10));
            for (int axis = 0; axis < 2; ++axis) numbers.push_back(quarters(random, -3, 3));
        }
        const Approach approach = approach_in(numbers);
        if (approach.beyond() > 0 && approach.root() == 0) continue;
        if (!aimed || (approach.touches() && approach.beyond() > 0)) return numbers;
    }
}

/// By a search, between the start and the time at which the centres are nearest.
Numbers truth(const Numbers& asked) {
    const Approach approach = approach_in(asked);
    if (!approach.touches()) return {-1};
    if (approach.beyond() <= 0) return {0};
    const auto quarter = [](std::int64_t count) { return static_cast<double>(count) / 4; };
    const lod::Vector<2> p(quarter(approach.x), quarter(approach.y));
    const lod::Vector<2> v(quarter(approach.v_x), quarter(approach.v_y));
    double before = 0;
    double after = -p.dot(v) / v.dot(v);
    constexpr int halvings = 100;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (before + after) / 2;
        ((p + middle * v).norm() > quarter(approach.reach) ? before : after) = middle;
    }
    return {after};
}

}  // namespace

Task make_impact_time() {
    return {edges, random_case, truth};
}

}  // namespace exercises
