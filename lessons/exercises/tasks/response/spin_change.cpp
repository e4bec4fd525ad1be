#include <array>
#include <cmath>

#include "lessons/exercises/tasks/cases.hpp"

namespace exercises {
namespace {

using Triple = std::array<double, 3>;

/// Where the orientation, the moments and the push stand in the row of a case.
constexpr std::size_t moments_at = 1;
constexpr std::size_t position_at = 20;
constexpr std::size_t turn_at = 23;
constexpr std::size_t push_at = 33;

Numbers told_in(const Triple& inertia, const Triple& position, const Numbers& turn,
                const Numbers& push) {
    Numbers numbers{1};
    for (const bool inverse : {false, true})
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                numbers.push_back(row != column ? 0 : inverse ? 1 / inertia[row] : inertia[row]);
    return joined(
        {numbers, {1, position[0], position[1], position[2]}, turn, {0, 0, 0, 0, 0, 0}, push});
}

std::vector<Numbers> edges() {
    const Triple crate{0.4, 1.04, 1.36};
    const double half = std::sqrt(0.5);
    return {told_in(crate, {0, 0, 0}, {1, 0, 0, 0}, {0.5, -0.3, 0.1, 0, 1, 0}),
            told_in(crate, {0, 0, 0}, {half, 0, 0, half}, {0.5, -0.3, 0.1, 0, 1, 0}),
            told_in(crate, {1, 2, 3}, {half, half, 0, 0}, {1.5, 1.7, 3.1, 0, 1, 0}),
            told_in({1, 1, 1}, {0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0, 1, 0}),
            told_in(crate, {0, 0, 0}, {0.5, 0.5, 0.5, 0.5}, {0, 0, 1, 1, 0, 0}),
            told_in(crate, {1, 1, 1}, {0.5, 0.5, -0.5, 0.5}, {1, 1, 1, 3, 2, 1})};
}

Numbers random_case(lod::Random& random) {
    Numbers turn;
    double length = 0;
    while (length < 0.1 || length > 1) {
        length = 0;
        turn.clear();
        for (int i = 0; i < 4; ++i) {
            turn.push_back(random.next(-1, 1));
            length += turn.back() * turn.back();
        }
    }
    for (double& part : turn) part /= std::sqrt(length);
    const auto place = [&] {
        return Triple{random.next(-2, 2), random.next(-2, 2), random.next(-2, 2)};
    };
    const Triple inertia{random.next(0.2, 3), random.next(0.2, 3), random.next(0.2, 3)};
    const Triple position = place();
    Numbers push;
    for (int i = 0; i < 6; ++i) push.push_back(random.next(-2, 2));
    return told_in(inertia, position, turn, push);
}

Triple cross(const Triple& u, const Triple& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// v turned by a unit quaternion: v + 2 w (q x v) + 2 q x (q x v).
Triple turned(double w, const Triple& q, const Triple& v) {
    const Triple once = cross(q, v);
    const Triple twice = cross(q, once);
    Triple result = v;
    for (std::size_t i = 0; i < 3; ++i) result[i] += 2 * (w * once[i] + twice[i]);
    return result;
}

/// In the body's frame, without a matrix.
Numbers truth(const Numbers& asked) {
    Triple r{};
    Triple impulse{};
    Triple q{};
    Triple back{};
    for (std::size_t i = 0; i < 3; ++i) {
        r[i] = asked[push_at + i] - asked[position_at + i];
        impulse[i] = asked[push_at + 3 + i];
        q[i] = asked[turn_at + 1 + i];
        back[i] = -q[i];
    }
    Triple spin = turned(asked[turn_at], back, cross(r, impulse));
    for (std::size_t i = 0; i < 3; ++i) spin[i] /= asked[moments_at + 4 * i];
    spin = turned(asked[turn_at], q, spin);
    return {spin[0], spin[1], spin[2]};
}

}  // namespace

Task make_spin_change() {
    return {edges, random_case, truth};
}

}  // namespace exercises
