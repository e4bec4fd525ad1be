#include "lodlab/lod2d/builder/piece.hpp"

#include <algorithm>

#include "lodlab/core/builder/piece.hpp"
#include "lodlab/core/math/polygon.hpp"
#include "lodlab/lod2d/shape/convex_hull.hpp"

namespace lod2d {
namespace {

using HalfPlane = lod::HalfSpace<2>;
using Corners = std::vector<Point>;

static_assert(lod::PieceOf<PolygonPiece, 2>);

/// Where the border line cuts the way from p to q, which lie on opposite sides of it.
Point cut(const Point& p, double p_side, const Point& q, double q_side) {
    return p + (p_side / (p_side - q_side)) * (q - p);
}

/// What of a convex polygon lies in the half-plane.
Corners clipped(const Corners& corners, const HalfPlane& keep) {
    Corners part;
    lod::PolygonClipper<2>(std::span<const HalfPlane>(&keep, 1)).clip(corners, part);
    return part;
}

/// What of a segment lies in the half-plane; false where nothing does.
bool clip(BorderSegment& segment, const HalfPlane& keep) {
    const double from = keep.side(segment.from);
    const double to = keep.side(segment.to);
    if (from > 0 && to > 0) return false;
    if (from >= 0 && to >= 0) return from == 0 && to == 0 && keep.keeps_border;
    if (from > 0) segment.from = cut(segment.from, from, segment.to, to);
    if (to > 0) segment.to = cut(segment.from, from, segment.to, to);
    return true;
}

bool holds_all(const lod::Sphere<2>& disc, std::span<const Point> corners) {
    return std::all_of(corners.begin(), corners.end(), [&](const Point& p) {
        return (p - disc.centre).squaredNorm() <= disc.radius * disc.radius && disc.radius >= 0;
    });
}

/// Cuts a convex polygon in two across its longer side; the half-planes of both sides.
std::pair<HalfPlane, HalfPlane> halves(const Corners& corners) {
    Box box;
    for (const Point& p : corners) box.hold(p);
    const int axis = box.size().x() >= box.size().y() ? 0 : 1;
    const Point normal = Point::Unit(axis);
    const double middle = box.centre()[axis];
    return {{normal, middle, true}, {-normal, -middle, false}};
}

/// Gathers in `held` what of the part the disc holds; returns the area of the rest.
double gather_held(const lod::Sphere<2>& disc, const Corners& part, int cuts_left,
                   std::vector<Corners>& held) {
    if (part.empty()) return 0;
    if (holds_all(disc, part)) {
        held.push_back(part);
        return 0;
    }
    if (cuts_left == 0) return std::abs(ring_area(part));
    const auto [first, second] = halves(part);
    const double rest = gather_held(disc, clipped(part, first), cuts_left - 1, held);
    return rest + gather_held(disc, clipped(part, second), cuts_left - 1, held);
}

}  // namespace

double ring_area(std::span<const Point> ring) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const Point a = ring[i] - ring[0];
        const Point b = ring[i + 1] - ring[0];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}

PolygonPiece::PolygonPiece(const Polygon& polygon) : parts_(convex_parts(polygon)) {
    std::int32_t edge = 0;
    for (const Ring& ring : polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i, ++edge) {
            const Point& from = ring[i];
            const Point& to = ring[i + 1 == ring.size() ? 0 : i + 1];
            const Point along = (to - from).stableNormalized();
            border_.push_back({from, to, Point(along.y(), -along.x()), edge});
        }
}

PolygonPiece PolygonPiece::within(std::span<const HalfPlane> cell) const {
    PolygonPiece result;
    lod::PolygonClipper<2> clipper(cell);
    for (std::size_t i = 0; i < parts_.count(); ++i)
        if (clipper.clip(parts_.part(i), result.parts_.corners) > 0) result.parts_.end_part();
    for (BorderSegment segment : border_)
        if (std::all_of(cell.begin(), cell.end(),
                        [&](const HalfPlane& keep) { return clip(segment, keep); }))
            result.border_.push_back(segment);
    return result;
}

double PolygonPiece::measure() const {
    double area = 0;
    for (std::size_t i = 0; i < parts_.count(); ++i) area += ring_area(parts_.part(i));
    return area;
}

double PolygonPiece::surface_measure() const {
    double length = 0;
    for (const BorderSegment& s : border_) length += (s.to - s.from).norm();
    return length;
}

Point PolygonPiece::surface_normal() const {
    Point sum(0, 0);
    for (const BorderSegment& s : border_) sum += (s.to - s.from).norm() * s.normal;
    return sum;
}

std::pair<PolygonPiece, double> PolygonPiece::held_by(const lod::Sphere<2>& disc) const {
    constexpr int most_cuts = 10;  // a part is judged in up to 1024 bits
    PolygonPiece kept;
    kept.border_ = border_;
    double rest = 0;
    std::vector<Corners> held;
    for (std::size_t i = 0; i < parts_.count(); ++i) {
        held.clear();
        const std::span<const Point> part = parts_.part(i);
        rest += gather_held(disc, Corners(part.begin(), part.end()), most_cuts, held);
        for (const Corners& corners : held) {
            kept.parts_.corners.insert(kept.parts_.corners.end(), corners.begin(), corners.end());
            kept.parts_.end_part();
        }
    }
    return {std::move(kept), rest};
}

lod::HullHints<2> PolygonPiece::hull_hints() const {
    lod::HullHints<2> hints{convex_hull(vertices()), {}};
    for (std::size_t i = 0; i < hints.corners.size(); ++i) {
        const Point along = hints.corners[(i + 1) % hints.corners.size()] - hints.corners[i];
        if (!along.isZero(0)) hints.normals.push_back(Point(along.y(), -along.x()).normalized());
    }
    return hints;
}

}  // namespace lod2d
