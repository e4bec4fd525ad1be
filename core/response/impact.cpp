#include "lodlab/core/response/impact.hpp"

namespace lod {
namespace {

/// What a unit impulse along n at arm r adds to the body's velocity there, along n.
template <int Dim>
double compliance(const Body<Dim>& body, const Inertia<Dim>& inverse_inertia, const Vector<Dim>& r,
                  const Vector<Dim>& n) {
    const Spin<Dim> turning = Space<Dim>::moment(r, n);
    return body.inverse_mass + turning.dot(inverse_inertia * turning);
}

template <int Dim>
void push(Body<Dim>& body, const Inertia<Dim>& inverse_inertia, const Vector<Dim>& r,
          const Vector<Dim>& impulse) {
    body.velocity += body.inverse_mass * impulse;
    body.spin += inverse_inertia * Space<Dim>::moment(r, impulse);
}

}  // namespace

template <int Dim>
double closing_velocity(const Body<Dim>& a, const Body<Dim>& b, const Contact<Dim>& contact) {
    const Vector<Dim> r_a = contact.point - a.position;
    const Vector<Dim> r_b = contact.point - b.position;
    return contact.normal.dot(velocity_at(b, r_b) - velocity_at(a, r_a));
}

template <int Dim>
double inverse_effective_mass(const Body<Dim>& a, const Body<Dim>& b, const Contact<Dim>& contact) {
    return inverse_effective_mass<Dim>(a, world_inverse_inertia(a), b, world_inverse_inertia(b),
                                       contact);
}

template <int Dim>
double inverse_effective_mass(const Body<Dim>& a, const Inertia<Dim>& inverse_a, const Body<Dim>& b,
                              const Inertia<Dim>& inverse_b, const Contact<Dim>& contact) {
    const Vector<Dim> r_a = contact.point - a.position;
    const Vector<Dim> r_b = contact.point - b.position;
    return compliance<Dim>(a, inverse_a, r_a, contact.normal) +
           compliance<Dim>(b, inverse_b, r_b, contact.normal);
}

template <int Dim>
double single_impulse(const Body<Dim>& a, const Body<Dim>& b, const Contact<Dim>& contact) {
    const double v_c = closing_velocity(a, b, contact);
    if (v_c >= 0) return 0;  // already parting
    const double K = inverse_effective_mass(a, b, contact);
    if (K == 0) return 0;  // neither can move
    return -(1 + pair_restitution(a, b)) * v_c / K;
}

template <int Dim>
void apply_impulse(Body<Dim>& a, Body<Dim>& b, const Contact<Dim>& contact, double j) {
    apply_impulse<Dim>({a, world_inverse_inertia(a)}, {b, world_inverse_inertia(b)}, contact, j);
}

template <int Dim>
void apply_impulse(const PushedBody<Dim>& a, const PushedBody<Dim>& b, const Contact<Dim>& contact,
                   double j) {
    const Vector<Dim> impulse = j * contact.normal;
    push<Dim>(a.body, a.inverse_inertia, contact.point - a.body.position, -impulse);
    push<Dim>(b.body, b.inverse_inertia, contact.point - b.body.position, impulse);
}

#define LOD_INSTANTIATE(Dim)                                                                   \
    template double closing_velocity(const Body<Dim>&, const Body<Dim>&, const Contact<Dim>&); \
    template double inverse_effective_mass(const Body<Dim>&, const Body<Dim>&,                 \
                                           const Contact<Dim>&);                               \
    template double inverse_effective_mass(const Body<Dim>&, const Inertia<Dim>&,              \
                                           const Body<Dim>&, const Inertia<Dim>&,              \
                                           const Contact<Dim>&);                               \
    template double single_impulse(const Body<Dim>&, const Body<Dim>&, const Contact<Dim>&);   \
    template void apply_impulse(Body<Dim>&, Body<Dim>&, const Contact<Dim>&, double);          \
    template void apply_impulse(const PushedBody<Dim>&, const PushedBody<Dim>&,                \
                                const Contact<Dim>&, double);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
