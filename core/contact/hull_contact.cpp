#include "lodlab/core/contact/hull_contact.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "lodlab/core/math/polygon.hpp"

namespace lod {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A face along which two hulls overlap.
template <int Dim>
struct Axis {
    std::size_t face = 0;
    bool of_b = false;
    bool inner = true;       ///< nothing can touch the shape there
    double measure = never;  ///< what decides: the depth, or the time since it was crossed
    const HullEdge* edge_a = nullptr;  ///< two edges that cross, instead of a face
    const HullEdge* edge_b = nullptr;
    Vector<Dim> normal = Vector<Dim>::Zero();  ///< from A to B; of edges

    /// Whether one that is inner or not, and of that measure, comes before it.
    [[nodiscard]] bool yields_to(bool other_inner, double other_measure) const {
        return inner != other_inner ? inner : other_measure < measure;
    }
};

/// By how much two hulls overlap along an axis, and for how long.
struct Overlap {
    double depth = 0;
    double since = 0;     ///< [s]; where it is recent
    bool recent = false;  ///< it began within the last time step

    Overlap(double overlap, double speed, double time_step) : depth(overlap) {
        if (speed <= 0 || overlap > speed * time_step) return;
        since = overlap / speed;
        recent = true;
    }
};

/// A piece's surface goes on beyond a cut: its corners there touch only along normals of about the
/// surface that they lie on, by this cosine at least. Otherwise the next piece is what is touched.
constexpr double along_surface = 0.95;
/// Unless a piece is more than this share of its own height below the other's face: it is within.
constexpr double sunk = 0.5;

/// Whether a corner cannot touch along `normal`, outwards, since only cutting made it.
template <int Dim>
bool is_cut(const PosedHull<Dim>& hull, std::size_t corner, const Vector<Dim>& normal) {
    if (hull.body.cut[corner] == 0) return false;
    double along = -1;
    for (std::size_t face = 0; face < hull.body.normals.size(); ++face) {
        if (hull.body.inner[face] != 0) continue;
        const auto loop = hull.body.loop(face);
        if (std::find(loop.begin(), loop.end(), static_cast<std::int32_t>(corner)) != loop.end())
            along = std::max(along, normal.dot(hull.normals[face]));
    }
    return along < along_surface;
}

/// How far a hull extends along a direction.
template <int Dim>
double height_along(const PosedHull<Dim>& hull, const Vector<Dim>& normal) {
    double low = never;
    double high = -never;
    for (std::size_t i = 0; i < hull.body.corners.size(); ++i) {
        low = std::min(low, normal.dot(hull.corners[i]));
        high = std::max(high, normal.dot(hull.corners[i]));
    }
    return high - low;
}

/// The least overlap, and the latest.
template <int Dim>
struct Axes {
    Axis<Dim> shallow;
    Axis<Dim> recent;

