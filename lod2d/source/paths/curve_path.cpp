#include "lodlab/lod2d/source/paths/curve_path.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/math/trigonometry.hpp"

namespace lod2d {
namespace {

constexpr double largest_coordinate = 1e60;

/// The middle of the shorter arc from u anticlockwise to v, both on the unit circle.
Point middle_of(const Point& u, const Point& v) {
    const Point sum = u + v;
    const double length = sum.norm();
    return length > 1e-8 ? Point(sum / length) : Point(-u.y(), u.x());
}

/// Appends the points that halve the shorter arc from u to v until no step exceeds 1/16 of a turn,
/// and v: an arc without angles.
void append_halved(const Point& u, const Point& v, std::vector<Point>& points) {
    constexpr double cosine_of_step = 0.9238;  // of 22.5 degrees, a little less
    if (u.dot(v) < cosine_of_step) {
        const Point middle = middle_of(u, v);
        append_halved(u, middle, points);
        append_halved(middle, v, points);
    } else {
        points.push_back(v);
    }
}

std::vector<Point> arc_points(const Point& u, const Point& v, bool large) {
    std::vector<Point> points;
    Point middle = middle_of(u, v);
    if (large && middle.dot(u) > 0) middle = -middle;
    append_halved(u, middle, points);
    append_halved(middle, v, points);
    return points;
}

/// Control points of the cubic for a short arc of the unit circle (the usual 4/3 tan(angle / 4)).
double handle_length(const Point& u, const Point& v) {
    const double cosine = u.dot(v);
    const double half = std::sqrt(std::max(0.0, (1 - cosine) / (1 + cosine)));  // tan(angle / 2)
    return 4.0 / 3 * half / (1 + std::sqrt(1 + half * half));
}

Point perpendicular(const Point& p) {
    return {-p.y(), p.x()};
}

/// How many lines keep a cubic within the tolerance: the error of a chord is below h^2/8 max |B''|.
int cuts_of(const Point& a, const Point& b, const Point& c, const Point& d, double tolerance) {
    const double bend = 6 * std::max((a - 2 * b + c).norm(), (b - 2 * c + d).norm());
    const double cuts = std::ceil(std::sqrt(bend / (8 * tolerance)));
    return static_cast<int>(std::clamp(cuts, 1.0, double(CurvePath::most_cuts)));
}

/// `q`: the end points and, between them, the control points.
void append_cubic(Ring& ring, std::span<const Point, 4> q, double tolerance) {
    const Point& a = q[0];
    const Point& b = q[1];
    const Point& c = q[2];
    const Point& d = q[3];
    const int cuts = cuts_of(a, b, c, d, tolerance);
    for (int i = 1; i < cuts; ++i) {
        const double t = double(i) / cuts;
        const double s = 1 - t;
        ring.push_back(s * s * (s * a + 3 * t * b) + t * t * (3 * s * c + t * d));
    }
    ring.push_back(d);
}

/// The direction from p to the first of the points that lies elsewhere.
Point direction(const Point& p, std::initializer_list<Point> others) {
    for (const Point& other : others)
        if (other != p) return (other - p).normalized();
    return Point::Zero();
}

bool are_in_line(const Point& before, const Point& after) {
    const double sine = before.x() * after.y() - before.y() * after.x();
    return std::abs(sine) < 1e-6 && before.dot(after) > 0;
}

/// Takes off the last point, which repeats the first.
void close_chain(CurvePath::Chain& chain, bool closed) {
    const Point heading = chain.before.back();
    chain.points.pop_back();
    chain.before.pop_back();
    chain.after.pop_back();
    chain.smooth.pop_back();
    chain.smooth.front() = closed && are_in_line(heading, chain.after.front());
    chain.before.front() = heading;
}

}  // namespace

void CurvePath::move_to(const Point& p) {
    current_ = p;
    restart_ = true;
    moved_ = true;
}

CurvePath::Subpath& CurvePath::drawing() {
    if (restart_) {
        subpaths_.push_back({{current_}, {}, false});
        restart_ = false;
        moved_ = false;
    }
    return subpaths_.back();
}

void CurvePath::line_to(const Point& p) {
    Subpath& path = drawing();
    path.points.push_back(p);
    path.curved.push_back(false);
    current_ = p;
}

void CurvePath::quadratic_to(const Point& control, const Point& p) {
    const Point start = current_;
    cubic_to(start + 2.0 / 3 * (control - start), p + 2.0 / 3 * (control - p), p);
}

void CurvePath::cubic_to(const Point& control_1, const Point& control_2, const Point& p) {
    Subpath& path = drawing();
    path.points.insert(path.points.end(), {control_1, control_2, p});
    path.curved.push_back(true);
    current_ = p;
}

void CurvePath::arc_to(const EllipseArc& arc, const Point& p) {
    const double rx = std::abs(arc.rx);
    const double ry = std::abs(arc.ry);
    const Point start = current_;
    if (p == start) return;
    if (rx == 0 || ry == 0) return line_to(p);

    // In the frame where the ellipse is the unit circle.
    const lod::SineCosine of = lod::sine_cosine(arc.tilt);
    const lod::Matrix<2> to_circle(of.cosine / rx, of.sine / rx, -of.sine / ry, of.cosine / ry);
    const Point chord = to_circle * (p - start);
    const double half = chord.norm() / 2;
    const double grow = std::max(1.0, half);  // radii too small are scaled up
    // From the chord's middle to the centre: left of the chord for a short sweep.
    const double rise = std::sqrt(std::max(0.0, grow * grow - half * half)) / grow;
    const Point along = chord / (2 * half);
    const Point to_centre = (arc.large == arc.sweep ? -rise : rise) * perpendicular(along);
    const Point u = -half / grow * along - to_centre;
    const Point v = half / grow * along - to_centre;

    const double a = rx * grow;
    const double b = ry * grow;
    const lod::Matrix<2> from_circle(of.cosine * a, -of.sine * b, of.sine * a, of.cosine * b);
    const Point centre = start - from_circle * u;
    // Clockwise arcs are halved in a mirror.
    const Point mirror(1, arc.sweep ? 1 : -1);
    Point from = u.cwiseProduct(mirror);
    const std::vector<Point> points = arc_points(from, v.cwiseProduct(mirror), arc.large);
    for (const Point& to : points) {
        const double handle = handle_length(from, to);
        const auto carried = [&](const Point& q) {
            return Point(centre + from_circle * q.cwiseProduct(mirror));
        };
        const bool last = &to == &points.back();
        cubic_to(carried(from + handle * perpendicular(from)),
                 carried(to - handle * perpendicular(to)), last ? p : carried(to));
        from = to;
    }
}

void CurvePath::close() {
    if (restart_ && !moved_) return;
    Subpath& path = drawing();
    path.closed = true;
    current_ = path.points.front();
    restart_ = true;
}

void CurvePath::drop_dots() {
    std::erase_if(subpaths_, [](const Subpath& path) { return path.points.size() < 2; });
    restart_ = true;
}

void CurvePath::append(const CurvePath& other) {
    subpaths_.insert(subpaths_.end(), other.subpaths_.begin(), other.subpaths_.end());
    restart_ = true;
    moved_ = false;
}

void CurvePath::transform(const Affine& affine) {
    for (Subpath& path : subpaths_)
        for (Point& p : path.points) p = affine * p;
    current_ = affine * current_;
}

bool CurvePath::finite() const {
    for (const Subpath& path : subpaths_)
        for (const Point& p : path.points)
            if (!p.allFinite() || p.cwiseAbs().maxCoeff() > largest_coordinate) return false;
    return true;
}

Box CurvePath::control_box() const {
    Box box;
    for (const Subpath& path : subpaths_)
        for (const Point& p : path.points) box.hold(p);
    return box;
}

void CurvePath::Chain::append(const Point& p, bool is_smooth, const Point& from, const Point& on) {
    points.push_back(p);
    before.push_back(from);
    after.push_back(on);
    smooth.push_back(is_smooth);
}

std::vector<CurvePath::Chain> CurvePath::chains(double tolerance) const {
    std::vector<Chain> chains;
    for (const Subpath& path : subpaths_) {
        Chain& chain = chains.emplace_back();
        chain.append(path.points[0]);
        std::size_t next = 1;
        Point heading = Point::Zero();
        Ring cuts;
        for (bool curved : path.curved) {
            const Point* q = path.points.data() + next;
            const Point start =
                curved ? direction(q[-1], {q[0], q[1], q[2]}) : direction(q[-1], {q[0]});
            chain.after.back() = start;
            chain.smooth.back() = are_in_line(heading, start);
            cuts.clear();
            if (curved)
                append_cubic(cuts, std::span<const Point, 4>(q - 1, 4), tolerance);
            else
                cuts.push_back(q[0]);
            for (const Point& p : cuts) chain.append(p, true);
            const Point end = curved ? Point(-direction(q[2], {q[1], q[0], q[-1]})) : start;
            if (!end.isZero()) heading = end;
            chain.before.back() = heading;
            next += curved ? 3 : 1;
        }
        chain.smooth.back() = false;
        if (chain.points.size() > 1 && chain.points.back() == chain.points.front())
            close_chain(chain, path.closed);
    }
    return chains;
}

std::vector<Ring> CurvePath::flatten(double tolerance) const {
    std::vector<Ring> rings;
    for (Chain& chain : chains(tolerance)) rings.push_back(std::move(chain.points));
    return rings;
}

CurvePath rectangle_path(const Point& corner, const Point& size, const Point& radii) {
    const double rx = std::min(radii.x(), size.x() / 2);
    const double ry = std::min(radii.y(), size.y() / 2);
    CurvePath path;
    const double x = corner.x();
    const double y = corner.y();
    const double right = x + size.x();
    const double bottom = y + size.y();
    path.move_to({x + rx, y});
    path.line_to({right - rx, y});
    path.arc_to({rx, ry}, {right, y + ry});
    path.line_to({right, bottom - ry});
    path.arc_to({rx, ry}, {right - rx, bottom});
    path.line_to({x + rx, bottom});
    path.arc_to({rx, ry}, {x, bottom - ry});
    path.line_to({x, y + ry});
    path.arc_to({rx, ry}, {x + rx, y});
    path.close();
    return path;
}

CurvePath ellipse_path(const Point& centre, double rx, double ry) {
    CurvePath path;
    path.move_to(centre + Point(rx, 0));
    path.arc_to({rx, ry}, centre - Point(rx, 0));
    path.arc_to({rx, ry}, centre + Point(rx, 0));
    path.close();
    return path;
}

}  // namespace lod2d
