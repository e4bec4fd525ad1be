#include "lodlab/core/math/trigonometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lodlab/core/base/bits.hpp"

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
// Of several numbers side by side: each series is a chain of divisions.
template <std::size_t Count>
LOD_INLINE void short_sines(const std::array<double, Count>& x, std::array<double, Count>& sines) {
    std::array<double, Count> sum{};
    for (int k = 19; k >= 3; k -= 2)
        for (std::size_t i = 0; i < Count; ++i)
            sum[i] = x[i] * x[i] * (1.0 - sum[i]) / (k * (k - 1));
    for (std::size_t i = 0; i < Count; ++i) sines[i] = x[i] - x[i] * sum[i];
}

template <std::size_t Count>
LOD_INLINE void short_cosines(const std::array<double, Count>& x,
                              std::array<double, Count>& cosines) {
    std::array<double, Count> sum{};
    for (int k = 20; k >= 4; k -= 2)
        for (std::size_t i = 0; i < Count; ++i)
            sum[i] = x[i] * x[i] * (1.0 - sum[i]) / (k * (k - 1));
    for (std::size_t i = 0; i < Count; ++i) cosines[i] = 1.0 - 0.5 * (x[i] * x[i]) * (1.0 - sum[i]);
}

/// Beyond this the three-part reduction is not exact any more.
constexpr double largest_exact = 1e6;

/// An angle less whole quarters of a turn.
struct Reduced {
    double quarters = 0;
    double x = 0;         ///< within -pi/4 to pi/4
    double left_out = 0;  ///< of x

    Reduced() = default;
    LOD_INLINE explicit Reduced(double angle) {
        if (!(std::abs(angle) <= largest_exact)) angle = wrapped_angle(angle);
        quarters = std::floor(angle * (2 / std::numbers::pi) + 0.5);
        // As a double and what it leaves out, both differences in full.
        const double first = angle - quarters * half_pi_1;  // exact
        const double second = quarters * half_pi_2;         // exact
        x = first - second;
        const double shift = first - x;
        left_out = ((first - (x + shift)) + (shift - second)) - quarters * half_pi_3;
    }

    /// The angle's, from those of x.
    [[nodiscard]] LOD_INLINE SineCosine turned(double s_x, double c_x) const {
        const double s = s_x + c_x * left_out;
        const double c = c_x - s_x * left_out;
        const double turn = quarters - 4 * std::floor(quarters / 4);
        // By choices of numbers, for no processor could guess a branch.
        const bool even = (turn == 0) | (turn == 2);
        const double sine = even ? s : c;
        const double cosine = even ? c : s;
        return {turn < 2 ? sine : -sine, ((turn == 1) | (turn == 2)) ? -cosine : cosine};
    }
};

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
    const Reduced reduced(angle);
    std::array<double, 1> sine{};
    std::array<double, 1> cosine{};
    short_sines<1>({reduced.x}, sine);
    short_cosines<1>({reduced.x}, cosine);
    return reduced.turned(sine[0], cosine[0]);
}

namespace {

LOD_INLINE void sines_of_many(std::span<const double> angles, std::span<SineCosine> results) {
    constexpr std::size_t some = 16;
    std::array<Reduced, some> reduced;
    std::array<double, some> x{};
    std::array<double, some> sine{};
    std::array<double, some> cosine{};
    for (std::size_t begin = 0; begin < angles.size(); begin += some) {
        const std::size_t count = std::min(some, angles.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            reduced[i] = Reduced(angles[begin + i]);
            x[i] = reduced[i].x;
        }
        short_sines(x, sine);
        short_cosines(x, cosine);
        for (std::size_t i = 0; i < count; ++i)
            results[begin + i] = reduced[i].turned(sine[i], cosine[i]);
    }
}

#if defined(__x86_64__) && defined(__GNUC__)
/// The same operations, four numbers at a time: the same bits.
[[gnu::target("avx2")]] void sines_by_avx2(std::span<const double> angles,
                                           std::span<SineCosine> results) {
    sines_of_many(angles, results);
}
#endif

}  // namespace

void sine_cosine(std::span<const double> angles, std::span<SineCosine> results) {
#if defined(__x86_64__) && defined(__GNUC__)
    static const bool has_avx2 = __builtin_cpu_supports("avx2");
    if (has_avx2) return sines_by_avx2(angles, results);
#endif
    sines_of_many(angles, results);
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
