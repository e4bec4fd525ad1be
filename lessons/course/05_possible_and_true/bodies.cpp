#include <algorithm>

#include "lessons/course/05_possible_and_true/lesson.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/lod2d/builder/tree_report.hpp"
#include "lodlab/lod2d/shape/generators.hpp"

namespace lessons::alarms {

namespace {

std::vector<double> worst_of(const lod2d::Shape& shape, const lod::SphereTree<2>& tree) {
    std::vector<double> worst;
    for (const lod2d::LevelReport& level : lod2d::report_tree(shape, tree).levels)
        worst.push_back(level.worst_protrusion);
    return worst;
}

}  // namespace

Bodies::Bodies(int depth)
    : letter_shape(scaled(lod2d::generate("L"), 2)),
      star_shape(scaled(lod2d::generate("star:5"), 1.1)),
      letter(actor("L", letter_shape, tree_of(letter_shape, depth, lod2d::Builder::medial))),
      star(actor("star", star_shape, tree_of(star_shape, depth, lod2d::Builder::medial))),
      letter_out(worst_of(letter_shape, *letter.body.tree)),
      star_out(worst_of(star_shape, *star.body.tree)) {}

void Bodies::place_star(const Vec& position, double angle) {
    star.body.position = position;
    star.body.orientation = angle;
}

lod2d::ClosestPoints Bodies::closest() const {
    return lod2d::closest_points(outline_of(letter_shape, letter.body),
                                 outline_of(star_shape, star.body));
}

namespace {

const Vec way(0.8, 0.6);

/// Moves the star in along a line until `arrived`.
template <class Arrived>
void move_in(Bodies& bodies, double angle, const Arrived& arrived) {
    constexpr double approach = 0.002;  // [m] a try
    double distance = 2.5;              // [m]
    do bodies.place_star((distance -= approach) * way, angle);
    while (!arrived(bodies));
}

}  // namespace

Bodies near_miss(Bodies bodies) {
    constexpr double gap = 0.13;  // [m]: level 2 may still reach over it, level 3 may not
    move_in(bodies, first_angle, [](const Bodies& now) { return now.closest().distance < gap; });
    return bodies;
}

Bodies false_collision(const Bodies& bodies) {
    constexpr int angles = 24;
    constexpr double fifth = lod::full_turn / 5;
    constexpr double further = 0.004;  // [m]: so that the overlap can be seen
    Bodies widest = bodies;
    double most = 0;
    for (int i = 0; i < angles; ++i) {
        Bodies now = bodies;
        move_in(now, fifth * i / angles, [](const Bodies& there) {
            return there.traverse().back().verdict == lod::Verdict::true_collision;
        });
        now.place_star(now.star.body.position - further * way, now.star.body.orientation);
        const double gap = now.closest().distance;
        if (gap <= most) continue;
        most = gap;
        widest = now;
    }
    return widest;
}

Bodies overlapping(Bodies bodies) {
    constexpr double inside = 0.15;  // [m] beyond the first touch
    move_in(bodies, first_angle, [](const Bodies& now) { return now.closest().distance == 0; });
    bodies.place_star(bodies.star.body.position - inside * way, first_angle);
    return bodies;
}

void drop(Bodies& bodies, lod::Random& random) {
    constexpr double side = 1.8;  // [m]: half of the square in which the star is dropped
    const double x = random.next(-side, side);
    const double y = random.next(-side, side);
    bodies.place_star(Vec(x, y), random.next(0, lod::full_turn));
}

}  // namespace lessons::alarms
