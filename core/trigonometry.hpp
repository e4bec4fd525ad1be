#pragma once

namespace lod {

struct SineCosine {
    double sine;
    double cosine;
};

/// Sine and cosine of an angle [rad], within 2 units in the last place for |angle| < 1e6, built
/// from additions and multiplications only, so that every compiler and library gives the same bits.
[[nodiscard]] SineCosine sine_cosine(double angle);

/// The angle [rad] brought into [-pi, pi] by whole turns.
[[nodiscard]] double wrapped_angle(double angle);

}  // namespace lod
