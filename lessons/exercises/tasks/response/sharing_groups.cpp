#include <utility>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

using Collisions = std::vector<std::pair<int, int>>;

Numbers told_in(const Collisions& collisions, const Numbers& inverse_mass) {
    Numbers numbers{static_cast<double>(collisions.size())};
    for (const auto& [a, b] : collisions) {
        numbers.push_back(a);
        numbers.push_back(b);
    }
    numbers.push_back(static_cast<double>(inverse_mass.size()));
    return joined({numbers, inverse_mass});
}

std::vector<Numbers> edges() {
    return {told_in({{0, 1}}, {1, 1}),
            told_in({}, {1, 1}),
            told_in({{0, 1}, {0, 2}}, {1, 1, 1}),
            told_in({{0, 1}, {0, 2}}, {0, 1, 1}),
            told_in({{1, 0}, {2, 0}}, {0, 1, 1}),
            told_in({{0, 1}, {2, 3}, {1, 2}}, {1, 2, 2, 1}),
            told_in({{0, 1}, {4, 5}, {3, 4}, {2, 3}, {1, 2}}, {1, 1, 1, 1, 1, 1}),
            told_in({{0, 1}, {0, 2}, {2, 1}, {0, 3}}, {0, 1, 1, 1})};
}

Numbers random_case(lod::Random& random) {
    const int bodies = whole(random, 2, 9);
    Numbers inverse_mass;
    for (int i = 0; i < bodies; ++i)
        inverse_mass.push_back(random.next() < 0.25 ? 0 : 0.25 * whole(random, 1, 8));
    Collisions collisions;
    for (int left = whole(random, 1, 7); left > 0; --left) {
        const int a = whole(random, 0, bodies - 1);
        const int b = (a + whole(random, 1, bodies - 1)) % bodies;
        collisions.emplace_back(a, b);
    }
    return told_in(collisions, inverse_mass);
}

/// From each collision without a group to all that its moving bodies are in.
Numbers truth(const Numbers& asked) {
    const auto count = static_cast<std::size_t>(asked[0]);
    const Numbers inverse_mass(asked.begin() + static_cast<std::ptrdiff_t>(2 * count + 2),
                               asked.end());
    Numbers answer(count + 1, -1);
    answer[0] = asked[0];
    for (std::size_t first = 0; first < count; ++first) {
        if (answer[first + 1] >= 0) continue;
        std::vector<char> reached(inverse_mass.size(), 0);
        std::vector<std::size_t> open{first};
        while (!open.empty()) {
            const std::size_t i = open.back();
            open.pop_back();
            if (answer[i + 1] >= 0) continue;
            answer[i + 1] = static_cast<double>(first);
            for (const std::size_t side : {0u, 1u}) {
                const auto body = static_cast<std::size_t>(asked[1 + 2 * i + side]);
                if (inverse_mass[body] == 0 || reached[body] != 0) continue;
                reached[body] = 1;
                for (std::size_t k = 0; k < count; ++k)
                    if (asked[1 + 2 * k] == asked[1 + 2 * i + side] ||
                        asked[2 + 2 * k] == asked[1 + 2 * i + side])
                        open.push_back(k);
            }
        }
    }
    return answer;
}

}  // namespace

Task make_sharing_groups() {
    return {edges, random_case, truth};
}

}  // namespace exercises
