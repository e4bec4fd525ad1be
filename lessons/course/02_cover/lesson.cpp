#include "lessons/course/02_cover/lesson.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/random.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"

namespace lessons {
namespace cover {

using lod::Sphere;

// listing: covers
bool covers(const Circles& circles, const lod2d::PolygonPiece& shape) {
    const std::vector<lod2d::PolygonPiece> pieces = lod::split<2>(shape, circles);
    for (std::size_t i = 0; i < circles.size(); ++i)
        for (const Vec& corner : pieces[i].vertices())
            if ((corner - circles[i].centre).norm() > circles[i].radius) return false;
    return true;
}
// end of listing

std::vector<Vec> corners_of(const lod2d::PolygonPiece& piece) {
    std::vector<Vec> corners;
    for (const Vec& corner : piece.vertices()) {
        const auto same = [&](const Vec& other) { return (other - corner).norm() < 1e-9; };
        if (std::none_of(corners.begin(), corners.end(), same)) corners.push_back(corner);
    }
    return corners;
}

namespace {

/// A crescent and a star, each with a cover of a few circles: level 1 of a tree.
struct Scene {
    lod2d::Shape crescent_shape = scaled(lod2d::generate("crescent"), 2);
    lod2d::Shape star_shape = scaled(lod2d::generate("star:5"), 1.3);
    viz::Actor<2> crescent = actor("crescent", crescent_shape, tree_of(crescent_shape, 1));
    viz::Actor<2> star = actor("star", star_shape, tree_of(star_shape, 1));

