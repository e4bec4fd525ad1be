#include "lodlab/core/tree/body.hpp"

#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/math/solvers.hpp"

namespace lod {

template <int Dim>
void set_mass(Body<Dim>& body, double mass, const Inertia<Dim>& inertia) {
    if (!(mass > 0) || !std::isfinite(mass))
        throw Error(ErrorKind::input_refused, "mass must be a finite number above 0, not " +
                                                  std::to_string(mass) +
                                                  "; for a body that never moves say static");
    if (!is_positive_definite(inertia))
        throw Error(ErrorKind::input_refused,
                    "inertia must be finite and positive definite; give the shape some extent");
    body.inverse_mass = 1 / mass;
    body.inertia = inertia;
    body.inverse_inertia = inverse(inertia);
}

template <int Dim>
void make_static(Body<Dim>& body) {
    body.inverse_mass = 0;
    body.inertia.setZero();
    body.inverse_inertia.setZero();
    body.velocity.setZero();
    body.spin.setZero();
}

namespace {
bool all_finite(double angle) {
    return std::isfinite(angle);
}
bool all_finite(const Quaternion& q) {
    return q.coeffs().allFinite();
}
}  // namespace

template <int Dim>
void check_body(const Body<Dim>& body, const std::string& name) {
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::input_refused, "body " + name + ": " + why);
    };
    if (!body.tree || body.tree->size() == 0) refuse("has no tree; build one for its shape");
    if (body.tree->is_half_space() && !body.is_static())
        refuse("is a half-space, which has no mass; make it static");
    if (!body.position.allFinite() || !body.velocity.allFinite() || !body.spin.allFinite() ||
        !all_finite(body.orientation))
        refuse("position, orientation, velocity and spin must be finite numbers");
    if (!(body.restitution >= 0 && body.restitution <= 1))
        refuse("restitution must lie between 0 and 1, not " + std::to_string(body.restitution));
}

template <int Dim>
double kinetic_energy(std::span<const Body<Dim>> bodies) {
    double energy = 0;
    for (const Body<Dim>& body : bodies) {
        if (body.is_static()) continue;
        const Spin<Dim> turning = Space<Dim>::carried(body.orientation, body.inertia) * body.spin;
        energy += 0.5 * (body.velocity.squaredNorm() / body.inverse_mass + body.spin.dot(turning));
    }
    return energy;
}

template <int Dim>
Vector<Dim> momentum(std::span<const Body<Dim>> bodies) {
    Vector<Dim> total = Vector<Dim>::Zero();
    for (const Body<Dim>& body : bodies)
        if (!body.is_static()) total += body.velocity / body.inverse_mass;
    return total;
}

template <int Dim>
Spin<Dim> angular_momentum(std::span<const Body<Dim>> bodies) {
    Spin<Dim> total = Spin<Dim>::Zero();
    for (const Body<Dim>& body : bodies) {
        if (body.is_static()) continue;
        total += Space<Dim>::carried(body.orientation, body.inertia) * body.spin;
        total += Space<Dim>::moment(body.position, Vector<Dim>(body.velocity / body.inverse_mass));
    }
    return total;
}

#define LOD_INSTANTIATE(Dim)                                         \
    template void set_mass(Body<Dim>&, double, const Inertia<Dim>&); \
    template void make_static(Body<Dim>&);                           \
    template void check_body(const Body<Dim>&, const std::string&);  \
    template double kinetic_energy(std::span<const Body<Dim>>);      \
    template Vector<Dim> momentum(std::span<const Body<Dim>>);       \
    template Spin<Dim> angular_momentum(std::span<const Body<Dim>>);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
