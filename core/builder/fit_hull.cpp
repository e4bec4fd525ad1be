#include "lodlab/core/builder/fit_hull.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "lodlab/core/math/box.hpp"
#include "lodlab/core/math/convex_cell.hpp"

namespace lod {
namespace {

// Shares of the points' extent. Each number was halved and doubled, the others kept, for the hulls
// of gear:9, star:9, ring and crescent (3,289 faces; errors of 60 impacts), and in space of box, L
// and ring (14,838 faces; 12 impacts) and knot, gear and blob:2 (9,223 faces). "Nothing" is not one
// face. What is searched for is so in space alone: in the plane all normals are known.

/// A face of the convex hull that cuts off less is rounding: nothing; 0 makes 4 to 6 % more faces
/// in space, slivers.
constexpr double least_cut = 1e-7;
/// A searched face that cuts off less is not worth having: .4 % more faces with half, .8 % fewer
/// with double, the same errors.
constexpr double least_search = 2e-3;
/// Corners nearer to each other are one: far above the rounding of a cut, far below what a contact
/// needs. .1 % of the faces; errors of levels 0 and 1 scatter (.093 .080, .104 .095, .097 .080).
constexpr double same_corner = 1e-10;
/// By so much the first box is wider, so that no sliver of it is left where faces end in its sides:
/// .1 % of the faces; 0 leaves 60 % more in the plane.
constexpr double box_spare = 1e-8;
/// Towards the nearest point of the convex hull: up to 1 % of the faces, more or fewer.
constexpr int search_steps = 24;
/// A step that gains less of the squared extent is rounding: nothing, also 1e-15.
constexpr double least_gain = 1e-12;
/// So far below the outermost corner others may make a face with it: up to .9 % of the faces, and
/// errors scatter.
constexpr double nearly_outermost = 0.02;
/// A normal shorter than this share of the squared extent is of corners in a line: nothing, also
/// 1e-12 and 1e-6.
constexpr double least_area = 1e-9;

template <int Dim>
class HullFit {
  public:
    HullFit(std::span<const Vector<Dim>> points, std::span<const Vector<Dim>> corners,
            double margin)
        : points_(points), corners_(corners), margin_(margin) {
        Box<Dim> box;
        for (const Vector<Dim>& p : points) box.hold(p);
        size_ = box.size().norm();
        margin_ += 2 * same_corner * size_;  // what making corners one may take away
        const Vector<Dim> spare = Vector<Dim>::Constant(margin_ + box_spare * size_);
        box_ = Box<Dim>(box.low - spare, box.high + spare);
    }

    /// With so many cuts at most.
    Hull<Dim> run(std::span<const Vector<Dim>> normals, int most_cuts) {
        most_cuts_ = most_cuts;
        cuts_ = 0;
        cell_ = ConvexCell<Dim>(box_);
        cut_along(normals);
        if constexpr (Space<Dim>::facets_close) cut_by_search();
        return hull();
    }

  private:
    [[nodiscard]] bool full() const { return cuts_ >= most_cuts_; }

    void cut(const Vector<Dim>& normal) {
        ++cuts_;
        cell_.clip({normal, support<Dim>(points_, normal) + margin_, true});
    }

    /// How far the cell stands out beyond all points.
    [[nodiscard]] double excess(const Vector<Dim>& normal, double reach) const {
        double most = -std::numeric_limits<double>::infinity();
        for (const auto& face : cell_.faces())
            most = std::max(most, support<Dim>(face.corners, normal));
        return most - reach - margin_;
    }

    void cut_along(std::span<const Vector<Dim>> normals) {
        std::vector<double> reach;
        for (const Vector<Dim>& normal : normals) reach.push_back(support<Dim>(corners_, normal));
        while (!full()) {
            std::size_t best = normals.size();
            double most = least_cut * size_;
            for (std::size_t i = 0; i < normals.size(); ++i) {
                const double out = excess(normals[i], reach[i]);
                if (out <= most) continue;
                most = out;
                best = i;
            }
            if (best == normals.size()) return;
            cut(normals[best]);
            reach[best] = std::numeric_limits<double>::infinity();  // once is enough
        }
    }

    /// A corner of the cell and how it may be cut off.
    struct Tip {
        Vector<Dim> corner;
        Vector<Dim> normal;
        double out = 0;  ///< what the cut takes away along the normal
    };

    /// Cuts off the corner of the cell that is farthest from the points' convex hull, again and
    /// again.
    void cut_by_search() {
        std::vector<Tip> tips;
        while (!full()) {
            std::vector<Tip> now;
            for (const Vector<Dim>& corner : cell_.corners()) {
                const auto same = [&](const Tip& tip) { return tip.corner == corner; };
                if (std::any_of(now.begin(), now.end(), same)) continue;
                const auto known = std::find_if(tips.begin(), tips.end(), same);
                now.push_back(known != tips.end() ? *known : tip_at(corner));
            }
            tips = std::move(now);
            const Tip& best = *std::max_element(
                tips.begin(), tips.end(), [](const Tip& x, const Tip& y) { return x.out < y.out; });
            if (best.out <= least_search * size_) return;
            cut(best.normal);
        }
    }

    [[nodiscard]] Tip tip_at(const Vector<Dim>& corner) const {
        const Vector<Dim> normal = away_from_hull(corner);
        return {corner, normal, normal.dot(corner) - support<Dim>(corners_, normal) - margin_};
    }

