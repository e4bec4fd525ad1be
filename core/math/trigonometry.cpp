#include "lodlab/core/math/trigonometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lod {
namespace {

// pi/2 as a sum of three doubles, the first two with trailing zeros, so that k * part is exact.
constexpr double half_pi_1 = 1.57079632673412561417e+00;
constexpr double half_pi_2 = 6.07710050630396597660e-11;
constexpr double half_pi_3 = 2.02226624879595063154e-21;

// pi/2 as the nearest double and the rest.
constexpr double half_pi_high = std::numbers::pi / 2;
constexpr double half_pi_low = 6.123233995736766e-17;

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

/// The arc tangent of 0 <= t <= 1, by its series about 0 and the addition theorem about 1/4, 1/2,
/// 3/4 and 1: the series then runs over at most 1/8, and its first term left out is below 1e-20.
double short_arc_tangent(double t) {
    // Arc tangents of 0, 1/4, 1/2, 3/4, 1, each as a double and the rest.
    constexpr double high[] = {0, 0.24497866312686414, 0.4636476090008061, 0.6435011087932844,
                               0.7853981633974483};
    constexpr double low[] = {0, 1.0698755618734451e-17, 2.2698777452961687e-17,
                              1.5834785051444286e-17, 3.061616997868383e-17};
    const int nearest = static_cast<int>(4 * t + 0.5);
    const double about = 0.25 * nearest;
    const double x = (t - about) / (1 + t * about);
    const double x2 = x * x;
    double sum = 0;
    for (int k = 21; k >= 3; k -= 2) sum = x2 * (1.0 / k - sum);
    return high[nearest] + (low[nearest] + (x - x * sum));
}

}  // namespace

double direction_angle(double y, double x) {
    const double along = std::abs(x);
    const double across = std::abs(y);
    if (!std::isfinite(along) || !std::isfinite(across))
        return std::numeric_limits<double>::quiet_NaN();
    double angle = 0;
    if (across > along)
        angle = half_pi_high + (half_pi_low - short_arc_tangent(along / across));
    else if (across > 0)
        angle = short_arc_tangent(across / along);
    if (std::signbit(x)) angle = 2 * half_pi_high + (2 * half_pi_low - angle);
    return std::copysign(angle, y);
}

double angle_of_cosine(double cosine) {
    return direction_angle(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
}

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
