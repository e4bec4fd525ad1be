#include "lodlab/core/exact/exact_shape.hpp"

#include <algorithm>
#include <limits>

namespace lod {
namespace {

template <int Dim>
class NearestPair final : public PartVisitor<Dim> {
  public:
    bool skips(const ConvexPart<Dim>&, const ConvexPart<Dim>&, const Vector<Dim>&,
               double gap) const override {
        return gap >= best.distance;
    }
    void visit(const PartPair<Dim>& pair) override {
        if (pair.distance < best.distance)
            best = {pair.nearest.on_a, pair.nearest.on_b, pair.distance};
    }
    bool is_done() const override { return best.distance <= 0; }

    Separation<Dim> best{{}, {}, std::numeric_limits<double>::infinity()};
};

/// How far two parts are apart along a unit vector.
template <int Dim>
double gap_along(const Vector<Dim>& n, const ConvexPart<Dim>& a, const ConvexPart<Dim>& b) {
    double front = -std::numeric_limits<double>::infinity();
    double back = std::numeric_limits<double>::infinity();
    for (const Vector<Dim>& p : a.corners()) front = std::max(front, n.dot(p));
    for (const Vector<Dim>& q : b.corners()) back = std::min(back, n.dot(q));
    return back - front - a.radius - b.radius;
}

/// The normal of a facet, or of two sides that cross, stands for the shortest way where it
/// separates the parts as well, up to this share: the way's own direction is lost to rounding when
/// it is short.
constexpr double as_well = 0.999;

/// Which direction of a pair is the contact's normal; the last one is the shortest way.
template <int Dim>
std::size_t choose_normal(const PartPair<Dim>& pair) {
    std::size_t k = 0;
    while (k + 1 < pair.directions &&
           gap_along(pair.direction[k], pair.a, pair.b) < as_well * pair.distance)
        ++k;
    return k;
}

/// How far a point is from the box about a part, at least; along the axis where that is most.
template <int Dim>
double distance_to_box(const ConvexPart<Dim>& part, const Vector<Dim>& point) {
    Vector<Dim> low = part.corner[0];
    Vector<Dim> high = low;
    for (const Vector<Dim>& corner : part.corners()) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    return (low - point).cwiseMax(point - high).maxCoeff() - part.radius;
}

template <int Dim>
class Touching final : public PartVisitor<Dim> {
  public:
    explicit Touching(double reach) : reach_(reach) { this->feet_within = reach; }

    bool skips(const ConvexPart<Dim>&, const ConvexPart<Dim>&, const Vector<Dim>&,
               double gap) const override {
        return gap > reach_;
    }
    void visit(const PartPair<Dim>& pair) override {
        if (pair.distance > reach_ || pair.directions == 0) return;
        const std::size_t chosen = choose_normal(pair);
        near.push_back(pair);
        auto& found = chosen < pair.firm_directions ? firm : loose;
        for (std::size_t k = 0; k < pair.feet_count; ++k) {
            const auto& [on_a, on_b] = pair.feet[k];
            found.push_back({0.5 * (on_a + on_b), pair.direction[chosen],
                             -pair.direction[chosen].dot(on_b - on_a)});
        }
    }

    // Frame of A.
    std::vector<Contact<Dim>> firm;   ///< with the normals of facets
    std::vector<Contact<Dim>> loose;  ///< with the directions of shortest ways
    std::vector<PartPair<Dim>> near;  ///< all that are within reach

