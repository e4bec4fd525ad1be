#pragma once

#include <map>
#include <utility>

#include "lodlab/measure/collisions.hpp"

namespace measuretest {

/// Shapes whose sizes and separations are given, not made.
class GivenShapes final : public measure::BodyShapes<2> {
  public:
    std::vector<double> sizes{1, 1, 1, 1};
    double apart = 0;

    [[nodiscard]] double size(int body) const override {
        return sizes[static_cast<std::size_t>(body)];
    }
    [[nodiscard]] double separation(int, const lod::Body<2>&, int,
                                    const lod::Body<2>&) const override {
        return apart;
    }
};

/// Mass 1 kg, inertia 1 kg m^2.
inline lod::Body<2> unit_body(lod::Vector<2> velocity, double spin = 0) {
    lod::Body<2> body;
    lod::set_mass<2>(body, 1, lod::Inertia<2>::Constant(1));
    body.velocity = velocity;
    body.spin[0] = spin;
    return body;
}

/// Bodies a and b at a time, A at 1 m/s along x; B at rest and left at rest.
inline measure::Collision<2> collision_at(double time, int a = 0, int b = 1) {
    measure::Collision<2> collision;
    collision.a = a;
    collision.b = b;
    collision.time = collision.until = time;
    collision.before = {unit_body({1, 0}), unit_body({0, 0})};
    collision.after = {unit_body({0, 1}), unit_body({0, 0})};
    return collision;
}

}  // namespace measuretest
