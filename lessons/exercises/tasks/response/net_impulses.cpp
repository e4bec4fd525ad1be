#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

/// A body above a floor: its mass, inertia, velocity upwards and spin, and the contacts' places
/// beside its centre of mass.
struct Landing {
    double mass, inertia, v, spin, e;
    std::vector<double> x;
};

/// The last numbers are the landing itself, for the truth alone.
Numbers told_in(const Landing& landing) {
    const auto count = static_cast<double>(landing.x.size());
    Numbers numbers{count};
    for (const double x : landing.x) numbers.push_back(landing.v + landing.spin * x);
    numbers.push_back(count);
    for (const double x : landing.x) {
        numbers.push_back(count);
        for (const double other : landing.x)
            numbers.push_back(1 / landing.mass + x * other / landing.inertia);
    }
    return joined(
        {numbers, {landing.e, landing.mass, landing.inertia, landing.v, landing.spin}, landing.x});
}

std::vector<Numbers> edges() {
    return {told_in({1, 5.0 / 12, -1, 0, 1, {0}}),
            told_in({1, 5.0 / 12, -1, 0, 1, {-1, 1}}),
            told_in({1, 5.0 / 12, -1, 0, 1, {-1, -1.0 / 3, 1.0 / 3, 1}}),
            told_in({1, 5.0 / 12, -1, 0, 0, {-1, 0, 1}}),
            told_in({1, 5.0 / 12, 1, 0, 1, {-1, 1}}),
            told_in({2, 1, -1, 2, 0.5, {-1, 0, 1}}),
            told_in({2, 1, 0, 0, 0.5, {-1, 1}})};
}

Numbers random_case(lod::Random& random) {
    Landing landing{random.next(0.5, 4), random.next(0.2, 3), random.next(-3, 0.5),
                    random.next(-2, 2),  random.next(),       {}};
    for (int left = whole(random, 1, 6); left > 0; --left) landing.x.push_back(random.next(-2, 2));
    return told_in(landing);
}

/// The body's energy after the impulses t d.
double energy(const Numbers& landing, const Numbers& x, const Numbers& d, double t) {
    double v = landing[2];
    double spin = landing[3];
    for (std::size_t i = 0; i < x.size(); ++i) {
        v += t * d[i] / landing[0];
        spin += t * d[i] * x[i] / landing[1];
    }
    return 0.5 * (landing[0] * v * v + landing[1] * spin * spin);
}

/// By the body's energy: it is a parabola over the scale, and what keeps it at e = 1 is its second
/// root.
Numbers truth(const Numbers& asked) {
    const auto count = static_cast<std::size_t>(asked[0]);
    const std::size_t at = 1 + count + 1 + count * (count + 1);
    const Numbers landing(asked.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                          asked.begin() + static_cast<std::ptrdiff_t>(at) + 5);
    const Numbers x(asked.end() - static_cast<std::ptrdiff_t>(count), asked.end());
    Numbers d(count, 0.0);
    bool approaches = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (asked[1 + i] >= 0) continue;
        d[i] = -asked[1 + i] / (1 / landing[0] + x[i] * x[i] / landing[1]);
        approaches = true;
    }
    const double before = energy(landing, x, d, 0);
    const double one = energy(landing, x, d, 1) - before;
    const double two = energy(landing, x, d, 2) - before;
    const double scale =
        approaches ? (1 + asked[at]) / 2 * (two / 2 - 2 * one) / (two / 2 - one) : 0;
    Numbers answer{static_cast<double>(count)};
    for (const double one_asks : d) answer.push_back(scale * one_asks);
    return answer;
}

}  // namespace

Task make_net_impulses() {
    return {edges, random_case, truth};
}

}  // namespace exercises
