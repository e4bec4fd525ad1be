#include "lodlab/lod3d/solid/surface.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/math/bit_hash.hpp"
#include "lodlab/core/math/polygon.hpp"
#include "lodlab/lod3d/mesh/intersect.hpp"

namespace lod3d {
namespace {

using Pair = lod::PartPair<3>;

/// Lists feet as they are found and keeps the nearest.
class Listing {
  public:
    Listing(Pair& pair, double feet_within) : pair_(pair), within2_(feet_within * feet_within) {
        if (feet_within < 0) within2_ = -1;
    }
    /// Returns whether these are the nearest so far.
    bool offer(const Point& on_a, const Point& on_b) {
        const double squared = (on_b - on_a).squaredNorm();
        if (squared <= within2_) pair_.feet[pair_.feet_count++] = {on_a, on_b};
        if (squared >= least2_) return false;
        least2_ = squared;
        pair_.nearest = {on_a, on_b};
        return true;
    }
    [[nodiscard]] double least() const { return std::sqrt(least2_); }

  private:
    Pair& pair_;
    double within2_;
    double least2_ = std::numeric_limits<double>::infinity();
};

/// The feet of two segments' lines where both lie within the segments and the lines are not
/// parallel; else an end's foot is nearer, and triangles list those.
std::optional<Pair::Feet> inner_feet(const Point& a0, const Point& a1, const Point& b0,
                                     const Point& b1) {
    const Point u = a1 - a0;
    const Point v = b1 - b0;
    const Point w = b0 - a0;
    const double uu = u.dot(u);
    const double vv = v.dot(v);
    const double uv = u.dot(v);
    const double area2 = u.cross(v).squaredNorm();
    constexpr double parallel = 1e-20;  // of the squared sine
    if (area2 <= parallel * uu * vv) return {};
    const double s = (w.dot(u) * vv - w.dot(v) * uv) / area2;
    const double t = (w.dot(u) * uv - w.dot(v) * uu) / area2;
    if (s < 0 || s > 1 || t < 0 || t > 1) return {};
    return Pair::Feet{a0 + s * u, b0 + t * v};
}

void add_unit(Pair& pair, const Point& direction) {
    const Point unit = direction.stableNormalized();
    if (!unit.isZero(0.5)) pair.add_direction(unit);
}

/// The way between two feet, put at right angles to the sides of a triangle on which one of them
/// lies: to those within which it lies, since the way is the shortest; and where it lies on a
/// corner, to those to which the way stands so within rounding. Rounding tilts a short way, and a
/// long side would show that.
Point squared_up(Point way, const Point& foot, const lod::Facet<3>& t) {
    constexpr double rounding = 32 * std::numeric_limits<double>::epsilon();
    const double noise = rounding * foot.cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < 3; ++i) {
        const double length = (t[(i + 1) % 3] - t[i]).norm();
        const Point side = (t[(i + 1) % 3] - t[i]).stableNormalized();
        const double at = side.dot(foot - t[i]);
        const bool on_line = (foot - t[i] - at * side).norm() <= noise + rounding * length;
        if (!on_line || at < -noise || at > length + noise) continue;
        const bool within = at > 1e-9 * length && at < (1 - 1e-9) * length;
        const double along = side.dot(way);
        if (within || std::abs(along) <= noise) way -= along * side;
    }
    return way;
}

TriangleTree::Corners corners_of(const lod::Facet<3>& t) {
    return {t[0], t[1], t[2]};
}

}  // namespace

lod::PartPair<3> nearest_triangles(const lod::Facet<3>& a, const lod::Facet<3>& b,
                                   double feet_within) {
    Pair pair;
    pair.a = lod::part_of<3>(a);
    pair.b = lod::part_of<3>(b);
    const TriangleTree::Corners in_a = corners_of(a);
    const TriangleTree::Corners in_b = corners_of(b);
    if (triangles_intersect(in_a, in_b)) return pair;
    Listing listing(pair, feet_within);
    for (const Point& p : a) listing.offer(p, nearest_on_triangle(in_b, p));
    for (const Point& q : b) listing.offer(nearest_on_triangle(in_a, q), q);
    Point across = Point::Zero();  // of two sides that are nearest
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const auto feet = inner_feet(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]);
            if (!feet || !listing.offer(feet->on_a, feet->on_b)) continue;
            across = (a[(i + 1) % 3] - a[i]).cross(b[(j + 1) % 3] - b[j]);
            if (across.dot(feet->on_b - feet->on_a) < 0) across = -across;
        }
    pair.distance = listing.least();
    add_unit(pair, lod::Space<3>::facet_normal(a));
    add_unit(pair, -lod::Space<3>::facet_normal(b));
    add_unit(pair, across);
    pair.firm_directions = pair.directions;
    const Point way = pair.nearest.on_b - pair.nearest.on_a;
    add_unit(pair, squared_up(way, pair.nearest.on_a, a));
    add_unit(pair, squared_up(way, pair.nearest.on_b, b));
    add_unit(pair, way);
    return pair;
}

