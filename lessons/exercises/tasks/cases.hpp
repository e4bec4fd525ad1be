#pragma once

#include <cstdint>
#include <initializer_list>

#include "lessons/exercises/exercise.hpp"

namespace exercises {

/// A whole number in [low, high].
inline int whole(lod::Random& random, int low, int high) {
    return low + static_cast<int>(random.next() * (high - low + 1));
}

/// A number of quarters in [low, high]: sums and products of such numbers are exact.
inline double quarters(lod::Random& random, int low, int high) {
    return 0.25 * whole(random, 4 * low, 4 * high);
}

/// The same number as a count of quarters.
inline std::int64_t in_quarters(double number) {
    return static_cast<std::int64_t>(4 * number);
}

/// Rows of numbers one after another.
inline Numbers joined(std::initializer_list<Numbers> rows) {
    Numbers all;
    for (const Numbers& row : rows) all.insert(all.end(), row.begin(), row.end());
    return all;
}

/// A tree as its cases have it: how many circles; of each, which has x, y and r in quarters, these
/// in metres, how many children, and which: those whose `parent` it is.
template <class Circles>
Numbers tree_in_numbers(const Circles& tree) {
    const auto size = static_cast<int>(tree.size());
    Numbers numbers{static_cast<double>(size)};
    for (int i = 0; i < size; ++i) {
        const auto& circle = tree[static_cast<std::size_t>(i)];
        for (const std::int64_t one : {circle.x, circle.y, circle.r})
            numbers.push_back(static_cast<double>(one) / 4);
        Numbers children;
        for (int k = 0; k < size; ++k)
            if (tree[static_cast<std::size_t>(k)].parent == i) children.push_back(k);
        numbers.push_back(static_cast<double>(children.size()));
        numbers.insert(numbers.end(), children.begin(), children.end());
    }
    return numbers;
}

/// A way of whole numbers and whole length, scaled, turned and mirrored: 3, 4 and 5; 5, 12 and 13;
/// ...
struct WholeWay {
    double x;
    double y;
    double length;
};

inline WholeWay whole_way(lod::Random& random) {
    constexpr WholeWay ways[] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {1, 0, 1}, {7, 24, 25}};
    WholeWay way = ways[whole(random, 0, 4)];
    const double scale = 0.25 * whole(random, 1, 4);
    way = {way.x * scale, way.y * scale, way.length * scale};
    if (random.next() < 0.5) way = {way.y, way.x, way.length};
    if (random.next() < 0.5) way.x = -way.x;
    if (random.next() < 0.5) way.y = -way.y;
    return way;
}

}  // namespace exercises
