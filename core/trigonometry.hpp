#pragma once

namespace lod {

struct SineCosine {
    double sine;
    double cosine;
};

/// Sine and cosine of an angle [rad], within 2 units in the last place for |angle| < 1e6, built
/// from additions and multiplications only, so that every compiler and library gives the same bits.
/// Beyond 1e6 the angle is first reduced by whole turns of the double 2 pi: bounded and repeatable,
/// but off by about |angle| * 4e-17. NaN for NaN and infinity.
[[nodiscard]] SineCosine sine_cosine(double angle);

/// The angle [rad] brought into [-pi, pi] by whole turns: within 1e-15 and the rounding of the
/// angle itself for |angle| < 1e6. NaN for NaN and infinity.
[[nodiscard]] double wrapped_angle(double angle);

}  // namespace lod