    [[nodiscard]] bool shapes_meet() const {
        return lod2d::overlap(outline_of(crescent_shape, crescent.body),
                              outline_of(star_shape, star.body));
    }
};

Circles circles_of(const viz::Actor<2>& actor) {
    Circles circles;
    for (const int node : actor.body.tree->level_nodes(1))
        circles.push_back(viz::carried_node(actor.body, node));
    return circles;
}

// listing: meet
bool circles_meet(const Circles& a, const Circles& b) {
    for (const Sphere<2>& one : a)
        for (const Sphere<2>& other : b)
            if (lod::overlap(one, other)) return true;
    return false;
}
// end of listing

/// The star comes in until a corner of it lies well in the crescent: that corner.
Vec touch(Scene& scene) {
    const Vec way(0.6, 0.8);
    constexpr double deep = 0.12;  // [m]
    double distance = 3;           // [m]
    do scene.star.body.position = (distance -= 0.01) * way;
    while (!scene.shapes_meet());
    scene.star.body.position = (distance - deep) * way;
    const lod2d::BoundaryIndex crescent = outline_of(scene.crescent_shape, scene.crescent.body);
    return corner_within(scene.star, crescent);
}

/// A point of both bodies, and the circles that hold it.
void give_shared_point(Lesson& lesson, Scene scene) {
    const Vec p = touch(scene);
    viz::Panel panel;
    panel.view = box(-1.3, -1.2, 1.9, 2.1);
    add_body(panel, scene.crescent, 0);
    add_body(panel, scene.star, 1);
    const auto crescent_circles = circles_of(scene.crescent).size();
    const auto star_circles = circles_of(scene.star).size();
    int holding = 0;
    for (const int index : {0, 1})
        for (const Sphere<2>& circle : circles_of(index == 0 ? scene.crescent : scene.star)) {
            const bool holds = (p - circle.centre).norm() <= circle.radius;
            holding += holds ? 1 : 0;
            add_ball(panel, circle,
                     style(holds ? viz::Role::meeting_node : viz::Role::node, index, 1));
        }
    add_dot(panel, viz::Role::contact, p);
    add_label(panel, viz::Role::contact, p, "*p*");
    give(lesson, "crescent circles", count(crescent_circles));
    give(lesson, "star circles", count(star_circles));
    give(lesson, "pair tests", count(crescent_circles * star_circles));
    give(lesson, "holding p", count(holding));
    give(lesson, "shared", std::move(panel));
}

/// A small star is dropped on the crescent, again and again: how often they touch, and how often no
/// circles do.
void give_drops(Lesson& lesson, Scene scene) {
    constexpr int drops = 1000;
    constexpr double small = 0.3;  // [m]: the star's width
    constexpr double side = 1.6;   // [m]: half of the square in which the star is dropped
    const Circles sound = circles_of(scene.crescent);
    Circles spoiled = sound;
    spoiled[0].radius *= shrunk;
    scene.star_shape = scaled(lod2d::generate("star:5"), small);
    scene.star = actor("star", scene.star_shape, tree_of(scene.star_shape, 1));
    lod::Random random(7);
    int touching = 0;
    int missed = 0;
    int missed_by_spoiled = 0;
    for (int i = 0; i < drops; ++i) {
        const double x = random.next(-side, side);
        scene.star.body.position = Vec(x, random.next(-side, side));
        scene.star.body.orientation = random.next(0, lod::full_turn);
        if (!scene.shapes_meet()) continue;
        const Circles star = circles_of(scene.star);
        ++touching;
        missed += circles_meet(sound, star) ? 0 : 1;
        missed_by_spoiled += circles_meet(spoiled, star) ? 0 : 1;
    }
    give(lesson, "small star", number(100 * small, 0, "cm"));
    give(lesson, "drops", count(drops));
    give(lesson, "touching", count(touching));
    give(lesson, "missed", count(missed));
    give(lesson, "missed by spoiled", count(missed_by_spoiled));
}

/// The star cut into the pieces of its circles, with their corners.
void give_pieces(Lesson& lesson, const Scene& scene) {
    const Circles circles = circles_of(scene.star);
    const lod2d::PolygonPiece shape(scene.star_shape.polygon);
    const std::vector<lod2d::PolygonPiece> pieces = lod::split<2>(shape, circles);
    viz::Panel panel;
    panel.view = viz::grown(box_round(circles), 0.02);
    std::size_t tests = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto index = static_cast<int>(i);
        add_piece(panel, pieces[i].parts(), index);
        add_ball(panel, circles[i], style(viz::Role::level_node, index, 1));
    }
    for (const lod2d::PolygonPiece& piece : pieces)
        for (const Vec& corner : corners_of(piece)) {
            panel.marks.push_back(viz::Dot{style(viz::Role::contact), at(corner), 0.7});
            ++tests;
        }
    give(lesson, "star tests", count(tests));
    give(lesson, "star certified", words(covers(circles, shape) ? "certified" : "refused"));
    give(lesson, "pieces", std::move(panel), {{"corners to try", "star tests"}});
}

// listing: rounding
/// Of rectangles of 2 i by 2 k, i and k up to `most`: how many have corners outside their circle,
/// whose radius a computer has rounded? No rounding hides it: fma rounds the difference only.
int circles_too_small(int most, double bound) {
    int too_small = 0;
    for (int i = 1; i <= most; ++i)
        for (int k = 1; k <= most; ++k) {
            const double squared = i * i + k * k;
            const double radius = std::sqrt(squared) + bound;
            if (std::fma(radius, radius, -squared) < 0) ++too_small;
        }
    return too_small;
}
// end of listing

void give_rounding(Lesson& lesson) {
    constexpr int most = 20;
    constexpr int all_digits = 17;
    const double radius = std::sqrt(0.5);
    give(lesson, "half root", number(radius, all_digits, "m"));
    give(lesson, "rectangles", count(most * most));
    give(lesson, "too small", count(circles_too_small(most, 0)));
    give(lesson, "too small grown", count(circles_too_small(most, bound)));
}

}  // namespace
}  // namespace cover

void make_cover(Lesson& lesson) {
    const cover::Scene scene;
    cover::give_shared_point(lesson, scene);
    cover::give_drops(lesson, scene);
    cover::give_pieces(lesson, scene);
    cover::give_rounding(lesson);
    cover::give_plank(lesson);
}

}  // namespace lessons
