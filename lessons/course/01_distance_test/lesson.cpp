#include "lessons/course/01_distance_test/lesson.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/math/sphere.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"

namespace lessons {
namespace {

using lod::Sphere;
using Vec = lod::Vector<2>;

/// Two bodies, and a circle round the centre of mass of each that just holds it.
struct Scene {
    lod2d::Shape gear_shape;
    lod2d::Shape star_shape;
    viz::Actor<2> gear;
    viz::Actor<2> star;
    double gear_radius = 0;
    double star_radius = 0;
    std::size_t edge_pairs = 0;

    [[nodiscard]] Sphere<2> gear_circle() const { return {gear.body.position, gear_radius}; }
    [[nodiscard]] Sphere<2> star_circle() const { return {star.body.position, star_radius}; }
};

// listing: holding circle
/// Radius of the circle round the centre of mass that just holds the shape.
double holding_radius(const lod2d::Shape& shape) {
    double farthest = 0;
    for (const lod2d::Ring& ring : shape.polygon.rings)
        for (const lod2d::Point& corner : ring) farthest = std::max(farthest, corner.norm());
    return farthest;
}
// end of listing

Scene make_scene() {
    const lod2d::Shape gear = scaled(lod2d::generate("gear:9"), 2);
    const lod2d::Shape star = scaled(lod2d::generate("star:5"), 1.3);
    Scene scene{gear, star, actor("gear", gear), actor("star", star)};
    scene.gear_radius = holding_radius(gear);
    scene.star_radius = holding_radius(star);
    scene.edge_pairs = edge_count(gear.polygon) * edge_count(star.polygon);
    scene.star.body.orientation = 0.35;
    return scene;
}

double distance_of(const Scene& scene) {
    return (scene.star_circle().centre - scene.gear_circle().centre).norm();
}

double reach_of(const Scene& scene) {
    return scene.gear_radius + scene.star_radius;
}

/// Where the star stands when the two centres are `distance` apart, in a fixed direction.
void place_star(Scene& scene, double distance) {
    scene.star.body.position = distance * Vec(0.8, 0.6);
}

/// The shortest way from one outline to the other.
lod2d::ClosestPoints outline_gap(const Scene& scene) {
    return lod2d::closest_points(outline_of(scene.gear_shape, scene.gear.body),
                                 outline_of(scene.star_shape, scene.star.body));
}

viz::Box view_of() {
    return box(-1.15, -1.1, 2.35, 1.9);
}

void add_shapes(viz::Panel& panel, const Scene& scene) {
    add_body(panel, scene.gear, 0);
    add_body(panel, scene.star, 1);
}

void add_circles(viz::Panel& panel, const Scene& scene, bool meet) {
    const viz::Role role = meet ? viz::Role::meeting_node : viz::Role::node;
    add_ball(panel, scene.gear_circle(), style(role, 0, 0));
    add_ball(panel, scene.star_circle(), style(role, 1, 0));
}

/// The centre line with both radii laid along it, from either end.
void add_measure(viz::Panel& panel, const Scene& scene) {
    const Sphere<2> a = scene.gear_circle();
    const Sphere<2> b = scene.star_circle();
    const Vec along = (b.centre - a.centre).normalized();
    add_centres(panel, a, b);
    add_arrow(panel, viz::Role::velocity, a.centre, a.centre + a.radius * along, "*R*_a", 0);
    add_arrow(panel, viz::Role::velocity, b.centre, b.centre - b.radius * along, "*R*_b", 1);
}

void add_test_numbers(viz::Figure& figure, const Scene& scene) {
    figure.numbers = {
        {"distance *d*", shown(distance_of(scene), 3) + " m"},
        {"reach *R*_a + *R*_b", shown(reach_of(scene), 3) + " m"},
        {"verdict",
         lod::overlap(scene.gear_circle(), scene.star_circle()) ? "circles meet" : "apart"}};
}

viz::Figure draw_test(const Scene& scene, const std::string& title) {
    viz::Panel panel;
    panel.view = view_of();
    const bool meet = lod::overlap(scene.gear_circle(), scene.star_circle());
    add_shapes(panel, scene);
    add_circles(panel, scene, meet);
    add_measure(panel, scene);
    viz::Figure figure = figure_of(
        std::move(panel), title,
        "A gear and a star, each in a circle. The centres are " + shown(distance_of(scene), 3) +
            " m apart, the radii add up to " + shown(reach_of(scene), 3) + " m: the circles " +
            (meet ? "meet." : "are apart."));
    add_test_numbers(figure, scene);
    return figure;
}

void step_shapes(Lesson& lesson, const Scene& scene) {
    viz::Panel panel;
    panel.view = view_of();
    add_shapes(panel, scene);
    add_label(panel, viz::Role::body, scene.gear.body.position, "A", 0);
    add_label(panel, viz::Role::body, scene.star.body.position, "B", 1);
    viz::Figure figure =
        figure_of(std::move(panel), "Do the gear and the star touch?",
                  "A gear with nine teeth and a star with five points, side by side.");
    figure.numbers = {{"edge pairs", shown_count(scene.edge_pairs)}};
    lesson.numbers["edge pairs"] = count(scene.edge_pairs);
    add_step(
        lesson, "Two outlines, many edges",
        "Your eye answers at once. A program that knows only outlines has to try edge after edge: "
        "every edge of the gear against every edge of the star, " +
            shown_count(scene.edge_pairs) +
            " pairs for these two. A hundred such bodies have 4950 pairs of bodies, sixty times a "
            "second.\n\n"
            "**Predict:** what is the cheapest question that could settle most of these pairs?",
        std::move(figure), {{"edge pairs", "edge pairs"}});
}

void step_circles(Lesson& lesson, const Scene& scene) {
    viz::Panel panel;
    panel.view = view_of();
    add_shapes(panel, scene);
    add_circles(panel, scene, false);
    for (const auto& [circle, centre, radius] : {std::tuple{scene.gear_circle(), "*o*_a", "*R*_a"},
                                                 {scene.star_circle(), "*o*_b", "*R*_b"}}) {
        const Vec edge = circle.centre + circle.radius * Vec(-0.6, 0.8);
        add_line(panel, viz::Role::construction, circle.centre, edge);
        add_dot(panel, viz::Role::contact, circle.centre);
        add_label(panel, viz::Role::note, circle.centre, centre);
        add_label(panel, viz::Role::note, (circle.centre + edge) / 2, radius);
    }
    lesson.numbers["R_a"] = number(scene.gear_radius, 3, "m");
    lesson.numbers["R_b"] = number(scene.star_radius, 3, "m");
    add_step(
        lesson, "Put each in a circle",
        "A circle is three numbers: its centre o (two) and its radius R (one). Each circle here is "
        "drawn round the centre of mass and reaches the farthest corner, so it holds the whole "
        "shape. That is the only promise the test will need.",
        figure_of(
            std::move(panel), "A circle that holds each shape",
            "The gear and the star, each in a circle round its centre of mass that just holds it."),
        {{"R_a", "R_a"}, {"R_b", "R_b"}});
}

void step_apart(Lesson& lesson, Scene scene) {
    place_star(scene, 1.95);
    lesson.numbers["apart distance"] = number(distance_of(scene), 3, "m");
    lesson.numbers["reach"] = number(reach_of(scene), 3, "m");
    add_step(lesson, "Farther than the radii reach: apart",
             "Lay one radius along the centre line from each end. They do not meet: the distance d "
             "is {{number: apart distance}}, and R_a + R_b reaches only {{number: reach}}. So the "
             "circles are apart. All of A lies inside its circle, all of B inside its own, "
             "therefore A and B are apart too.\n\n"
             "**Apart is proof.** One test has settled what {{number: edge pairs}} edge pairs "
             "would have said.",
             draw_test(scene, "Farther apart than the radii reach"),
             {{"d", "apart distance"}, {"R_a + R_b", "reach"}}, "apart");
}

void step_squares(Lesson& lesson, Scene scene) {
    place_star(scene, 1.95);
    const Sphere<2> a = scene.gear_circle();
    const Sphere<2> b = scene.star_circle();
    // listing: squared
    const Vec gap = b.centre - a.centre;
    const double distance_squared = gap.x() * gap.x() + gap.y() * gap.y();
    const double reach = a.radius + b.radius;
    const double reach_squared = reach * reach;
    const bool touching = distance_squared <= reach_squared;
    // end of listing
    viz::Figure figure = draw_test(scene, "The same test without a square root");
    const Vec corner(b.centre.x(), a.centre.y());
    add_line(figure.panels[0], viz::Role::construction, a.centre, corner);
    add_line(figure.panels[0], viz::Role::construction, corner, b.centre);
    add_label(figure.panels[0], viz::Role::note, (a.centre + corner) / 2,
              "*x* = " + shown(gap.x(), 2) + " m");
    add_label(figure.panels[0], viz::Role::note, (corner + b.centre) / 2,
              "*y* = " + shown(gap.y(), 2) + " m");
    lesson.numbers["distance squared"] = number(distance_squared, 3, "m²");
    lesson.numbers["reach squared"] = number(reach_squared, 3, "m²");
    figure.numbers = {{"*d*²", shown(distance_squared, 3) + " m²"},
                      {"(*R*_a + *R*_b)²", shown(reach_squared, 3) + " m²"},
                      {"verdict", touching ? "circles meet" : "apart"}};
    add_step(lesson, "Compare the squares",
             "Pythagoras gives the distance squared: d² = x² + y² = {{number: distance squared}}. "
             "A square root would turn it into d, but why should it? Neither side of the "
             "comparison is negative, and of two such numbers the one with the larger square is "
             "the larger. So compare d² with (R_a + R_b)² = {{number: reach squared}} and save the "
             "root: two differences, three products, two sums, one comparison.",
             std::move(figure), {{"d²", "distance squared"}, {"(R_a + R_b)²", "reach squared"}});
}

/// The place where the outlines come nearest, enlarged.
viz::Panel draw_gap(const Scene& scene, const lod2d::ClosestPoints& gap) {
    viz::Panel panel;
    panel.title = "where they come nearest";
    const Vec centre = (gap.on_a + gap.on_b) / 2;
    const Vec reach = Vec::Constant(0.16);
    panel.view = {at(centre - reach), at(centre + reach)};
    add_shapes(panel, scene);
    add_circles(panel, scene, true);
    add_line(panel, viz::Role::contact, gap.on_a, gap.on_b);
    add_dot(panel, viz::Role::contact, gap.on_a);
    add_dot(panel, viz::Role::contact, gap.on_b);
    add_label(panel, viz::Role::note, centre, "gap " + shown(gap.distance, 3) + " m");
    return panel;
}

void step_overlap(Lesson& lesson, Scene scene) {
    place_star(scene, 1.56);
    scene.star.body.orientation = 0.9;
    lesson.numbers["near distance"] = number(distance_of(scene), 3, "m");
    const lod2d::ClosestPoints gap = outline_gap(scene);
    viz::Figure figure = draw_test(scene, "The circles meet, the shapes do not");
    figure.panels.push_back(draw_gap(scene, gap));
    figure.panels[0].title = "the whole scene";
    figure.columns = 2;
    figure.shared_scale = false;
    figure.aspect = 16.0 / 9;
    lesson.numbers["gap"] = number(gap.distance, 3, "m");
    add_step(lesson, "The circles meet. Do the shapes?",
             "The star has come closer: d is now {{number: near distance}}, less than the reach of "
             "{{number: reach}}. The circles overlap, and both are drawn bold. Yet you can see "
             "daylight: the outlines are still {{number: gap}} apart.\n\n"
             "**Overlap proves nothing.** It says *possible*. The circles also hold empty corners, "
             "and it may be only those that meet. Lesson 2 shrinks the empty corners; this test "
             "stays as it is.",
             std::move(figure), {{"d", "near distance"}, {"gap of the outlines", "gap"}},
             "possible");
}

/// The star passes the gear: far, near, far.
void animate(Lesson& lesson, Scene scene) {
    constexpr int pictures = 72;
    constexpr double far = 2.15;
    constexpr double near = 1.42;
    lesson.animation.title = "The star comes and goes; the circles meet before the shapes could";
    lesson.animation.frames_per_second = 30;
    for (int i = 0; i < pictures; ++i) {
        const double phase = 2 * std::acos(-1.0) * i / pictures;
        place_star(scene, near + (far - near) * (0.5 + 0.5 * std::cos(phase)));
        scene.star.body.orientation = 0.35 + 2 * std::acos(-1.0) / 5 * i / pictures;
        const Scene now = scene;
        const bool meet = lod::overlap(now.gear_circle(), now.star_circle());
        lesson.animation.shots.push_back(
            {[now, meet] {
                 return draw_test(now, meet ? "The circles meet: a collision is possible"
                                            : "The circles are apart, so the shapes are");
             },
             2});
    }
}

}  // namespace

void make_distance_test(Lesson& lesson) {
    Scene scene = make_scene();
    place_star(scene, 1.95);
    step_shapes(lesson, scene);
    step_circles(lesson, scene);
    step_apart(lesson, scene);
    step_squares(lesson, scene);
    step_overlap(lesson, scene);
    distance::step_touching(lesson);
    distance::step_rounding(lesson);
    animate(lesson, scene);
}

}  // namespace lessons