ExactSurface::ExactSurface(const Solid& solid) : distance_(solid.mesh, solid.inside_rule) {
    const Parts parts = find_parts(solid.mesh);
    std::vector<bool> seen(static_cast<std::size_t>(parts.count), false);
    for (std::size_t t = 0; t < solid.mesh.triangles.size(); ++t) {
        const auto part = static_cast<std::size_t>(parts.of_triangle[t]);
        if (!seen[part]) witnesses_.push_back(solid.mesh.corner(t, 0));
        seen[part] = true;
    }
    lod::BitHash hash;
    hash.add_all(solid.mesh.vertices);
    for (const Triangle& triangle : solid.mesh.triangles) hash.add_all(triangle);
    hash_ = hash.value();
    for (const Point& p : solid.mesh.vertices) radius_ = std::max(radius_, p.norm());
}

lod::BoxNode<3> ExactSurface::box_node(std::int32_t i) const {
    const TriangleTree::Node& node = distance_.tree().node(i);
    if (node.is_leaf()) return {node.low, node.high, 0, node.first, node.first + node.count};
    return {node.low, node.high, node.first, 0, 0};
}

lod::Facet<3> ExactSurface::facet(std::int32_t triangle) const {
    const TriangleTree::Corners& t = distance_.tree().corners(triangle);
    return {t.a, t.b, t.c};
}

void ExactSurface::visit_pairs(const lod::ExactShape<3>& b, const lod::Placement<3>& b_in_a,
                               lod::PartVisitor<3>& visitor) const {
    lod::walk_pairs<3>(*this, lod::of_kind<ExactSurface>(b, "a surface"), b_in_a, nearest_triangles,
                       visitor);
}

namespace {

using Contacts = std::vector<lod::Contact<3>>;

/// A contact point seen along the normal.
struct Seen {
    lod::Vector<2> at;
    std::size_t number;
};

double turn(const Seen& a, const Seen& b, const Seen& c) {
    const lod::Vector<2> u = b.at - a.at;
    const lod::Vector<2> v = c.at - a.at;
    return u.x() * v.y() - u.y() * v.x();
}

std::vector<Seen> without_repeats(const Contacts& contacts, const Point& normal, double tolerance) {
    const Point x = normal.unitOrthogonal();
    const Point y = normal.cross(x);
    std::vector<Seen> points;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Seen next{{x.dot(contacts[i].point), y.dot(contacts[i].point)}, i};
        if (std::none_of(points.begin(), points.end(), [&](const Seen& other) {
                return (other.at - next.at).norm() <= tolerance;
            }))
            points.push_back(next);
    }
    return points;
}

/// Drops corners between their neighbours that stand out of the line by no more than rounding.
void drop_flat_corners(std::vector<Seen>& hull, double tolerance) {
    for (std::size_t i = 0; hull.size() > 2 && i < hull.size();) {
        const Seen& before = hull[(i + hull.size() - 1) % hull.size()];
        const Seen& after = hull[(i + 1) % hull.size()];
        const bool between = (before.at - hull[i].at).dot(after.at - hull[i].at) <= 0;
        if (between && turn(before, hull[i], after) <= tolerance * (after.at - before.at).norm())
            hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
}

}  // namespace

void ExactSurface::keep_corners(const Point& normal, double tolerance, Contacts& contacts) const {
    std::vector<Seen> corners = without_repeats(contacts, normal, tolerance);
    if (corners.size() > 2) {
        corners = lod::convex_hull(std::move(corners), [](const Seen& p) { return p.at; });
        drop_flat_corners(corners, tolerance);
    }
    Contacts kept;
    for (const Seen& corner : corners) kept.push_back(contacts[corner.number]);
    contacts = std::move(kept);
}

}  // namespace lod3d
