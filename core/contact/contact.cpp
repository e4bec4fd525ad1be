#include "lodlab/core/contact/contact.hpp"

#include <algorithm>
#include <cmath>

namespace lod {
namespace {

template <int Dim>
Vector<Dim> unit_normal(const Vector<Dim>& centre_line, const Vector<Dim>& fallback) {
    if (const double length = centre_line.stableNorm(); length > 0) return centre_line / length;
    if (const double length = fallback.stableNorm(); length > 0) return fallback / length;
    return Vector<Dim>::Unit(0);
}

/// Distance of the contact point from A's centre along the normal.
double along(PointModel model, double d, double radius_a, double radius_b) {
    if (model == PointModel::radius_ratio) {
        const double sum = radius_a + radius_b;
        return sum > 0 ? d * radius_a / sum : d / 2;
    }
    const bool crossing = d > std::abs(radius_a - radius_b);
    if (crossing) return 0.5 * (d + (radius_a - radius_b) * ((radius_a + radius_b) / d));
    if (radius_a == radius_b) return d / 2;
    return radius_a < radius_b ? -radius_a : d + radius_b;
}

/// How far a surface is trusted: coherence^coherence_power, by squaring, for libm's pow may differ
/// from system to system.
double trust(double coherence) {
    static_assert(coherence_power == 16);
    double power = coherence;
    for (int exponent = 1; exponent < coherence_power; exponent *= 2) power *= power;
    return power;
}

/// See model_surface_contact in the header.
template <int Dim>
Vector<Dim> blended(const Vector<Dim>& line, const Vector<Dim>& normal_a,
                    const Vector<Dim>& normal_b) {
    const double coherence_a = std::min(1.0, normal_a.norm());
    const double coherence_b = std::min(1.0, normal_b.norm());
    const double trust_a = trust(coherence_a);
    const double trust_b = trust(coherence_b);
    const double doubt = 1 - std::max(trust_a, trust_b);
    if (doubt == 1) return line;
    Vector<Dim> blend = doubt * doubt * line;
    if (trust_a > 0) blend += trust_a / coherence_a * normal_a;
    if (trust_b > 0) blend -= trust_b / coherence_b * normal_b;
    const double length = blend.norm();
    return length < least_blend ? line : Vector<Dim>(blend / length);
}

}  // namespace

template <int Dim>
std::optional<Contact<Dim>> model_contact(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                          PointModel model, const Vector<Dim>& fallback) {
    const Vector<Dim> centre_line = b.centre - a.centre;
    const double d = centre_line.norm();
    const double depth = a.radius + b.radius - d;
    if (depth < 0) return std::nullopt;
    Contact<Dim> contact;
    contact.normal = unit_normal<Dim>(centre_line, fallback);
    contact.point = a.centre + along(model, d, a.radius, b.radius) * contact.normal;
    contact.depth = depth;
    return contact;
}

template <int Dim>
std::optional<Contact<Dim>> model_surface_contact(const SurfaceNode<Dim>& a,
                                                  const SurfaceNode<Dim>& b, PointModel model,
                                                  const Vector<Dim>& fallback) {
    std::optional<Contact<Dim>> contact = model_contact(a.ball, b.ball, model, fallback);
    if (contact) contact->normal = blended<Dim>(contact->normal, a.mean_normal, b.mean_normal);
    return contact;
}

template <int Dim>
std::optional<Contact<Dim>> model_border_contact(const Sphere<Dim>& ball,
                                                 const HalfSpace<Dim>& half_space, bool swapped,
                                                 PointModel model) {
    const Vector<Dim>& normal = half_space.normal;
    const double height = half_space.side(ball.centre);
    if (height > ball.radius) return std::nullopt;
    const double down = model == PointModel::radius_ratio ? ball.radius : height;
    return Contact<Dim>{ball.centre - down * normal, swapped ? normal : Vector<Dim>(-normal),
                        ball.radius - height};
}

#define LOD_INSTANTIATE(Dim)                                                                   \
    template std::optional<Contact<Dim>> model_contact(const Sphere<Dim>&, const Sphere<Dim>&, \
                                                       PointModel, const Vector<Dim>&);        \
    template std::optional<Contact<Dim>> model_surface_contact(                                \
        const SurfaceNode<Dim>&, const SurfaceNode<Dim>&, PointModel, const Vector<Dim>&);     \
    template std::optional<Contact<Dim>> model_border_contact(                                 \
        const Sphere<Dim>&, const HalfSpace<Dim>&, bool, PointModel);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
