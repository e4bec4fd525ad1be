#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

/// The last two numbers are for the truth alone: the lengths of what is wrong and of the exact
/// change.
Numbers told_in(double x, double y, const WholeWay& change, const WholeWay& wrong) {
    const double exact_x = x + change.x;
    const double exact_y = y + change.y;
    return {x,       y,       exact_x + wrong.x, exact_y + wrong.y,
            exact_x, exact_y, wrong.length,      change.length};
}

std::vector<Numbers> edges() {
    const WholeWay none{0, 0, 0};
    return {told_in(1, 0, {-2, 0, 2}, none),
            told_in(1, 0, {-2, 0, 2}, {2, 0, 2}),
            told_in(0, 0, {3, 4, 5}, {0, 1, 1}),
            told_in(0, 0, {3, 4, 5}, {1, -7, 7.0710678118654752}),
            told_in(-1, 2, {0, -4, 4}, {0, 8, 8}),
            told_in(2, 2, {-2, -2, 2.8284271247461901}, {1, 0, 1}),
            told_in(0.5, 0, {-3, 4, 5}, {3, -4, 5}),
            told_in(0, 1, {0, -1, 1}, {0.75, 1, 1.25})};
}

Numbers random_case(lod::Random& random) {
    const double x = quarters(random, -4, 4);
    const double y = quarters(random, -4, 4);
    const WholeWay change = whole_way(random);
    return told_in(x, y, change, whole_way(random));
}

/// The cases are made of ways whose lengths are known.
Numbers truth(const Numbers& asked) {
    return {asked[6] / asked[7]};
}

}  // namespace

Task make_level_error() {
    return {edges, random_case, truth};
}

}  // namespace exercises
