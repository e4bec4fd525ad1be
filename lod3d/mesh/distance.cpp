#include "lodlab/lod3d/mesh/distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/lod3d/mesh/mesh_sides.hpp"

namespace lod3d {
namespace {

/// What of a triangle a nearest point lies on; the order of MeshDistance::Normals.
enum Feature : std::size_t { face, side_ab, side_bc, side_ca, corner_a, corner_b, corner_c };

struct OnTriangle {
    Point point;
    Feature feature;
};

/// The nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
OnTriangle nearest_on(const TriangleTree::Corners& t, const Point& p) {
    const Point ab = t.b - t.a;
    const Point ac = t.c - t.a;
    const Point ap = p - t.a;
    const double d1 = ab.dot(ap);
    const double d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return {t.a, corner_a};
    const Point bp = p - t.b;
    const double d3 = ab.dot(bp);
    const double d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return {t.b, corner_b};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {t.a + d1 / (d1 - d3) * ab, side_ab};
    const Point cp = p - t.c;
    const double d5 = ab.dot(cp);
    const double d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return {t.c, corner_c};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {t.a + d2 / (d2 - d6) * ac, side_ca};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) {
        const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {t.b + share * (t.c - t.b), side_bc};
    }
    const double scale = 1 / (va + vb + vc);
    return {t.a + (vb * scale) * ab + (vc * scale) * ac, face};
}

double angle_between(const Point& u, const Point& v) {
    return lod::direction_angle(u.cross(v).norm(), u.dot(v));
}

/// The sum of the solid angles of triangles seen from the origin (van Oosterom and Strackee 1983).
class SolidAngles {
  public:
    void add(const Point& a, const Point& b, const Point& c) {
        const double la = a.norm();
        const double lb = b.norm();
        const double lc = c.norm();
        const double y = a.dot(b.cross(c));
        const double x = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        if (!(std::abs(y) < small * x)) {  // so is 0 over 0, where a corner is the origin
            sum_ += 2 * lod::direction_angle(y, x);
            return;
        }
        // Small angles are added by turning one vector, and measured together.
        const double slope = y / x;
        turned_ = {turned_.x() - slope * turned_.y(), turned_.y() + slope * turned_.x()};
        if (++pending_ == most_pending) measure();
    }
    [[nodiscard]] double sum() {
        measure();
        return sum_;
    }

  private:
    static constexpr double small = 0.1;
    static constexpr int most_pending = 30;  ///< 30 x 0.1 is less than half a turn

    void measure() {
        sum_ += 2 * lod::direction_angle(turned_.y(), turned_.x());
        turned_ = {1, 0};
        pending_ = 0;
    }

    double sum_ = 0;
    lod::Vector<2> turned_{1, 0};
    int pending_ = 0;
};

/// For side k of triangle t, at 3 t + k: the sum of the unit normals of the triangles at that edge.
std::vector<Point> normals_of_sides(const Mesh& mesh, const std::vector<Point>& unit) {
    std::vector<Point> sums(3 * mesh.triangles.size());
    each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        Point sum = Point::Zero();
        for (auto side = first; side != last; ++side)
            sum += unit[static_cast<std::size_t>(side->triangle)];
        for (auto side = first; side != last; ++side)
            sums[3 * static_cast<std::size_t>(side->triangle) +
                 static_cast<std::size_t>(side->place)] = sum;
    });
    return sums;
}

}  // namespace

Point nearest_on_triangle(const TriangleTree::Corners& t, const Point& p) {
    return nearest_on(t, p).point;
}

MeshDistance::MeshDistance(const Mesh& mesh, InsideRule rule)
    : tree_(mesh), wide_(tree_), rule_(rule) {
    if (rule_ == InsideRule::nearest_normal) find_normals(mesh);
    find_dipoles();
}

void MeshDistance::find_normals(const Mesh& mesh) {
    std::vector<Point> unit(mesh.triangles.size());
    std::vector<Point> at_vertex(mesh.vertices.size(), Point::Zero());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Point a = mesh.corner(t, 0);
        unit[t] = (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).stableNormalized();
        for (int k = 0; k < 3; ++k) {
            const Point& here = mesh.corner(t, k);
            const Point to_next = mesh.corner(t, (k + 1) % 3) - here;
            const Point to_last = mesh.corner(t, (k + 2) % 3) - here;
            const auto vertex =
                static_cast<std::size_t>(mesh.triangles[t][static_cast<std::size_t>(k)]);
            at_vertex[vertex] += angle_between(to_next, to_last) * unit[t];
        }
    }
    const std::vector<Point> of_side = normals_of_sides(mesh, unit);
    normals_.resize(mesh.triangles.size());
    for (std::size_t i = 0; i < normals_.size(); ++i) {
        const auto t = static_cast<std::size_t>(tree_.triangle(static_cast<std::int32_t>(i)));
        normals_[i].of[face] = unit[t];
        for (std::size_t k = 0; k < 3; ++k) {
            normals_[i].of[side_ab + k] = of_side[3 * t + k];
            normals_[i].of[corner_a + k] =
                at_vertex[static_cast<std::size_t>(mesh.triangles[t][k])];
        }
    }
}

