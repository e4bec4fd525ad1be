#include "lodlab/lod3d/mesh/intersect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/math/box_tree.hpp"
#include "lodlab/lod3d/mesh/distance.hpp"

namespace lod3d {
namespace {

using Corners = TriangleTree::Corners;

double orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
    return (b - a).cross(c - a).dot(d - a);
}

/// Positive where c lies to the left of the line from a to b.
double side_of(const lod::Vector<2>& a, const lod::Vector<2>& b, const lod::Vector<2>& c) {
    return lod::Space<2>::moment(b - a, c - a)[0];
}

bool same_side(double s, double t) {
    return (s > 0 && t > 0) || (s < 0 && t < 0);
}

bool sides_meet(const lod::Vector<2>& p, const lod::Vector<2>& q, const lod::Vector<2>& a,
                const lod::Vector<2>& b) {
    if (p.cwiseMax(q).any_below(a.cwiseMin(b)) || a.cwiseMax(b).any_below(p.cwiseMin(q)))
        return false;
    return !same_side(side_of(p, q, a), side_of(p, q, b)) &&
           !same_side(side_of(a, b, p), side_of(a, b, q));
}

bool holds(const std::array<lod::Vector<2>, 3>& t, const lod::Vector<2>& p) {
    const double u = side_of(t[0], t[1], p);
    const double v = side_of(t[1], t[2], p);
    const double w = side_of(t[2], t[0], p);
    return (u >= 0 && v >= 0 && w >= 0 && u + v + w > 0) ||
           (u <= 0 && v <= 0 && w <= 0 && u + v + w < 0);
}

/// Two triangles in one plane, seen along the axis of the plane's normal that is longest.
bool coplanar_intersect(const Corners& s, const Corners& t, const Point& normal) {
    const int drop = normal.cwiseAbs().most_place();
    const auto flat = [&](const Corners& c) {
        const auto seen = [&](const Point& p) {
            return lod::Vector<2>(p[(drop + 1) % 3], p[(drop + 2) % 3]);
        };
        return std::array{seen(c.a), seen(c.b), seen(c.c)};
    };
    const auto u = flat(s);
    const auto v = flat(t);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (sides_meet(u[i], u[(i + 1) % 3], v[j], v[(j + 1) % 3])) return true;
    return holds(u, v[0]) || holds(v, u[0]);
}

/// Whether the segment pq meets the triangle. Requires: p and q not both in its plane.
bool segment_pierces(const Point& p, const Point& q, const Corners& t) {
    const double u = orientation(p, q, t.a, t.b);
    const double v = orientation(p, q, t.b, t.c);
    const double w = orientation(p, q, t.c, t.a);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

/// Sides of the corners of `of` against the plane of `plane`.
std::array<double, 3> sides(const Corners& plane, const Corners& of) {
    return {orientation(plane.a, plane.b, plane.c, of.a),
            orientation(plane.a, plane.b, plane.c, of.b),
            orientation(plane.a, plane.b, plane.c, of.c)};
}

bool all_one_side(const std::array<double, 3>& side) {
    return (side[0] > 0 && side[1] > 0 && side[2] > 0) ||
           (side[0] < 0 && side[1] < 0 && side[2] < 0);
}

/// Whether a side of s that crosses the plane of t meets t.
bool side_pierces(const Corners& s, const std::array<double, 3>& side, const Corners& t) {
    const std::array<const Point*, 3> corner{&s.a, &s.b, &s.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (same_side(side[i], side[j]) || (side[i] == 0 && side[j] == 0)) continue;
        if (segment_pierces(*corner[i], *corner[j], t)) return true;
    }
    return false;
}

bool boxes_apart(const Corners& s, const Corners& t) {
    const Point low_s = s.a.cwiseMin(s.b).cwiseMin(s.c);
    const Point high_s = s.a.cwiseMax(s.b).cwiseMax(s.c);
    const Point low_t = t.a.cwiseMin(t.b).cwiseMin(t.c);
    const Point high_t = t.a.cwiseMax(t.b).cwiseMax(t.c);
    return high_t.any_below(low_s) || high_s.any_below(low_t);
}

}  // namespace

bool triangles_intersect(const Corners& s, const Corners& t) {
    if (boxes_apart(s, t)) return false;
    const std::array<double, 3> of_t = sides(s, t);
    if (all_one_side(of_t)) return false;
    const std::array<double, 3> of_s = sides(t, s);
    if (all_one_side(of_s)) return false;
    const auto flat = [](const std::array<double, 3>& side) {
        return side[0] == 0 && side[1] == 0 && side[2] == 0;
    };
    if (flat(of_s) && flat(of_t)) {
        Point normal = (s.b - s.a).cross(s.c - s.a);
        if (normal.isZero(0)) normal = (t.b - t.a).cross(t.c - t.a);
        return coplanar_intersect(s, t, normal);
    }
    return side_pierces(s, of_s, t) || side_pierces(t, of_t, s);
}

namespace {

/// b's frame seen from a's.
Pose relative(const Pose& a, const Pose& b) {
    return {a.rotation.transpose() * b.rotation,
            a.rotation.transpose() * (b.position - a.position)};
}

/// Boxes of two nodes in their own frames, the second posed in the first's: the axes of both
/// boxes as separating axes (the nine cross products are left out; that errs towards overlap).
class BoxTest {
  public:
    explicit BoxTest(const Pose& b_in_a)
        : pose_(b_in_a), size_(b_in_a.rotation.cwiseAbs() + lod::Matrix<3>::Constant(1e-12)) {}