    [[nodiscard]] const Axis<Dim>& best() const {
        const bool known = recent.measure < never && recent.inner == shallow.inner;
        return known ? recent : shallow;
    }
    /// Whether an axis would become one of the two.
    [[nodiscard]] bool take(bool inner, const Overlap& overlap) const {
        return shallow.yields_to(inner, overlap.depth) ||
               (overlap.recent && recent.yields_to(inner, overlap.since));
    }
    /// Takes an axis into account; `gain`: what its depth is divided by (edge_gain).
    void consider(Axis<Dim> axis, const Overlap& overlap, double gain = 1) {
        axis.measure = overlap.depth / gain;
        if (shallow.yields_to(axis.inner, axis.measure)) shallow = axis;
        axis.measure = overlap.since;
        if (overlap.recent && recent.yields_to(axis.inner, axis.measure)) recent = axis;
    }
};

/// The corner that lies lowest along the normal.
template <int Dim>
std::size_t lowest(const PosedHull<Dim>& hull, const Vector<Dim>& normal) {
    std::size_t at = 0;
    double least = normal.dot(hull.corners[0]);
    for (std::size_t i = 1; i < hull.body.corners.size(); ++i) {
        const double height = normal.dot(hull.corners[i]);
        if (height < least) {
            least = height;
            at = i;
        }
    }
    return at;
}

/// Edges whose crossing is less than this sine are as good as parallel: their faces decide.
constexpr double least_crossing = 1e-3;
/// What an edge pair must gain over a face in depth, as a share: where they say nearly the same,
/// the face is right, for it has more than one point.
constexpr double edge_gain = 0.95;

/// A hull whose faces are looked at, and the one that they may separate it from.
template <int Dim>
struct Faces {
    const PosedHull<Dim>& own;
    const PosedHull<Dim>& other;
    bool of_b = false;
};

/// Looks at the faces of one hull. Returns false where one of them separates.
template <int Dim>
bool look(const Faces<Dim>& faces, const PairMotion<Dim>& motion, double slack, Axes<Dim>& axes) {
    const auto& [own, other, of_b] = faces;
    if (other.body.corners.empty()) return true;  // a half-space has no end along any face
    for (std::size_t face = 0; face < own.body.normals.size(); ++face) {
        const Vector<Dim>& normal = own.normals[face];
        const std::size_t corner = lowest(other, normal);
        const double depth = own.offsets[face] - normal.dot(other.corners[corner]);
        if (depth < -slack) return false;
        const double speed = (of_b ? 1 : -1) * normal.dot(motion.velocity_b - motion.velocity_a);
        const Overlap overlap(depth, speed, motion.time_step);
        Axis<Dim> axis;
        axis.face = face;
        axis.of_b = of_b;
        axis.inner = own.body.inner[face] != 0;
        if (!axes.take(axis.inner, overlap)) continue;  // nor would it as an inner one
        axis.inner = axis.inner || (is_cut(other, corner, Vector<Dim>(-normal)) &&
                                    depth < sunk * height_along(other, normal));
        axes.consider(axis, overlap);
    }
    return true;
}

/// Whether A lies below B along the normal, by more than the slack. Where faces are nearly
/// parallel, rounding can take an edge for what it is not; this is the proof.
template <int Dim>
bool separates(const PosedHull<Dim>& a, const PosedHull<Dim>& b, const Vector<Dim>& normal,
               double slack) {
    const Vector<Dim>& top = a.corners[lowest(a, Vector<Dim>(-normal))];
    const Vector<Dim>& bottom = b.corners[lowest(b, normal)];
    return normal.dot(bottom - top) > slack;
}

template <int Dim>
const Vector<Dim>& corner(const PosedHull<Dim>& hull, std::int32_t number) {
    return hull.corners[static_cast<std::size_t>(number)];
}

/// Whether an edge is one that only cuts made, or turns away from the surface there (see is_cut).
template <int Dim>
bool is_inner(const PosedHull<Dim>& hull, const HullEdge& edge, const Vector<Dim>& outwards) {
    const auto left = static_cast<std::size_t>(edge.left);
    const auto right = static_cast<std::size_t>(edge.right);
    const bool cut_left = hull.body.inner[left] != 0;
    const bool cut_right = hull.body.inner[right] != 0;
    if (cut_left && cut_right) return true;
    if (hull.body.cut[static_cast<std::size_t>(edge.from)] == 0 ||
        hull.body.cut[static_cast<std::size_t>(edge.to)] == 0)
        return false;
    return cut_left != cut_right &&
           outwards.dot(hull.normals[cut_left ? right : left]) < along_surface;
}

/// Looks at the pairs of edges whose crossing may be where the hulls are nearest to each other:
/// those whose arcs cross on the Gauss map, A's between its two faces' normals and B's, reversed.
/// Returns false where one separates.
template <int Dim>
bool look_at_edges(const PosedHull<Dim>& a, const PosedHull<Dim>& b, const PairMotion<Dim>& motion,
                   double slack, Axes<Dim>& axes) {
    for (const HullEdge& edge_a : a.body.edges) {
        const Vector<Dim>& n1 = a.normals[static_cast<std::size_t>(edge_a.left)];
        const Vector<Dim>& n2 = a.normals[static_cast<std::size_t>(edge_a.right)];
        const Vector<Dim> along_a = corner(a, edge_a.to) - corner(a, edge_a.from);
        for (const HullEdge& edge_b : b.body.edges) {
            const Vector<Dim> m1 = -b.normals[static_cast<std::size_t>(edge_b.left)];
            const Vector<Dim> m2 = -b.normals[static_cast<std::size_t>(edge_b.right)];
            const Vector<Dim> along_b = corner(b, edge_b.to) - corner(b, edge_b.from);
            // The arcs' planes are across the edges.
            const double side_m1 = m1.dot(along_a);
            const double side_m2 = m2.dot(along_a);
            const double side_n1 = n1.dot(along_b);
            const double side_n2 = n2.dot(along_b);
            if (side_m1 * side_m2 >= 0 || side_n1 * side_n2 >= 0) continue;
            const Vector<Dim> across = along_a.cross(along_b);
            const double length = across.norm();
            if (length <= least_crossing * along_a.norm() * along_b.norm()) continue;
            Vector<Dim> normal = across / length;
            // Both arcs hold the normal, not its opposite.
            if (normal.dot(n1 + n2) < 0) normal = -normal;
            if (normal.dot(m1 + m2) <= 0) continue;
            const double depth = normal.dot(corner(a, edge_a.from) - corner(b, edge_b.from));
            if (depth < -slack) {
                if (separates(a, b, normal, slack)) return false;
                continue;
            }
            Axis<Dim> axis;
            axis.inner = is_inner(a, edge_a, normal) || is_inner(b, edge_b, Vector<Dim>(-normal));
            axis.edge_a = &edge_a;
            axis.edge_b = &edge_b;
            axis.normal = normal;
            const double speed = -normal.dot(motion.velocity_b - motion.velocity_a);
            axes.consider(axis, Overlap(depth, speed, motion.time_step), edge_gain);
        }
    }
    return true;
}

/// Where two edges are nearest to each other.
template <int Dim>
Manifold<Dim> crossing(const PosedHull<Dim>& a, const PosedHull<Dim>& b, const Axis<Dim>& axis) {
    const Vector<Dim>& p = a.corners[static_cast<std::size_t>(axis.edge_a->from)];
    const Vector<Dim>& q = b.corners[static_cast<std::size_t>(axis.edge_b->from)];
    const Vector<Dim> u = a.corners[static_cast<std::size_t>(axis.edge_a->to)] - p;
    const Vector<Dim> v = b.corners[static_cast<std::size_t>(axis.edge_b->to)] - q;
    const double uu = u.dot(u);
    const double uv = u.dot(v);
    const double vv = v.dot(v);
    const double across = uu * vv - uv * uv;
    const Vector<Dim> between = q - p;
    const double s = (vv * u.dot(between) - uv * v.dot(between)) / across;
    const double t = (uv * u.dot(between) - uu * v.dot(between)) / across;
    Manifold<Dim> manifold;
    manifold.normal = axis.normal;
    manifold.points[0] = 0.5 * ((p + s * u) + (q + t * v));
    manifold.depths[0] = std::max(0.0, axis.normal.dot(p - q));
    manifold.count = 1;
    return manifold;
}

/// A facet, with room for what clipping adds.
template <int Dim>
struct ContactFace {
    std::array<Vector<Dim>, 2 * most_hull_corners<Dim>> corners;
    std::size_t count = 0;

