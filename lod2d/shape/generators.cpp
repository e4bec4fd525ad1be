#include "lodlab/lod2d/shape/generators.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/core/math/trigonometry.hpp"

namespace lod2d {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int sides_of_circle = 96;

using Values = std::span<const double>;

Point on_circle(double radius, double angle) {
    const lod::SineCosine of = lod::sine_cosine(angle);
    return {radius * of.cosine, radius * of.sine};
}

/// Part of a circle, from one angle to another.
struct Arc {
    Point centre;
    double radius = 0;
    double from = 0;
    double to = 0;
};

/// Appends count + 1 points of an arc, both ends included.
void append_arc(Ring& ring, const Arc& arc, int count) {
    for (int i = 0; i <= count; ++i)
        ring.push_back(arc.centre +
                       on_circle(arc.radius, arc.from + (arc.to - arc.from) * i / count));
}

Ring circle(double radius, int sides, double first_angle = 0) {
    Ring ring;
    for (int i = 0; i < sides; ++i)
        ring.push_back(on_circle(radius, first_angle + lod::full_turn * i / sides));
    return ring;
}

Ring hole(double radius, int sides) {
    const Ring outer = circle(radius, sides);
    return Ring(outer.rbegin(), outer.rend());
}

Polygon rectangle(double width, double height) {
    const double x = width / 2;
    const double y = height / 2;
    return {{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}}};
}

Polygon make_box(Values v) {
    return rectangle(v[0], v[1]);
}

Polygon make_triangle(Values v) {
    return {{{{-v[0] / 2, 0}, {v[0] / 2, 0}, {0, v[1]}}}};
}

Polygon make_polygon(Values v) {
    return {{circle(0.5, static_cast<int>(v[0]), pi / 2)}};
}

Polygon make_disc(Values v) {
    return {{circle(0.5, static_cast<int>(v[0]))}};
}

Polygon make_ellipse(Values v) {
    Ring ring = circle(0.5, sides_of_circle);
    for (Point& p : ring) p = Point(v[0] * p.x(), v[1] * p.y());
    return {{ring}};
}

Polygon make_ring(Values v) {
    return {{circle(0.5, sides_of_circle), hole(0.5 * v[0], sides_of_circle)}};
}

Polygon make_capsule(Values v) {
    if (v[1] >= v[0])
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot make the capsule: WIDTH must be less than LENGTH");
    const double radius = v[1] / 2;
    const double reach = v[0] / 2 - radius;
    Ring ring;
    append_arc(ring, {{reach, 0}, radius, -pi / 2, pi / 2}, 24);
    append_arc(ring, {{-reach, 0}, radius, pi / 2, 3 * pi / 2}, 24);
    return {{ring}};
}

Polygon make_l(Values v) {
    const double t = v[0];
    return {{{{0, 0}, {1, 0}, {1, t}, {t, t}, {t, 1}, {0, 1}}}};
}

Polygon make_t(Values v) {
    const double t = v[0];
    return {{{{-t / 2, 0},
              {t / 2, 0},
              {t / 2, 1 - t},
              {0.5, 1 - t},
              {0.5, 1},
              {-0.5, 1},
              {-0.5, 1 - t},
              {-t / 2, 1 - t}}}};
}

Polygon make_u(Values v) {
    const double t = v[0];
    return {{{{0, 0}, {1, 0}, {1, 1}, {1 - t, 1}, {1 - t, t}, {t, t}, {t, 1}, {0, 1}}}};
}

Polygon make_cross(Values v) {
    const double t = v[0] / 2;
    return {{{{-t, -0.5},
              {t, -0.5},
              {t, -t},
              {0.5, -t},
              {0.5, t},
              {t, t},
              {t, 0.5},
              {-t, 0.5},
              {-t, t},
              {-0.5, t},
              {-0.5, -t},
              {-t, -t}}}};
}

Polygon make_star(Values v) {
    const int points = static_cast<int>(v[0]);
    Ring ring;
    for (int i = 0; i < 2 * points; ++i)
        ring.push_back(on_circle(i % 2 == 0 ? 0.5 : 0.5 * v[1], pi / 2 + pi * i / points));
    return {{ring}};
}