void MeshDistance::find_dipoles() {
    dipoles_.resize(static_cast<std::size_t>(tree_.node_count()));
    for (std::int32_t i = tree_.node_count() - 1; i >= 0; --i) {  // children come after parents
        const TriangleTree::Node& node = tree_.node(i);
        Dipole& dipole = dipoles_[static_cast<std::size_t>(i)];
        const auto add = [&](const Point& centre, const Point& area_normal, double area) {
            dipole.centre += area * centre;
            dipole.area_normal += area_normal;
            dipole.area += area;
        };
        for (std::int32_t t = node.first; t < node.first + node.count; ++t) {
            const TriangleTree::Corners& at = tree_.corners(t);
            const Point area_normal = 0.5 * (at.b - at.a).cross(at.c - at.a);
            add((at.a + at.b + at.c) / 3, area_normal, area_normal.norm());
        }
        if (!node.is_leaf())
            for (std::int32_t child : {i + 1, node.first}) {
                const Dipole& part = dipoles_[static_cast<std::size_t>(child)];
                add(part.centre, part.area_normal, part.area);
            }
        dipole.centre = dipole.area > 0 ? Point(dipole.centre / dipole.area)
                                        : Point(0.5 * (node.low + node.high));
        dipole.radius = (node.high - dipole.centre).cwiseMax(dipole.centre - node.low).norm();
    }
}

MeshDistance::Found MeshDistance::find(const Point& p, double within, double enough) const {
    struct Waiting {
        float squared;
        std::int32_t first;
        std::int32_t count;
    };
    std::array<Waiting, WideTree::width * TriangleTree::deepest> stack;
    std::size_t waiting = 0;
    Found found;
    found.squared = within * within;
    float least = wide_.squared(found.squared);
    const std::array<float, 3> place = wide_.place(p);
    stack[waiting++] = {0, 0, 0};
    while (waiting > 0) {
        const Waiting next = stack[--waiting];
        if (next.squared > least) continue;
        for (std::int32_t t = next.first; t < next.first + next.count; ++t) {
            const OnTriangle at = nearest_on(tree_.corners(t), p);
            const double squared = (p - at.point).squaredNorm();
            if (squared >= found.squared) continue;
            found = {at.point, squared, t, at.feature};
            if (squared <= enough) return found;
            least = wide_.squared(squared);
        }
        if (next.count > 0) continue;
        const WideTree::Node& node = wide_.node(next.first);
        const WideTree::Four squared = WideTree::squared_distances(node, place);
        const std::size_t bottom = waiting;  // the nearest on top
        for (std::size_t i = 0; i < WideTree::width; ++i) {
            const Waiting child{squared[i], node.first[i], node.count[i]};
            if (!(child.squared <= least)) continue;
            std::size_t at = waiting++;
            for (; at > bottom && stack[at - 1].squared < child.squared; --at)
                stack[at] = stack[at - 1];
            stack[at] = child;
        }
    }
    return found;
}

Nearest MeshDistance::nearest(const Point& p, double within) const {
    return result_of(find(p, within, 0));
}

Nearest MeshDistance::result_of(const Found& found) const {
    Nearest result;
    if (found.number < 0) return result;
    result.point = found.point;
    result.distance = std::sqrt(found.squared);
    result.triangle = tree_.triangle(found.number);
    if (!normals_.empty())
        result.normal = normals_[static_cast<std::size_t>(found.number)].of[found.feature];
    return result;
}

double MeshDistance::signed_distance(const Point& p) const {
    const Nearest at = nearest(p);
    return is_inside(p, at) ? -at.distance : at.distance;
}

double MeshDistance::signed_distance_below(const Point& p, double limit) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Found found = find(p, infinity, limit < 0 ? limit * limit : 0);
    if (limit < 0 && found.squared <= limit * limit) return infinity;
    const Nearest at = result_of(found);
    const double distance = is_inside(p, at) ? -at.distance : at.distance;
    return distance < limit ? distance : infinity;
}

double MeshDistance::distance_above(const Point& p, double floor) const {
    const Found found =
        find(p, std::numeric_limits<double>::infinity(), floor > 0 ? floor * floor : 0);
    const Nearest at = result_of(found);
    return at.distance <= floor || is_inside(p, at) ? 0 : at.distance;
}

double MeshDistance::winding_number(const Point& p) const {
    constexpr double far_enough = 2.3;  // times the radius of the group
    std::array<std::int32_t, TriangleTree::deepest> stack;
    std::size_t waiting = 0;
    double far = 0;
    SolidAngles near;
    stack[waiting++] = 0;
    while (waiting > 0) {
        const std::int32_t i = stack[--waiting];
        const TriangleTree::Node& node = tree_.node(i);
        const Dipole& dipole = dipoles_[static_cast<std::size_t>(i)];
        const Point arm = dipole.centre - p;
        const double squared = arm.squaredNorm();
        if (squared > far_enough * far_enough * dipole.radius * dipole.radius) {
            far += arm.dot(dipole.area_normal) / (squared * std::sqrt(squared));
            continue;
        }
        for (std::int32_t t = node.first; t < node.first + node.count; ++t) {
            const TriangleTree::Corners& at = tree_.corners(t);
            near.add(at.a - p, at.b - p, at.c - p);
        }
        if (node.is_leaf()) continue;
        stack[waiting++] = node.first;
        stack[waiting++] = i + 1;
    }
    return (far + near.sum()) / (4 * std::numbers::pi);
}

}  // namespace lod3d