    /// About the direction from the nearest point of the convex hull to a point outside (Gilbert
    /// 1966); where that leads to a face of the hull, the face's normal.
    [[nodiscard]] Vector<Dim> away_from_hull(const Vector<Dim>& p) const {
        Vector<Dim> nearest = corners_.front();
        for (int step = 0; step < search_steps; ++step) {
            const Vector<Dim> away = p - nearest;
            const Vector<Dim> next = outermost(away);
            const Vector<Dim> along = next - nearest;
            const double gain = away.dot(along);
            if (!(gain > least_gain * size_ * size_)) break;
            nearest += std::min(1.0, gain / along.squaredNorm()) * along;
        }
        const Vector<Dim> direction = (p - nearest).normalized();
        const Vector<Dim> face = face_towards(direction);
        const auto out = [&](const Vector<Dim>& normal) {
            return normal.dot(p) - support<Dim>(corners_, normal);
        };
        return !face.isZero(0) && out(face) >= out(direction) ? face : direction;
    }

    [[nodiscard]] Vector<Dim> outermost(const Vector<Dim>& direction) const {
        return *std::max_element(corners_.begin(), corners_.end(),
                                 [&](const Vector<Dim>& p, const Vector<Dim>& q) {
                                     return direction.dot(p) < direction.dot(q);
                                 });
    }

    /// The normal of the facet through the Dim corners that lie outermost, the next ones looked for
    /// a little to the side of those before; zero where they make none.
    [[nodiscard]] Vector<Dim> face_towards(const Vector<Dim>& direction) const {
        std::array<Vector<Dim>, Dim> facet;
        facet[0] = outermost(direction);
        for (std::size_t i = 1; i < Dim; ++i) {
            // Of all that lie nearly as far out, the one farthest from those before.
            const double level = direction.dot(facet[0]) - nearly_outermost * size_;
            double most = 0;
            facet[i] = facet[0];
            for (const Vector<Dim>& p : corners_) {
                if (direction.dot(p) < level) continue;
                double far = (p - facet[0]).squaredNorm();
                if (i == 2)
                    far = (p - facet[0]).squaredNorm() * (facet[1] - facet[0]).squaredNorm() -
                          (p - facet[0]).dot(facet[1] - facet[0]) *
                              (p - facet[0]).dot(facet[1] - facet[0]);
                if (far <= most) continue;
                most = far;
                facet[i] = p;
            }
        }
        Vector<Dim> normal = Space<Dim>::facet_normal(facet);
        if (normal.norm() < least_area * size_ * size_) return Vector<Dim>::Zero();
        normal = normal.normalized();
        return normal.dot(direction) < 0 ? -normal : normal;
    }

    /// The cell's corners, each once, and its faces turned outwards.
    [[nodiscard]] Hull<Dim> hull() const {
        Hull<Dim> hull;
        const double near = same_corner * size_ * same_corner * size_;
        for (const auto& face : cell_.faces()) {
            std::vector<std::int32_t> loop;
            for (const Vector<Dim>& p : face.corners) {
                const auto same = std::find_if(
                    hull.corners.begin(), hull.corners.end(),
                    [&](const Vector<Dim>& q) { return (p - q).squaredNorm() <= near; });
                const auto number = static_cast<std::int32_t>(same - hull.corners.begin());
                if (same == hull.corners.end()) hull.corners.push_back(p);
                if (loop.empty() || (loop.back() != number && loop.front() != number))
                    loop.push_back(number);
            }
            if (static_cast<int>(loop.size()) < Dim) continue;
            if (Space<Dim>::area_vector(face.corners).dot(face.side.normal) < 0)
                std::reverse(loop.begin(), loop.end());
            hull.faces.push_back(std::move(loop));
        }
        return hull;
    }

    std::span<const Vector<Dim>> points_;
    std::span<const Vector<Dim>> corners_;
    double margin_;
    double size_ = 0;
    int most_cuts_ = 0;  ///< sides of the first box may be left besides
    int cuts_ = 0;
    Box<Dim> box_;
    ConvexCell<Dim> cell_;
};

}  // namespace

template <int Dim>
double support(std::span<const Vector<Dim>> points, const Vector<Dim>& normal) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Vector<Dim>& p : points) most = std::max(most, normal.dot(p));
    return most;
}

template <int Dim>
Hull<Dim> fit_hull(std::span<const Vector<Dim>> points, std::span<const Vector<Dim>> corners,
                   std::span<const Vector<Dim>> normals, double margin) {
    HullFit<Dim> fit(points, corners, margin);
    // Where sides of the first box are left, or rounding leaves corners that hardly differ, fewer
    // cuts make a sound hull; none leaves the box.
    int cuts = most_hull_faces<Dim>;
    for (;; --cuts) {
        Hull<Dim> hull = fit.run(normals, cuts);
        NodeHulls<Dim> one;
        one.add(hull);
        const bool few = static_cast<int>(hull.corners.size()) <= most_hull_corners<Dim> &&
                         static_cast<int>(hull.faces.size()) <= most_hull_faces<Dim>;
        if ((few && one.of(0).is_closed()) || cuts == 0) return hull;
    }
}

#define LOD_INSTANTIATE(Dim)                                                                     \
    template double support<Dim>(std::span<const Vector<Dim>>, const Vector<Dim>&);              \
    template Hull<Dim> fit_hull<Dim>(std::span<const Vector<Dim>>, std::span<const Vector<Dim>>, \
                                     std::span<const Vector<Dim>>, double);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
