#include "lodlab/lod2d/shape/shape.hpp"

#include <cmath>

#include "lodlab/core/base/error.hpp"

namespace lod2d {
namespace {

/// Beyond this a fourth power of a length, or its inverse, would leave double's range [m].
constexpr double largest_coordinate = 1e60;
constexpr double smallest_extent = 1e-60;

std::string use_of(const std::string& name) {
    return "cannot use the shape '" + name + "'";
}

double cross(const Point& a, const Point& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Calls visit(p, q) for every edge of the polygon.
template <typename Visit>
void for_each_edge(const Polygon& polygon, Visit visit) {
    for (const Ring& ring : polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
}

void check_coordinates(const std::string& name, const Polygon& polygon) {
    if (polygon.rings.empty())
        lod::refuse_input(use_of(name), "it is empty; give at least one closed outline");
    for (const Ring& ring : polygon.rings) {
        if (ring.size() < 3)
            lod::refuse_input(use_of(name), "an outline has " + std::to_string(ring.size()) +
                                                " points; a closed outline needs at least 3");
        for (const Point& p : ring)
            if (!p.allFinite() || p.cwiseAbs().maxCoeff() > largest_coordinate)
                lod::refuse_input(use_of(name),
                                  "a coordinate is not finite or beyond 1e60 m; check the numbers");
    }
}

Polygon moved(const Polygon& polygon, const Point& by) {
    Polygon result = polygon;
    for (Ring& ring : result.rings)
        for (Point& p : ring) p += by;
    return result;
}

/// The nearest point whose coordinates have so few binary digits that moving a shape of this extent
/// by it is exact, where the shape's own coordinates are as short: edges that touch keep touching,
/// and none come to cross. Moves the point by less than 2^-51 of the extent.
Point rounded_to_grid(const Point& p, double extent) {
    int exponent = 0;
    std::frexp(extent, &exponent);
    const double step = std::ldexp(1.0, exponent - 51);
    return step * (p / step).cwiseRound();
}

/// Area and its first moments by Green's theorem, about the origin.
struct Moments {
    double area = 0;
    Point first = Point::Zero();
};

Moments moments(const Polygon& polygon) {
    Moments sum;
    for_each_edge(polygon, [&](const Point& p, const Point& q) {
        const double twice = cross(p, q);
        sum.area += twice / 2;
        sum.first += twice / 6 * (p + q);
    });
    return sum;
}

}  // namespace

double polygon_area(const Polygon& polygon) {
    return moments(polygon).area;
}

double polar_moment(const Polygon& polygon) {
    double sum = 0;
    for_each_edge(polygon, [&](const Point& p, const Point& q) {
        sum += cross(p, q) * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
    });
    return sum / 12;
}

Box bounds(const Polygon& polygon) {
    Box box;
    for (const Ring& ring : polygon.rings)
        for (const Point& p : ring) box.hold(p);
    return box;
}

Shape make_shape(std::string name, const Polygon& polygon) {
    check_coordinates(name, polygon);
    const Box box = bounds(polygon);
    const double extent = box.size().maxCoeff();
    // About the box's middle first, so that a small shape far from the origin keeps its digits.
    const Point middle = rounded_to_grid(box.centre(), extent);
    const Moments about_middle = moments(moved(polygon, -middle));
    if (about_middle.area < -1e-12 * extent * extent)
        lod::refuse_input(use_of(name),
                          "it runs clockwise; give outer rings anticlockwise, holes clockwise");
    if (!(about_middle.area > 1e-12 * extent * extent) || extent < smallest_extent)
        lod::refuse_input(use_of(name),
                          "its area is zero; give a closed outline that encloses something");

    Shape shape;
    shape.name = std::move(name);
    shape.centroid = middle + rounded_to_grid(about_middle.first / about_middle.area, extent);
    shape.polygon = moved(polygon, -shape.centroid);
    shape.area = polygon_area(shape.polygon);
    shape.second_moment = polar_moment(shape.polygon);
    return shape;
}

}  // namespace lod2d