    [[nodiscard]] bool apart(const TriangleTree::Node& a, const TriangleTree::Node& b) const {
        const Point half_a = 0.5 * (a.high - a.low);
        const Point half_b = 0.5 * (b.high - b.low);
        const Point between = pose_.carry(0.5 * (b.low + b.high)) - 0.5 * (a.low + a.high);
        if ((half_a + size_ * half_b).any_below(between.cwiseAbs())) return true;
        const Point in_b = pose_.rotation.transpose() * between;
        return (half_b + size_.transpose() * half_a).any_below(in_b.cwiseAbs());
    }

  private:
    Pose pose_;
    lod::Matrix<3> size_;
};

double size_of(const TriangleTree::Node& node) {
    return (node.high - node.low).squaredNorm();
}

/// Whether any triangle of one tree and any of the other, both in A's frame, are as `meet` says.
template <class Meet>
bool any_meet(const TriangleTree& a, const TriangleTree& b, const Pose& b_in_a, const Meet& meet) {
    const auto leaves_meet = [&](const TriangleTree::Node& m, const TriangleTree::Node& n) {
        for (std::int32_t j = n.first; j < n.first + n.count; ++j) {
            const Corners& t = b.corners(j);
            const Corners carried{b_in_a.carry(t.a), b_in_a.carry(t.b), b_in_a.carry(t.c)};
            for (std::int32_t i = m.first; i < m.first + m.count; ++i)
                if (meet(a.corners(i), carried)) return true;
        }
        return false;
    };
    const BoxTest test(b_in_a);
    std::vector<std::array<std::int32_t, 2>> waiting{{0, 0}};
    while (!waiting.empty()) {
        const auto [i, j] = waiting.back();
        waiting.pop_back();
        const TriangleTree::Node& m = a.node(i);
        const TriangleTree::Node& n = b.node(j);
        if (test.apart(m, n)) continue;
        if (m.is_leaf() && n.is_leaf()) {
            if (leaves_meet(m, n)) return true;
        } else if (n.is_leaf() || (!m.is_leaf() && size_of(m) >= size_of(n))) {
            waiting.push_back({m.first, j});
            waiting.push_back({i + 1, j});
        } else {
            waiting.push_back({i, n.first});
            waiting.push_back({i, j + 1});
        }
    }
    return false;
}

/// Whether two flat triangles share more than a hair's breadth: no side of either parts them.
bool share_area(const Corners& s, const Corners& t, const Point& normal, double hair) {
    const std::array<const Corners*, 2> both{&s, &t};
    for (const Corners* own : both) {
        const std::array<Point, 3> corner{own->a, own->b, own->c};
        const Corners& other = own == &s ? t : s;
        for (std::size_t i = 0; i < 3; ++i) {
            const Point out = (corner[(i + 1) % 3] - corner[i]).cross(normal).normalized();
            const double nearest = std::min({out.dot(other.a), out.dot(other.b), out.dot(other.c)});
            if (nearest >= out.dot(corner[i]) - hair) return false;
        }
    }
    return true;
}

/// A part of a mesh, as others meet it.
struct Part {
    TriangleTree tree;
    MeshDistance distance;
    explicit Part(const Mesh& mesh) : tree(mesh), distance(mesh) {}
};

/// Deeper than a hair: on a surface, as where faces touch, rounding decides what the winding is.
bool is_well_within(const MeshDistance& solid, const Point& p, double hair) {
    return solid.winding_number(p) > 0.5 && (solid.nearest(p).point - p).norm() > hair;
}

/// Whether a side of s passes from one side of t to the other and is within t's solid on the way.
bool side_enters(const Corners& s, const Corners& t, const Point& normal, double hair,
                 const MeshDistance& solid_t) {
    constexpr double hairs_on = 100;
    const std::array<const Point*, 3> corner{&s.a, &s.b, &s.c};
    const std::array<const Point*, 3> around{&t.a, &t.b, &t.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const Point& p = *corner[i];
        const Point& q = *corner[(i + 1) % 3];
        const double of_p = normal.dot(p - t.a);
        const double of_q = normal.dot(q - t.a);
        if (std::min(of_p, of_q) >= -hair || std::max(of_p, of_q) <= hair) continue;
        const Point at = p + of_p / (of_p - of_q) * (q - p);
        bool pierces = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point& from = *around[k];
            const Point out = (*around[(k + 1) % 3] - from).cross(normal).normalized();
            pierces = pierces && out.dot(at - from) <= hair;
        }
        const Point on = hairs_on * hair * (q - p).normalized();
        if (pierces &&
            (is_well_within(solid_t, at + on, hair) || is_well_within(solid_t, at - on, hair)))
            return true;
    }
    return false;
}

/// Whether two triangles of parts a and b show that these share a space.
bool cross(const Corners& s, const Part& a, const Corners& t, const Part& b, double hair) {
    const Point normal_s = (s.b - s.a).cross(s.c - s.a).stableNormalized();
    const Point normal_t = (t.b - t.a).cross(t.c - t.a).stableNormalized();
    if (normal_s.isZero(0) || normal_t.isZero(0)) return false;
    const auto off_plane = [&](const Point& p) { return std::abs(normal_t.dot(p - t.a)); };
    if (std::max({off_plane(s.a), off_plane(s.b), off_plane(s.c)}) <= hair)
        return normal_s.dot(normal_t) > 0 && share_area(s, t, normal_t, hair);
    return side_enters(s, t, normal_t, hair, b.distance) ||
           side_enters(t, s, normal_s, hair, a.distance);
}

}  // namespace

