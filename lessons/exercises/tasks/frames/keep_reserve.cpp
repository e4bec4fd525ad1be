#include <algorithm>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{100, 50, 10, 1, 40, 3, 3},  {100, 50, 10, 1, 41, 3, 3}, {100, 50, 10, 1, 40, 3, 4},
            {100, 50, 10, 1, 40, 3, 0},  {100, 0, 1, 1, 16, 1, 5},   {100, 50, 10, 2, 20, 4, 9},
            {100, 50, 10, 2, 30, 4, 4},  {60, 50, 20, 3, 4, 1, 0},   {100, 20, 10, 5, 16, 8, 12},
            {100, 20, 10, 5, 16, 8, 10}, {50, 50, 0, 1, 0, 0, 0}};
}

Numbers random_case(lod::Random& random) {
    const int spent = whole(random, 0, 60);
    const int before = whole(random, 1, 6);
    const int pairs = before + whole(random, 0, 12);
    const int answer = whole(random, 1, 4);
    const int tests = whole(random, 2, 30);
    const int after = whole(random, 0, 12);
    const int first = spent + tests + answer * pairs;
    const int second = first + answer * (after - before);
    const int about = random.next() < 0.5 ? first : second;
    const int quota = std::max(0, about + whole(random, -2, 6));
    Numbers numbers;
    for (const int number : {quota, spent, pairs, answer, tests, before, after})
        numbers.push_back(number);
    return numbers;
}

/// By what is left: for tests at first, then for more answers.
Numbers truth(const Numbers& asked) {
    const double left = asked[0] - asked[1] - asked[2] * asked[3] - asked[4];
    if (left < 0) return {0};
    return {(asked[6] - asked[5]) * asked[3] > left ? 1.0 : 2.0};
}

}  // namespace

Task make_keep_reserve() {
    return {edges, random_case, truth};
}

}  // namespace exercises
