#include "lodlab/lod3d/convex_cell.hpp"

#include <algorithm>
#include <cmath>

namespace lod3d {

std::size_t clip_polygon(std::span<const Point> polygon, const lod::HalfSpace<3>& side,
                         std::vector<Point>& out) {
    const std::size_t before = out.size();
    if (polygon.empty()) return 0;
    const Point* from = &polygon.back();
    double side_from = side.side(*from);
    for (const Point& to : polygon) {
        const double side_to = side.side(to);
        if ((side_from < 0 && side_to > 0) || (side_from > 0 && side_to < 0))
            out.push_back(*from + (side_from / (side_from - side_to)) * (to - *from));
        if (side_to <= 0) out.push_back(to);
        from = &to;
        side_from = side_to;
    }
    if (out.size() - before < 3) out.resize(before);
    return out.size() - before;
}

ConvexCell::ConvexCell(const Box& box) : box_(box) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            Face face;
            face.side.normal = sign * Point::Unit(axis);
            face.side.offset = sign > 0 ? box.high[axis] : -box.low[axis];
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            Point corner = sign > 0 ? box.high : box.low;
            for (const auto& [at_u, at_v] :
                 {std::pair(box.low[u], box.low[v]), std::pair(box.high[u], box.low[v]),
                  std::pair(box.high[u], box.high[v]), std::pair(box.low[u], box.high[v])}) {
                corner[u] = at_u;
                corner[v] = at_v;
                face.corners.push_back(corner);
            }
            faces_.push_back(face);
        }
}

std::vector<Point> ConvexCell::section(const lod::HalfSpace<3>& side) const {
    const Point middle = 0.5 * (box_.low + box_.high);
    const Point normal = side.normal.stableNormalized();
    const double reach = 2 * (box_.high - box_.low).norm();
    const Point foot = middle - (side.side(middle) / side.normal.norm()) * normal;
    const Point u = normal.unitOrthogonal();
    const Point v = normal.cross(u);
    std::vector<Point> polygon{foot - reach * u - reach * v, foot + reach * u - reach * v,
                               foot + reach * u + reach * v, foot - reach * u + reach * v};
    std::vector<Point> clipped;
    for (const Face& face : faces_) {
        clipped.clear();
        clip_polygon(polygon, face.side, clipped);
        polygon.swap(clipped);
        if (polygon.empty()) break;
    }
    return polygon;
}

void ConvexCell::clip(const lod::HalfSpace<3>& side) {
    bool some_outside = false;
    bool some_inside = false;
    for (const Face& face : faces_)
        for (const Point& p : face.corners) (side.side(p) > 0 ? some_outside : some_inside) = true;
    if (!some_outside) return;
    if (!some_inside) return faces_.clear();
    Face fresh{side, section(side)};
    std::vector<Point> clipped;
    std::size_t kept = 0;
    for (Face& face : faces_) {
        clipped.clear();
        if (clip_polygon(face.corners, side, clipped) == 0) continue;
        face.corners.assign(clipped.begin(), clipped.end());
        if (&faces_[kept] != &face) faces_[kept] = std::move(face);
        ++kept;
    }
    faces_.resize(kept);
    if (!fresh.corners.empty()) faces_.push_back(std::move(fresh));
}

bool ConvexCell::holds(const Point& p) const {
    return !faces_.empty() && std::all_of(faces_.begin(), faces_.end(),
                                          [&](const Face& face) { return face.side.side(p) <= 0; });
}

std::vector<Point> ConvexCell::corners() const {
    std::vector<Point> all;
    for (const Face& face : faces_) all.insert(all.end(), face.corners.begin(), face.corners.end());
    return all;
}

double ConvexCell::volume() const {
    if (faces_.empty()) return 0;
    const Point origin = faces_.front().corners.front();
    double volume = 0;  // cones from the origin over the faces, whatever way they are turned
    for (const Face& face : faces_) {
        Point area = Point::Zero();
        for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
            area +=
                (face.corners[i] - face.corners[0]).cross(face.corners[i + 1] - face.corners[0]);
        volume += std::abs(area.dot(face.corners[0] - origin)) / 6;
    }
    return volume;
}

}  // namespace lod3d
