#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

std::vector<Numbers> edges() {
    return {{0},
            {1, 1, 2, 1, 0, 0},
            {1, 1, 2, 0, 0, 3},
            {1, 1, 2, 3, 4, -1},
            {1, 0, 0, 1, 0, 2},
            {1, 0, 2, 1, 0, 2},
            {1, 0.5, 0, 0, 2, 5},
            {2, 1, 4, 1, 0, 0, 0, 0, 0, 0, 0},
            {3, 1, 4, 0, 0, 0, 1, 4, 0, 0, 0, 1, 4, 1, 0, 0}};
}

Numbers random_case(lod::Random& random) {
    constexpr double inverses[] = {0.25, 0.5, 1, 2, 4};
    const int bodies = whole(random, 1, 4);
    Numbers numbers{static_cast<double>(bodies)};
    for (int i = 0; i < bodies; ++i) {
        for (int of = 0; of < 2; ++of)
            numbers.push_back(random.next() < 0.2 ? 0 : inverses[whole(random, 0, 4)]);
        for (int part = 0; part < 3; ++part) numbers.push_back(quarters(random, -3, 3));
    }
    return numbers;
}

/// In whole numbers: masses in quarters, squares in sixteenths.
Numbers truth(const Numbers& asked) {
    std::int64_t energy = 0;
    for (std::size_t at = 1; at + 4 < asked.size(); at += 5) {
        const auto square = [&](std::size_t part) {
            return in_quarters(asked[at + part]) * in_quarters(asked[at + part]);
        };
        const std::int64_t squares[] = {square(2) + square(3), square(4)};
        for (std::size_t of = 0; of < 2; ++of)
            if (asked[at + of] > 0) energy += 16 / in_quarters(asked[at + of]) * squares[of];
    }
    return {static_cast<double>(energy) / (4 * 16 * 2)};
}

}  // namespace

Task make_kinetic_energy() {
    return {edges, random_case, truth};
}

}  // namespace exercises
