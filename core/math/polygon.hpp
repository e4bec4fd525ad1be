#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "lodlab/core/math/half_space.hpp"

namespace lod {

/// Corners of the convex hull in the plane, anticlockwise from the leftmost (Andrew's monotone
/// chains); all different points where they are fewer than three. `at(point)` says where one lies.
template <class T, class At>
[[nodiscard]] std::vector<T> convex_hull(std::vector<T> points, const At& at) {
    std::sort(points.begin(), points.end(), [&](const T& p, const T& q) {
        const Vector<2> a = at(p);
        const Vector<2> b = at(q);
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    const auto same = [&](const T& p, const T& q) { return at(p) == at(q); };
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    if (points.size() < 3) return points;
    std::vector<T> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t begin = hull.size();
        for (const T& p : points) {
            const auto turns_left = [&] {
                const Vector<2> corner = at(hull[hull.size() - 2]);
                const Vector<2> u = at(hull.back()) - corner;
                const Vector<2> v = at(p) - corner;
                return u.x() * v.y() - u.y() * v.x() > 0;
            };
            while (hull.size() >= begin + 2 && !turns_left()) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // the other side begins with it
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// Cuts a chain of corners by a half-space (Sutherland and Hodgman): calls keep(point) for every
/// corner within and every cut, in order. side(point) is negative inside, 0 on the border.
/// `closed`: the last corner is joined to the first. A cut stands between the two corners of the
/// cut side, so that it strays from neither.
template <int Dim, class Side, class Keep>
void clip_corners(std::span<const Vector<Dim>> corners, bool closed, const Side& side,
                  const Keep& keep) {
    if (corners.empty()) return;
    const Vector<Dim>* from = closed ? &corners.back() : &corners.front();
    double side_from = side(*from);
    for (const Vector<Dim>& to : corners) {
        const double side_to = side(to);
        if ((side_from < 0 && side_to > 0) || (side_from > 0 && side_to < 0))
            keep(*from + (side_from / (side_from - side_to)) * (to - *from));
        if (side_to <= 0) keep(to);
        from = &to;
        side_from = side_to;
    }
}

/// Cuts polygons by the half-spaces of a cell, one after the other.
template <int Dim>
class PolygonClipper {
  public:
    explicit PolygonClipper(std::span<const HalfSpace<Dim>> cell) : cell_(cell) {}

    /// Appends what of the polygon lies in the cell, nothing where that has fewer than three
    /// corners; returns how many it has.
    std::size_t clip(std::span<const Vector<Dim>> polygon, std::vector<Vector<Dim>>& out) {
        if (!find_cutting(polygon)) return 0;
        std::span<const Vector<Dim>> rest = polygon;
        for (std::size_t i = 0; i + 1 < cutting_.size(); ++i) {
            std::vector<Vector<Dim>>& next = i % 2 == 0 ? even_ : odd_;
            next.clear();
            if (cut(rest, *cutting_[i], next) == 0) return 0;
            rest = next;
        }
        if (!cutting_.empty()) return cut(rest, *cutting_.back(), out);
        out.insert(out.end(), rest.begin(), rest.end());
        return rest.size();
    }

  private:
    /// Those half-spaces that leave some of the polygon out; false where one leaves out all of it.
    bool find_cutting(std::span<const Vector<Dim>> polygon) {
        cutting_.clear();
        for (const HalfSpace<Dim>& side : cell_) {
            bool inside = false;
            bool outside = false;
            for (const Vector<Dim>& p : polygon) {
                const double at = side.side(p);
                inside |= at < 0;
                outside |= at > 0;
            }
            if (!inside && (outside || !side.keeps_border)) return false;
            if (outside) cutting_.push_back(&side);
        }
        return true;
    }

    static std::size_t cut(std::span<const Vector<Dim>> polygon, const HalfSpace<Dim>& keep,
                           std::vector<Vector<Dim>>& out) {
        const std::size_t before = out.size();
        clip_corners<Dim>(
            polygon, true, [&](const Vector<Dim>& p) { return keep.side(p); },
            [&](const Vector<Dim>& p) { out.push_back(p); });
        if (out.size() - before < 3) out.resize(before);
        return out.size() - before;
    }

    std::span<const HalfSpace<Dim>> cell_;
    std::vector<const HalfSpace<Dim>*> cutting_;
    std::vector<Vector<Dim>> even_;
    std::vector<Vector<Dim>> odd_;
};

}  // namespace lod
