#include "lodlab/lod3d/builder/piece.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/math/polygon.hpp"
#include "lodlab/core/math/enclosing_ball.hpp"
#include "lodlab/lod3d/builder/directions.hpp"

namespace lod3d {
namespace {

/// Area times unit normal of a flat polygon.
Point area_vector(std::span<const Point> polygon) {
    return 0.5 * lod::Space<3>::area_vector(polygon);
}

}  // namespace

MeshPiece::MeshPiece(const Solid& solid, const MeshDistance& inside)
    : inside_(&inside), measure_(solid.volume) {
    points_.reserve(3 * solid.mesh.triangles.size());
    polygon_end_.reserve(solid.mesh.triangles.size());
    for (std::size_t t = 0; t < solid.mesh.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) points_.push_back(solid.mesh.corner(t, k));
        polygon_end_.push_back(static_cast<std::int32_t>(points_.size()));
    }
    Box box = bounding_box(solid.mesh);
    const Point room = Point::Constant(0.01 * (box.high - box.low).norm());
    box.low -= room;
    box.high += room;
    cell_ = lod::ConvexCell<3>(box);
}

Box MeshPiece::bounds() const {
    Box box;
    for (const Point& p : points_) box.hold(p);
    return box;
}

MeshPiece MeshPiece::within(std::span<const lod::HalfSpace<3>> cell) const {
    MeshPiece part;
    part.inside_ = inside_;
    part.cell_ = cell_;
    for (const lod::HalfSpace<3>& side : cell) part.cell_.clip(side);
    if (part.cell_.empty() && !cell_.empty()) return part;
    lod::PolygonClipper<3> clipper(cell);
    each_polygon([&](std::span<const Point> polygon) {
        if (clipper.clip(polygon, part.points_) > 0)
            part.polygon_end_.push_back(static_cast<std::int32_t>(part.points_.size()));
    });
    part.add_inner_corners();
    if (!part.points_.empty()) part.measure_ = std::min(part.cell_.measure(), measure_);
    return part;
}

void MeshPiece::add_inner_corners() {
    std::vector<Point> corners = cell_.corners();
    std::sort(corners.begin(), corners.end(), [](const Point& p, const Point& q) {
        return std::tie(p.x(), p.y(), p.z()) < std::tie(q.x(), q.y(), q.z());
    });
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const Point& p : corners)
        if (inside_->inside(p)) points_.push_back(p);
}

double MeshPiece::surface_measure() const {
    double area = 0;
    each_polygon([&](std::span<const Point> polygon) { area += area_vector(polygon).norm(); });
    return area;
}

Point MeshPiece::surface_normal() const {
    Point sum = Point::Zero();
    each_polygon([&](std::span<const Point> polygon) { sum += area_vector(polygon); });
    return sum;
}

std::pair<MeshPiece, double> MeshPiece::held_by(const lod::Sphere<3>& ball) const {
    if (lod::farthest_distance<3>(ball.centre, vertices()) <= ball.radius) return {*this, 0.0};
    const double half = ball.radius / std::sqrt(3.0);
    if (!(half > 0)) return {MeshPiece(), measure_};
    std::vector<lod::HalfSpace<3>> cube;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0})
            cube.push_back({sign * Point::Unit(axis), sign * ball.centre[axis] + half, true});
    MeshPiece held = within(cube);
    const double rest = cell_.measure() - held.cell_.measure();
    return {std::move(held), std::clamp(rest, 0.0, measure_)};
}

namespace {

constexpr std::size_t most_known_normals = 64;
constexpr int search_directions = 128;

void add_normal(const Point& normal, std::vector<Point>& normals) {
    if (normals.size() > most_known_normals || normal.isZero(0)) return;
    const Point unit = normal.normalized();
    for (const Point& known : normals)
        if ((known - unit).squaredNorm() <= 1e-12) return;
    normals.push_back(unit);
}

}  // namespace

lod::HullHints<3> MeshPiece::hull_hints() const {
    lod::HullHints<3> hints;
    each_polygon(
        [&](std::span<const Point> polygon) { add_normal(area_vector(polygon), hints.normals); });
    for (const auto& face : cell_.faces()) add_normal(face.side.normal, hints.normals);
    if (hints.normals.size() > most_known_normals) hints.normals.clear();
    static const std::vector<Point> directions = spread_directions(search_directions);
    for (const Point& direction : directions) {
        const Point& p = *std::max_element(
            points_.begin(), points_.end(),
            [&](const Point& q, const Point& r) { return direction.dot(q) < direction.dot(r); });
        if (std::find(hints.corners.begin(), hints.corners.end(), p) == hints.corners.end())
            hints.corners.push_back(p);
    }
    return hints;
}

}  // namespace lod3d