/// Tips take 0.32 of a pitch, roots 0.40, flanks the rest. Arcs are cut every 5 degrees or finer.
Polygon make_gear(Values v) {
    const int teeth = static_cast<int>(v[0]);
    const double tip = 0.5;
    const double root = tip - v[1] / 2;
    const double pitch = lod::full_turn / teeth;
    const int cuts = static_cast<int>(std::ceil(0.4 * 72.0 / teeth));
    Ring ring;
    for (int i = 0; i < teeth; ++i) {
        const double middle = pi / 2 + pitch * i;
        append_arc(ring, {{0, 0}, tip, middle - 0.16 * pitch, middle + 0.16 * pitch}, cuts);
        append_arc(ring, {{0, 0}, root, middle + 0.30 * pitch, middle + 0.70 * pitch}, cuts);
    }
    Polygon gear{{ring}};
    if (v[2] > 0) gear.rings.push_back(hole(v[2] / 2, 48));
    return gear;
}

Polygon make_arrow(Values v) {
    const double t = v[0] / 2;
    const double head = v[1];
    return {{{{-0.5, -t},
              {0.5 - head, -t},
              {0.5 - head, -head * 0.6 - t},
              {0.5, 0},
              {0.5 - head, head * 0.6 + t},
              {0.5 - head, t},
              {-0.5, t}}}};
}

/// The unit disc less a disc through the two horn tips.
Polygon make_crescent(Values v) {
    const double horn = pi / 3;     // the outer circle's angle at a tip
    const double bite = pi * v[0];  // the inner circle's angle at the same tip
    const Point tip = on_circle(0.5, horn);
    const double inner_radius = tip.y() / lod::sine_cosine(bite).sine;
    const Point inner_centre(tip.x() - inner_radius * lod::sine_cosine(bite).cosine, 0);
    Ring ring;
    append_arc(ring, {{0, 0}, 0.5, horn, lod::full_turn - horn}, 64);
    Ring inner;
    append_arc(inner, {inner_centre, inner_radius, lod::full_turn - bite, bite}, 48);
    ring.insert(ring.end(), inner.begin() + 1, inner.end() - 1);
    return {{ring}};
}

Polygon make_comb(Values v) {
    const int teeth = static_cast<int>(v[0]);
    const double width = 1.0 / (2 * teeth - 1);
    Ring ring{{0, 0}, {1, 0}};
    for (int i = teeth - 1; i >= 0; --i) {
        const double left = 2 * i * width;
        ring.emplace_back(left + width, 0.6);
        ring.emplace_back(left, 0.6);
        if (i == 0) break;
        ring.emplace_back(left, 0.2);
        ring.emplace_back(left - width, 0.2);
    }
    return {{ring}};
}

