#include "lodlab/viz/paint/canvas/clip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lodlab/core/math/polygon.hpp"

namespace viz {
namespace {

Point between(Point p, Point q, double t) {
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

}  // namespace

Rect grown(const Rect& rect, double by) {
    return {rect.x - by, rect.y - by, rect.width + 2 * by, rect.height + 2 * by};
}

bool contains(const Rect& rect, Point p) {
    return p.x >= rect.x && p.x <= rect.right() && p.y >= rect.y && p.y <= rect.bottom();
}

bool clip_segment(Point p, Point q, const Rect& to, double& from, double& until) {
    // Liang and Barsky: each border bounds the parameter from below or above.
    const double dx = q.x - p.x;
    const double dy = q.y - p.y;
    const std::array<double, 4> step{-dx, dx, -dy, dy};
    const std::array<double, 4> room{p.x - to.x, to.right() - p.x, p.y - to.y, to.bottom() - p.y};
    from = 0;
    until = 1;
    for (std::size_t side = 0; side < 4; ++side) {
        if (step[side] == 0) {
            if (room[side] < 0) return false;
        } else if (step[side] < 0) {
            from = std::max(from, room[side] / step[side]);
        } else {
            until = std::min(until, room[side] / step[side]);
        }
    }
    return from <= until;
}

std::vector<Ring> clipped_line(const std::vector<Point>& line, const Rect& to) {
    std::vector<Ring> parts;
    bool drawing = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        double from = 0;
        double until = 1;
        if (!clip_segment(line[i], line[i + 1], to, from, until)) {
            drawing = false;
            continue;
        }
        if (!drawing || from > 0) parts.push_back({between(line[i], line[i + 1], from)});
        parts.back().push_back(between(line[i], line[i + 1], until));
        drawing = until == 1;
    }
    return parts;
}

Ring clipped_ring(const Ring& ring, const Rect& to) {
    const bool all_inside =
        std::all_of(ring.begin(), ring.end(), [&](Point p) { return contains(to, p); });
    if (all_inside) return ring;
    const std::array<lod::HalfSpace<2>, 4> sides{{{{-1, 0}, -to.x, true},
                                                  {{1, 0}, to.right(), true},
                                                  {{0, -1}, -to.y, true},
                                                  {{0, 1}, to.bottom(), true}}};
    std::vector<lod::Vector<2>> corners;
    for (const Point p : ring) corners.emplace_back(p.x, p.y);
    std::vector<lod::Vector<2>> kept;
    lod::PolygonClipper<2>(sides).clip(corners, kept);
    Ring clipped;
    for (const lod::Vector<2>& p : kept) clipped.push_back({p.x(), p.y()});
    return clipped;
}

Ring clipped_disc(Point centre, double radius, const Rect& to) {
    const Point middle{to.x + to.width / 2, to.y + to.height / 2};
    const double reach = std::hypot(to.width, to.height) / 2;
    const double distance = std::hypot(middle.x - centre.x, middle.y - centre.y);
    if (distance > radius + reach) return {};
    if (distance + reach < radius)
        return {{to.x, to.y}, {to.right(), to.y}, {to.right(), to.bottom()}, {to.x, to.bottom()}};
    // The rim passes the rectangle, far from the centre: a sector that holds the rectangle.
    constexpr int steps = 512;
    const double towards = std::atan2(middle.y - centre.y, middle.x - centre.x);
    const double half = 2 * std::asin(std::min(1.0, reach / distance));
    Ring sector{centre};
    for (int i = 0; i <= steps; ++i) {
        const double angle = towards - half + 2 * half * i / steps;
        sector.push_back(
            {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return clipped_ring(sector, to);
}

}  // namespace viz
