#include "lodlab/core/trigonometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lod {
namespace {

// pi/2 as a sum of three doubles, the first two with trailing zeros, so that k * part is exact.
constexpr double half_pi_1 = 1.57079632673412561417e+00;
constexpr double half_pi_2 = 6.07710050630396597660e-11;
constexpr double half_pi_3 = 2.02226624879595063154e-21;

// Taylor series on [-pi/4, pi/4]: the first term left out is below 1e-21.
double short_sine(double x) {
    const double x2 = x * x;
    double sum = 0;
    for (int k = 19; k >= 3; k -= 2) sum = x2 * (1.0 - sum) / (k * (k - 1));
    return x - x * sum;
}

double short_cosine(double x) {
    const double x2 = x * x;
    double sum = 0;
    for (int k = 20; k >= 4; k -= 2) sum = x2 * (1.0 - sum) / (k * (k - 1));
    return 1.0 - 0.5 * x2 * (1.0 - sum);
}

/// Beyond this the three-part reduction is not exact any more.
constexpr double largest_exact = 1e6;

}  // namespace

SineCosine sine_cosine(double angle) {
    if (!(std::abs(angle) <= largest_exact)) angle = wrapped_angle(angle);
    const double quarters = std::floor(angle * (2 / std::numbers::pi) + 0.5);
    // The angle less whole quarters as a double and what it leaves out, both differences in full.
    const double first = angle - quarters * half_pi_1;  // exact
    const double second = quarters * half_pi_2;         // exact
    const double x = first - second;
    const double shift = first - x;
    const double left_out = ((first - (x + shift)) + (shift - second)) - quarters * half_pi_3;
    const double s_x = short_sine(x);
    const double c_x = short_cosine(x);
    const double s = s_x + c_x * left_out;
    const double c = c_x - s_x * left_out;
    const double turn = quarters - 4 * std::floor(quarters / 4);
    if (turn == 0) return {s, c};
    if (turn == 1) return {c, -s};
    if (turn == 2) return {-s, -c};
    return {-c, s};
}

double wrapped_angle(double angle) {
    constexpr double pi = std::numbers::pi;
    if (angle >= -pi && angle <= pi) return angle;
    if (!(std::abs(angle) <= largest_exact)) angle = std::fmod(angle, 2 * pi);  // exact by IEEE 754
    const auto less = [&](double turns) {
        return ((angle - turns * 4 * half_pi_1) - turns * 4 * half_pi_2) - turns * 4 * half_pi_3;
    };
    const double turns = std::floor(angle / (2 * pi) + 0.5);
    double wrapped = less(turns);
    if (wrapped < -pi) wrapped = less(turns - 1);  // the quotient was rounded up
    if (wrapped > pi) wrapped = less(turns + 1);
    return std::clamp(wrapped, -pi, pi);
}

}  // namespace lod