    ContactFace(const PosedHull<Dim>& hull, std::size_t face) {
        for (const std::int32_t corner : hull.body.loop(face))
            corners[count++] = hull.corners[static_cast<std::size_t>(corner)];
    }

    /// What of it lies where normal . x <= offset.
    void clip(const Vector<Dim>& normal, double offset) {
        const std::array<Vector<Dim>, 2 * most_hull_corners<Dim>> before = corners;
        const std::size_t end = std::exchange(count, 0);
        clip_corners<Dim>(
            std::span(before).first(end), Space<Dim>::facets_close,
            [&](const Vector<Dim>& p) { return normal.dot(p) - offset; },
            [&](const Vector<Dim>& p) { corners[count++] = p; });
    }

    /// Keeps the corners below the plane of a face, and of those few: the farthest from their
    /// middle, the farthest from it, and the farthest to either side of these two.
    void keep_few(const Vector<Dim>& normal, double offset) {
        std::size_t below = 0;
        Vector<Dim> middle = Vector<Dim>::Zero();
        for (std::size_t i = 0; i < count; ++i) {
            if (normal.dot(corners[i]) > offset) continue;
            middle += corners[i];
            corners[below++] = corners[i];
        }
        count = below;
        if (count <= Manifold<Dim>::most_points) return;
        middle /= static_cast<double>(count);
        const auto farthest = [&](std::size_t from, const auto& measure) {
            std::size_t best = from;
            for (std::size_t i = from + 1; i < count; ++i)
                if (measure(corners[i]) > measure(corners[best])) best = i;
            std::swap(corners[from], corners[best]);
        };
        farthest(0, [&](const Vector<Dim>& p) { return (p - middle).squaredNorm(); });
        farthest(1, [&](const Vector<Dim>& p) { return (p - corners[0]).squaredNorm(); });
        const Vector<Dim> across = Space<Dim>::side_normal(corners[1] - corners[0], normal);
        for (std::size_t k = 2; k < Manifold<Dim>::most_points; ++k) {
            const double sign = k == 2 ? 1 : -1;
            farthest(k, [&](const Vector<Dim>& p) { return sign * across.dot(p - corners[0]); });
        }
        count = Manifold<Dim>::most_points;
    }
};

/// The facet of the hull that faces the normal most.
template <int Dim>
std::size_t facing(const PosedHull<Dim>& hull, const Vector<Dim>& normal) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < hull.body.normals.size(); ++i)
        if (hull.normals[i].dot(normal) < hull.normals[best].dot(normal)) best = i;
    return best;
}

}  // namespace

