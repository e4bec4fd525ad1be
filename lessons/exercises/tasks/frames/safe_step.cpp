#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

/// The last number is for the truth alone: how fast the centres come together.
Numbers told_in(double distance, const Numbers& a, const Numbers& turns, const WholeWay& way) {
    return {distance,     a[0],         a[1],     turns[0], turns[1],
            a[0] + way.x, a[1] + way.y, turns[2], turns[3], way.length};
}

std::vector<Numbers> edges() {
    return {told_in(1, {0, 0}, {0, 0, 0, 0}, {0, 0, 0}),
            told_in(1, {2, 1}, {0, 1, 0, 1}, {0, 0, 0}),
            told_in(1, {1, 0}, {0, 1, 0, 1}, {-2, 0, 2}),
            told_in(2, {0, 0}, {3, 0.5, 0, 1}, {0, 0, 0}),
            told_in(2, {0, 0}, {-3, 0.5, 2, 1}, {3, 4, 5}),
            told_in(0.5, {1, 1}, {-2, 1, -2, 1}, {0, -4, 4}),
            told_in(3, {-1, 0}, {1, 2, -2, 1}, {0, 0, 0})};
}

Numbers random_case(lod::Random& random) {
    const Numbers velocity{quarters(random, -3, 3), quarters(random, -3, 3)};
    Numbers turns;
    for (int body = 0; body < 2; ++body) {
        turns.push_back(quarters(random, -3, 3));
        turns.push_back(0.25 * whole(random, 1, 8));
    }
    const bool moves = random.next() < 0.9;
    return told_in(0.25 * whole(random, 1, 16), velocity, turns,
                   moves ? whole_way(random) : WholeWay{0, 0, 0});
}

/// How many steps of the bound go into the distance, in sixteenths; the velocity between the
/// centres is made of a way whose length is known.
Numbers truth(const Numbers& asked) {
    std::int64_t bound = 4 * in_quarters(asked[9]);
    for (const std::size_t spin : {std::size_t{3}, std::size_t{7}}) {
        const std::int64_t turning = in_quarters(asked[spin]) * in_quarters(asked[spin + 1]);
        bound += turning < 0 ? -turning : turning;
    }
    return {static_cast<double>(4 * in_quarters(asked[0])) / static_cast<double>(bound)};
}

}  // namespace

Task make_safe_step() {
    return {edges, random_case, truth};
}

}  // namespace exercises
