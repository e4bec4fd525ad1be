#include "lodlab/core/hull_contact.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "lodlab/core/clip.hpp"

namespace lod {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A face along which two hulls overlap.
template <int Dim>
struct Axis {
    std::size_t face = 0;
    bool of_b = false;
    bool inner = true;       ///< nothing can touch the shape there
    double measure = never;  ///< what decides: the depth, or the time since the face was crossed

    [[nodiscard]] bool before(const Axis& other) const {
        return inner != other.inner ? other.inner : measure < other.measure;
    }
};

/// The least overlap, and the latest.
template <int Dim>
struct Axes {
    Axis<Dim> shallow;
    Axis<Dim> recent;

    [[nodiscard]] const Axis<Dim>& best() const {
        const bool known = recent.measure < never && recent.inner == shallow.inner;
        return known ? recent : shallow;
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

/// Looks at the faces of one hull. Returns false where one of them separates.
template <int Dim>
bool look(const PosedHull<Dim>& own, const PosedHull<Dim>& other, bool of_b,
          const PairMotion<Dim>& motion, double slack, Axes<Dim>& axes) {
    for (std::size_t face = 0; face < own.body.normals.size(); ++face) {
        const Vector<Dim>& normal = own.normals[face];
        const Vector<Dim>& corner = other.corners[lowest(other, normal)];
        const double depth = own.offsets[face] - normal.dot(corner);
        if (depth < -slack) return false;
        Axis<Dim> axis{face, of_b, own.body.inner[face] != 0, depth};
        if (axis.before(axes.shallow)) axes.shallow = axis;
        const double speed = (of_b ? 1 : -1) * normal.dot(motion.velocity_b - motion.velocity_a);
        if (speed <= 0 || depth > speed * motion.time_step) continue;
        axis.measure = depth / speed;
        if (axis.before(axes.recent)) axes.recent = axis;
    }
    return true;
}

/// A facet, with room for what clipping adds.
template <int Dim>
struct Facet {
    std::array<Vector<Dim>, 2 * most_hull_corners<Dim>> corners;
    std::size_t count = 0;

    Facet(const PosedHull<Dim>& hull, std::size_t face) {
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
    if (!look(a, b, false, motion, slack, axes) || !look(b, a, true, motion, slack, axes))
        return std::nullopt;
    const Axis<Dim>& axis = axes.best();
    const PosedHull<Dim>& own = axis.of_b ? b : a;
    const PosedHull<Dim>& other = axis.of_b ? a : b;
    const Vector<Dim>& normal = own.normals[axis.face];
    const double offset = own.offsets[axis.face];
    const Facet<Dim> face(own, axis.face);
    Facet<Dim> facet(other, facing(other, normal));
    for (std::size_t i = 0; i < face.count; ++i) {
        const Vector<Dim>& to = face.corners[(i + 1) % face.count];
        const Vector<Dim> side = Space<Dim>::side_normal(to - face.corners[i], normal);
        facet.clip(side, side.dot(to));
    }
    facet.keep_few(normal, offset);
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
