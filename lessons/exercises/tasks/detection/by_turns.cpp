#include <set>
#include <utility>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{1, 1, 1, 0},
            {1, 2, 1, 9, 10},
            {1, 2, 1, 9, 9},
            {2, 2, 1, 4, 2, 1, 4, 1},
            {2, 3, 1, 4, 9, 3, 1, 4, 2, 12},
            {2, 3, 1, 4, 9, 3, 1, 4, 2, 19},
            {2, 3, 1, 9, 2, 2, 1, 4, 8},
            {3, 1, 1, 3, 1, 4, 4, 2, 1, 6, 17},
            {2, 3, 1, 3, 5, 1, 1, 10}};
}

Numbers random_case(lod::Random& random) {
    const int pairs = whole(random, 1, 4);
    Numbers numbers{static_cast<double>(pairs)};
    int all = 0;
    for (int pair = 0; pair < pairs; ++pair) {
        const int levels = whole(random, 1, 5);
        numbers.push_back(levels);
        for (int level = 0; level < levels; ++level) {
            const int tests = level == 0 ? 1 : whole(random, 1, 9);
            numbers.push_back(tests);
            all += tests;
        }
    }
    numbers.push_back(whole(random, random.next() < 0.1 ? 0 : pairs, all + 1));
    return numbers;
}

/// By a queue of turns, the lowest level first: a pair that has taken its turn queues up again, one
/// whose turn does not fit does not.
Numbers truth(const Numbers& asked) {
    std::vector<Numbers> waiting;
    for (std::size_t at = 1; waiting.size() < static_cast<std::size_t>(asked[0]);) {
        const auto levels = static_cast<std::ptrdiff_t>(asked[at++]);
        const auto begin = asked.begin() + static_cast<std::ptrdiff_t>(at);
        waiting.emplace_back(begin, begin + levels);
        at += static_cast<std::size_t>(levels);
    }
    Numbers reached(waiting.size(), 0.0);
    double left = asked.back();
    std::set<std::pair<std::size_t, std::size_t>> queue;
    for (std::size_t pair = 0; pair < waiting.size(); ++pair) {
        left -= waiting[pair][0];
        queue.insert({1, pair});
    }
    while (!queue.empty()) {
        const auto [level, pair] = *queue.begin();
        queue.erase(queue.begin());
        if (level == waiting[pair].size() || waiting[pair][level] > left) continue;
        left -= waiting[pair][level];
        reached[pair] = static_cast<double>(level);
        queue.insert({level + 1, pair});
    }
    return joined({{static_cast<double>(reached.size())}, reached});
}

}  // namespace

Task make_by_turns() {
    return {edges, random_case, truth};
}

}  // namespace exercises
