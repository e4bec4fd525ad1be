#pragma once

#include <numbers>
#include <span>

namespace lod {

constexpr double full_turn = 2 * std::numbers::pi;  ///< [rad]

struct SineCosine {
    double sine;
    double cosine;
};

/// Sine and cosine of an angle [rad], within 2 units in the last place for |angle| < 1e6, built
/// from additions and multiplications only, so that every compiler and library gives the same bits.
/// Beyond 1e6 the angle is first reduced by whole turns of the double 2 pi: bounded and repeatable,
/// but off by about |angle| * 4e-17. NaN for NaN and infinity.
[[nodiscard]] SineCosine sine_cosine(double angle);

/// The same of many angles, to the same bits, in a fifth of the time. Requires: as many results.
void sine_cosine(std::span<const double> angles, std::span<SineCosine> results);

/// The angle [rad] from the x axis to the point (x, y), in [-pi, pi], within 3 units in the last
/// place; built as sine_cosine is, for the same bits everywhere. Signs and zeros as std::atan2.
/// NaN where a number is not finite.
[[nodiscard]] double direction_angle(double y, double x);

/// The angle [rad] whose cosine is `cosine`, in [0, pi]. Requires -1 <= cosine <= 1.
[[nodiscard]] double angle_of_cosine(double cosine);

/// The angle [rad] brought into [-pi, pi] by whole turns: within 1e-15 and the rounding of the
/// angle itself for |angle| < 1e6. NaN for NaN and infinity.
[[nodiscard]] double wrapped_angle(double angle);

}  // namespace lod
