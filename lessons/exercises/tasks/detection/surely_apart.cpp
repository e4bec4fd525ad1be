#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

/// The double next to so many times a power of ten.
double decimal(std::int64_t count, int power) {
    double scale = 1;
    for (int i = 0; i < power || i < -power; ++i) scale *= 10;
    const auto number = static_cast<double>(count);
    return power < 0 ? number / scale : number * scale;
}

/// Two circles in whole units of a power of ten; the last four numbers are for the truth alone.
struct Circles {
    std::int64_t x, y;          ///< of the first centre
    std::int64_t way_x, way_y;  ///< to the second
    std::int64_t radius, other;
};

Numbers told_in(const Circles& c, int power) {
    Numbers numbers;
    for (const std::int64_t count : {c.x, c.y, c.radius, c.x + c.way_x, c.y + c.way_y, c.other})
        numbers.push_back(decimal(count, power));
    for (const std::int64_t count : {c.way_x, c.way_y, c.radius, c.other})
        numbers.push_back(static_cast<double>(count));
    return numbers;
}

std::vector<Numbers> edges() {
    std::vector<Numbers> cases;
    for (const int power : {-1, -3, 0, 4, -9, 7})
        for (const Circles& circles :
             {Circles{0, 0, 8, 0, 1, 7}, Circles{0, 0, 9, 0, 1, 7},
              Circles{0, 0, 6000, 8000, 3001, 6999}, Circles{0, 0, 10000, 0, 4999, 5000},
              Circles{3, 4, 0, 0, 1, 1}, Circles{0, 0, 0, 11, 1, 10}})
            cases.push_back(told_in(circles, power));
    return cases;
}

Numbers random_case(lod::Random& random) {
    const WholeWay way = whole_way(random);
    std::int64_t scale = whole(random, 1, 40);
    for (int zeros = whole(random, 0, 5); zeros > 0; --zeros) scale *= 10;
    scale += whole(random, 0, 9);
    const auto units = [&](double length) { return in_quarters(length) * scale; };
    Circles circles{
        whole(random, -100, 100), whole(random, -100, 100), units(way.x), units(way.y), 0, 0};
    const std::int64_t length = units(way.length);
    circles.radius = whole(random, 0, static_cast<int>(length));
    circles.other = length - circles.radius;  // they touch
    const double kind = random.next();
    const std::int64_t gap = length / 9000 + 1;
    if (kind < 0.2 && circles.radius > gap) circles.radius -= gap;  // they just miss each other
    if (kind > 0.85) circles.radius /= 2;
    if (kind > 0.7 && kind < 0.85) circles.radius += whole(random, 1, 1000);
    return told_in(circles, whole(random, -9, 0));
}

/// In whole numbers.
Numbers truth(const Numbers& asked) {
    const auto count = [&](std::size_t i) { return static_cast<std::int64_t>(asked[i]); };
    const std::int64_t reach = count(8) + count(9);
    return {count(6) * count(6) + count(7) * count(7) > reach * reach ? 1.0 : 0.0};
}

}  // namespace

Task make_surely_apart() {
    return {edges, random_case, truth};
}

}  // namespace exercises