template <int Dim>
void PosedHull<Dim>::pose(const HullView<Dim>& hull, const Matrix<Dim>& rotation,
                          const Vector<Dim>& position) {
    body = hull;
    for (std::size_t i = 0; i < hull.corners.size(); ++i)
        corners[i] = rotation * hull.corners[i] + position;
    for (std::size_t i = 0; i < hull.normals.size(); ++i) {
        normals[i] = rotation * hull.normals[i];
        offsets[i] = hull.offsets[i] + normals[i].dot(position);
    }
}

template <int Dim>
double Manifold<Dim>::depth() const {
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) most = std::max(most, depths[i]);
    return most;
}

template <int Dim>
bool Manifold<Dim>::parts(const PairMotion<Dim>& motion) const {
    for (std::size_t i = 0; i < count; ++i)
        if (normal.dot(motion.at(points[i])) <= 0) return false;
    return true;
}

template <int Dim>
std::optional<Manifold<Dim>> meet(const PosedHull<Dim>& a, const PosedHull<Dim>& b,
                                  const PairMotion<Dim>& motion, double slack) {
    Axes<Dim> axes;
    if (!look<Dim>({a, b, false}, motion, slack, axes) ||
        !look<Dim>({b, a, true}, motion, slack, axes))
        return std::nullopt;
    if constexpr (Space<Dim>::facets_close)
        if (!look_at_edges(a, b, motion, slack, axes)) return std::nullopt;
    const Axis<Dim>& axis = axes.best();
    if (axis.edge_a != nullptr) return crossing(a, b, axis);
    const PosedHull<Dim>& own = axis.of_b ? b : a;
    const PosedHull<Dim>& other = axis.of_b ? a : b;
    const Vector<Dim>& normal = own.normals[axis.face];
    const double offset = own.offsets[axis.face];
    const ContactFace<Dim> face(own, axis.face);
    ContactFace<Dim> facet(other, facing(other, normal));
    for (std::size_t i = 0; i < face.count; ++i) {
        const Vector<Dim>& to = face.corners[(i + 1) % face.count];
        const Vector<Dim> side = Space<Dim>::side_normal(to - face.corners[i], normal);
        facet.clip(side, side.dot(to));
    }
    facet.keep_few(normal, offset + slack);  // what just touches lies above it by rounding
    if (facet.count == 0) facet.corners[facet.count++] = other.corners[lowest(other, normal)];
    Manifold<Dim> manifold;
    manifold.normal = axis.of_b ? -normal : normal;
    manifold.count = facet.count;
    for (std::size_t i = 0; i < facet.count; ++i) {
        const double depth = offset - normal.dot(facet.corners[i]);
        manifold.points[i] = facet.corners[i] + 0.5 * depth * normal;
        manifold.depths[i] = std::max(0.0, depth);
    }
    return manifold;
}

#define LOD_INSTANTIATE(Dim)                                                                 \
    template struct PosedHull<Dim>;                                                          \
    template struct Manifold<Dim>;                                                           \
    template std::optional<Manifold<Dim>> meet(const PosedHull<Dim>&, const PosedHull<Dim>&, \
                                               const PairMotion<Dim>&, double);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