Polygon make_spiral(Values v) {
    const double turns = v[0];
    const int cuts = static_cast<int>(std::ceil(turns * 48));
    const double band = 0.5 / (turns + 1);  // growth of the radius in one turn
    Ring outer;
    Ring inner;
    for (int i = 0; i <= cuts; ++i) {
        const double angle = turns * lod::full_turn * i / cuts;
        const double radius = band * (0.5 + angle / lod::full_turn);
        outer.push_back(on_circle(radius + 0.5 * band, angle));
        inner.push_back(on_circle(radius, angle));
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return {{outer}};
}

/// A circle whose radius carries waves of 2 to 7 periods; the smallest radius stays positive.
Polygon make_blob(Values v) {
    constexpr int waves = 6;
    constexpr int sides = 128;
    lod::Random random(static_cast<std::uint64_t>(v[0]));
    double height[waves];
    double phase[waves];
    double sum = 0;
    for (int k = 0; k < waves; ++k) {
        height[k] = random.next() / (k + 2);
        phase[k] = lod::full_turn * random.next();
        sum += height[k];
    }
    const double scale = 0.6 / std::max(sum, 0.6);
    Ring ring;
    for (int i = 0; i < sides; ++i) {
        const double angle = lod::full_turn * i / sides;
        double radius = 1;
        for (int k = 0; k < waves; ++k)
            radius += scale * height[k] * lod::sine_cosine((k + 2) * angle + phase[k]).sine;
        ring.push_back(on_circle(radius, angle));
    }
    Polygon blob{{ring}};
    const double extent = bounds(blob).size().maxCoeff();
    for (Point& p : blob.rings[0]) p /= extent;
    return blob;
}

constexpr bool whole = true;

const std::vector<Generator> all{
    {"box", "a rectangle", {{"WIDTH", "m", 1, 1e-3, 1e3}, {"HEIGHT", "m", 1, 1e-3, 1e3}}, make_box},
    {"rod",
     "a long thin rectangle",
     {{"LENGTH", "m", 1, 1e-3, 1e3}, {"WIDTH", "m", 0.08, 1e-3, 1e3}},
     make_box},
    {"triangle",
     "a triangle with two equal sides (three, by default)",
     {{"BASE", "m", 1, 1e-3, 1e3}, {"HEIGHT", "m", 0.8660254037844386, 1e-3, 1e3}},
     make_triangle},
    {"polygon",
     "a regular polygon, 1 m across its outer circle",
     {{"SIDES", "number of sides", 6, 3, 1000, whole}},
     make_polygon},
    {"disc",
     "a disc of 1 m across, as a regular polygon",
     {{"SIDES", "number of sides", sides_of_circle, 8, 10000, whole}},
     make_disc},
    {"ellipse",
     "an ellipse",
     {{"WIDTH", "m", 1, 1e-3, 1e3}, {"HEIGHT", "m", 0.6, 1e-3, 1e3}},
     make_ellipse},
    {"ring",
     "a disc of 1 m across with a round hole",
     {{"INNER", "diameter of the hole [m]", 0.6, 0.01, 0.99}},
     make_ring},
    {"capsule",
     "a rod with round ends",
     {{"LENGTH", "m", 1, 0.02, 1e3}, {"WIDTH", "m, less than the length", 0.4, 0.01, 1e3}},
     make_capsule},
    {"L",
     "an angle of two arms of 1 m",
     {{"THICKNESS", "of an arm [m]", 0.35, 0.01, 0.99}},
     make_l},
    {"T", "a T of 1 m by 1 m", {{"THICKNESS", "of a bar [m]", 0.3, 0.01, 0.99}}, make_t},
    {"U", "a U of 1 m by 1 m", {{"THICKNESS", "of a wall [m]", 0.25, 0.01, 0.49}}, make_u},
    {"cross",
     "a plus sign of 1 m by 1 m",
     {{"THICKNESS", "of a bar [m]", 0.32, 0.01, 0.99}},
     make_cross},
    {"star",
     "a star, 1 m across its outer circle",
     {{"POINTS", "number of points", 5, 3, 1000, whole},
      {"INNER", "inner radius / outer radius", 0.45, 0.05, 0.95}},
     make_star},
    {"gear",
     "a toothed wheel, 1 m across its tips",
     {{"TEETH", "number of teeth", 9, 3, 1000, whole},
      {"DEPTH", "of the teeth, of the diameter [m]", 0.26, 0.01, 0.6},
      {"BORE", "diameter of the hole [m], 0 for none", 0.2, 0, 0.35}},
     make_gear},
    {"arrow",
     "an arrow of 1 m",
     {{"THICKNESS", "of the shaft [m]", 0.2, 0.01, 0.5},
      {"HEAD", "length of the head [m]", 0.4, 0.05, 0.95}},
     make_arrow},
    {"crescent",
     "a moon, 1 m across its outer circle",
     {{"BITE", "angle of the inner arc at a tip, in half turns", 0.55, 0.34, 0.8}},
     make_crescent},
    {"comb", "a comb, 1 m wide", {{"TEETH", "number of teeth", 6, 2, 500, whole}}, make_comb},
    {"spiral",
     "a spiral band, about 1 m across",
     {{"TURNS", "number of turns", 2.5, 0.5, 50}},
     make_spiral},
    {"blob",
     "a smooth random outline, longer side 1 m",
     {{"SEED", "which one", 1, 0, 9007199254740992.0, whole}},
     make_blob},
};

}  // namespace

std::span<const Generator> generators() {
    return all;
}

}  // namespace lod2d
