#include "core/contact.hpp"

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

#define LOD_INSTANTIATE(Dim)                                                                 \
    template std::optional<Contact<Dim>> model_contact(const Sphere<Dim>&, const Sphere<Dim>&, \
                                                       PointModel, const Vector<Dim>&);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