  private:
    double reach_;
};

/// Normals whose cosine is no further from 1 belong to one face: 1e-4 rad.
constexpr double one_normal = 5e-9;

/// Where corner and corner meet, the bodies are apart near by along several normals, and one along
/// which they do not approach is enough: they pass each other. Drops the contacts of such a point
/// that approach. Frame of A; `motion` is the velocity of B's point less that of A's.
template <int Dim, class Motion>
void drop_passed_corners(const Touching<Dim>& touching, double near, const Motion& motion,
                         std::vector<Contact<Dim>>& contacts) {
    constexpr double rounding = 1e-12;  // of a speed
    const auto is_local = [&](const PartPair<Dim>& pair, const Vector<Dim>& point) {
        return distance_to_box(pair.a, point) <= near && distance_to_box(pair.b, point) <= near;
    };
    const auto apart_along = [&](const Vector<Dim>& normal, const Vector<Dim>& point) {
        return std::all_of(
            touching.near.begin(), touching.near.end(), [&](const PartPair<Dim>& pair) {
                return !is_local(pair, point) || gap_along(normal, pair.a, pair.b) >= -near;
            });
    };
    std::erase_if(contacts, [&](const Contact<Dim>& contact) {
        const Vector<Dim> speed = motion(contact.point);
        if (contact.normal.dot(speed) >= 0) return false;
        return std::any_of(
            touching.near.begin(), touching.near.end(), [&](const PartPair<Dim>& pair) {
                if (!is_local(pair, contact.point)) return false;
                const std::span normals(pair.direction.data(), pair.firm_directions);
                return std::any_of(normals.begin(), normals.end(), [&](const Vector<Dim>& normal) {
                    return normal.dot(speed) >= -rounding * speed.norm() &&
                           apart_along(normal, contact.point);
                });
            });
    });
}

/// Moves the contacts with the normal of the first one to `face`; all take that normal.
template <int Dim>
void take_one_face(std::vector<Contact<Dim>>& contacts, std::vector<Contact<Dim>>& face) {
    const Vector<Dim> normal = contacts.front().normal;
    const auto rest = std::stable_partition(
        contacts.begin(), contacts.end(),
        [&](const Contact<Dim>& c) { return c.normal.dot(normal) >= 1 - one_normal; });
    face.assign(contacts.begin(), rest);
    for (Contact<Dim>& contact : face) contact.normal = normal;
    contacts.erase(contacts.begin(), rest);
}

}  // namespace

template <int Dim>
Separation<Dim> separation(const Body<Dim>& a, const Body<Dim>& b) {
    const Placement<Dim> at_a = placement(a);
    NearestPair<Dim> nearest;
    a.exact->visit_pairs(*b.exact, seen_from(at_a, placement(b)), nearest);
    return {at_a.carry(nearest.best.on_a), at_a.carry(nearest.best.on_b), nearest.best.distance};
}

template <int Dim>
bool exactly_overlap(const Body<Dim>& a, const Body<Dim>& b) {
    if (separation(a, b).distance == 0) return true;
    const auto holds_part = [](const Body<Dim>& outer, const Body<Dim>& inner) {
        const Placement<Dim> place = seen_from(placement(outer), placement(inner));
        const auto witnesses = inner.exact->witnesses();
        return std::any_of(witnesses.begin(), witnesses.end(), [&](const Vector<Dim>& p) {
            return outer.exact->holds(place.carry(p));
        });
    };
    return holds_part(a, b) || holds_part(b, a);
}

template <int Dim>
void touching_contacts(const Body<Dim>& a, const Body<Dim>& b, double reach,
                       std::vector<Contact<Dim>>& contacts) {
    const Placement<Dim> at_a = placement(a);
    Touching<Dim> touching(reach);
    a.exact->visit_pairs(*b.exact, seen_from(at_a, placement(b)), touching);
    std::vector<Contact<Dim>>& found = touching.firm;  // first: others take their normals
    found.insert(found.end(), touching.loose.begin(), touching.loose.end());
    const auto motion = [&](const Vector<Dim>& point) {
        const Vector<Dim> p = at_a.carry(point);
        const Vector<Dim> of_a = a.velocity + Space<Dim>::cross(a.spin, p - a.position);
        const Vector<Dim> of_b = b.velocity + Space<Dim>::cross(b.spin, p - b.position);
        return Vector<Dim>(at_a.rotation.transpose() * (of_b - of_a));
    };
    drop_passed_corners<Dim>(touching, 4 * reach, motion, found);
    contacts.clear();
    std::vector<Contact<Dim>> face;
    while (!found.empty()) {
        take_one_face(found, face);
        a.exact->keep_corners(face.front().normal, 4 * reach, face);
        for (const Contact<Dim>& c : face)
            contacts.push_back({at_a.carry(c.point), at_a.rotation * c.normal, c.depth});
    }
}

#define LOD_INSTANTIATE(Dim)                                                    \
    template Separation<Dim> separation(const Body<Dim>&, const Body<Dim>&);    \
    template bool exactly_overlap(const Body<Dim>&, const Body<Dim>&);          \
    template void touching_contacts(const Body<Dim>&, const Body<Dim>&, double, \
                                    std::vector<Contact<Dim>>&);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