bool surfaces_intersect(const TriangleTree& a, const Pose& pose_a, const TriangleTree& b,
                        const Pose& pose_b) {
    return any_meet(a, b, relative(pose_a, pose_b), triangles_intersect);
}

PartsMeet parts_meet(const Mesh& mesh, const Parts& parts, double hair) {
    // Each part's triangles in a tree of their own, so that a part never meets itself.
    std::vector<Part> all;
    std::vector<Box> boxes;
    for (const Mesh& part : split(mesh, parts)) {
        lod::check_interrupted();
        all.emplace_back(part);
        boxes.push_back(bounding_box(part));
    }
    lod::BoxTree<3> tree(boxes);
    PartsMeet worst = PartsMeet::apart;
    for (std::size_t i = 0; i < all.size(); ++i) {
        lod::check_interrupted();
        tree.each_meeting(boxes[i], [&](std::size_t j) {
            if (j <= i || worst == PartsMeet::crossing) return;
            if (!surfaces_intersect(all[i].tree, {}, all[j].tree, {})) return;
            const bool crossing =
                any_meet(all[i].tree, all[j].tree, {}, [&](const Corners& s, const Corners& t) {
                    return cross(s, all[i], t, all[j], hair);
                });
            worst = crossing ? PartsMeet::crossing : PartsMeet::touching;
        });
        if (worst == PartsMeet::crossing) break;
    }
    return worst;
}

}  // namespace lod3d
