#include <cmath>
#include <limits>

#include "core/sphere.hpp"
#include "lessons/lessons.hpp"
#include "lessons/sketch.hpp"
#include "lod2d/generators.hpp"

namespace lessons {
namespace {

using lod::Sphere;
using Vec = lod::Vector<2>;

/// Two bodies, and a circle round the centre of mass of each that just holds it.
struct Scene {
    viz::Actor gear;
    viz::Actor star;
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
    Scene scene{actor("gear", gear), actor("star", star), holding_radius(gear),
                holding_radius(star), edge_count(gear.polygon) * edge_count(star.polygon)};
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

/// Shortest distance of two outlines that do not cross: some corner meets some edge.
double outline_gap(const Scene& scene) {
    const auto one_way = [](const viz::Actor& corners, const viz::Actor& edges) {
        double least = std::numeric_limits<double>::infinity();
        for (const viz::Ring& ring : viz::carried(corners.body, corners.look.rings))
            for (const viz::Point& p : ring)
                for (const viz::Ring& other : viz::carried(edges.body, edges.look.rings))
                    for (std::size_t i = 0; i < other.size(); ++i) {
                        const viz::Point& q = other[(i + 1) % other.size()];
                        const Vec from(other[i].x, other[i].y);
                        const Vec along = Vec(q.x, q.y) - from;
                        const Vec to = Vec(p.x, p.y) - from;
                        const double t = std::clamp(to.dot(along) / along.squaredNorm(), 0.0, 1.0);
                        least = std::min(least, (to - t * along).norm());
                    }
        return least;
    };
    return std::min(one_way(scene.gear, scene.star), one_way(scene.star, scene.gear));
}

viz::Box view_of() {
    return box(-1.45, -1.15, 2.75, 2.0);
}

void add_shapes(viz::Panel& panel, const Scene& scene) {
    add_body(panel, scene.gear, 0);
    add_body(panel, scene.star, 1);
}

void add_circles(viz::Panel& panel, const Scene& scene, bool meet) {
    const viz::Role role = meet ? viz::Role::meeting_node : viz::Role::node;
    add_disc(panel, scene.gear_circle(), style(role, 0, 0));
    add_disc(panel, scene.star_circle(), style(role, 1, 0));
}

/// The centre line with both radii laid along it, from either end.
void add_measure(viz::Panel& panel, const Scene& scene) {
    const Sphere<2> a = scene.gear_circle();
    const Sphere<2> b = scene.star_circle();
    const Vec along = (b.centre - a.centre).normalized();
    add_line(panel, viz::Role::construction, a.centre, b.centre);
    add_arrow(panel, viz::Role::velocity, a.centre, a.centre + a.radius * along, "*R*_a", 0);
    add_arrow(panel, viz::Role::velocity, b.centre, b.centre - b.radius * along, "*R*_b", 1);
    add_dot(panel, viz::Role::contact, a.centre);
    add_dot(panel, viz::Role::contact, b.centre);
    add_label(panel, viz::Role::note, a.centre, "*o*_a");
    add_label(panel, viz::Role::note, b.centre, "*o*_b");
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
    lesson.steps.push_back(
        {"Two outlines, many edges",
         "Your eye answers at once. A program that knows only outlines has to try edge after edge: "
         "every edge of the gear against every edge of the star, " +
             shown_count(scene.edge_pairs) +
             " pairs for these two. A hundred such bodies have 4950 pairs of bodies, sixty times a "
             "second.\n\n"
             "**Predict:** what is the cheapest question that could settle most of these pairs?",
         std::move(figure),
         {{"edge pairs", lesson.numbers["edge pairs"]}}});
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
    lesson.steps.push_back(
        {"Put each in a circle",
         "A circle is three numbers: its centre o (two) and its radius R (one). Each circle here "
         "is "
         "drawn round the centre of mass and reaches the farthest corner, so it holds the whole "
         "shape. That is the only promise the test will need.",
         figure_of(std::move(panel), "A circle that holds each shape",
                   "The gear and the star, each in a circle round its centre of mass that just "
                   "holds it."),
         {{"R_a", lesson.numbers["R_a"]}, {"R_b", lesson.numbers["R_b"]}}});
}

void step_apart(Lesson& lesson, Scene scene) {
    place_star(scene, 1.95);
    lesson.numbers["apart distance"] = number(distance_of(scene), 3, "m");
    lesson.numbers["reach"] = number(reach_of(scene), 3, "m");
    lesson.steps.push_back(
        {"Farther than the radii reach: apart",
         "Lay one radius along the centre line from each end. They do not meet: the distance d "
         "is " +
             lesson.numbers["apart distance"].text + ", and R_a + R_b reaches only " +
             lesson.numbers["reach"].text +
             ". So the circles are apart. All of A lies inside its circle, all of B inside its "
             "own, "
             "therefore A and B are apart too.\n\n"
             "**Apart is proof.** One test has settled what " +
             lesson.numbers["edge pairs"].text + " edge pairs would have said.",
         draw_test(scene, "Farther apart than the radii reach"),
         {{"d", lesson.numbers["apart distance"]}, {"R_a + R_b", lesson.numbers["reach"]}}});
    lesson.figures["apart"] = lesson.steps.back().figure;
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
    lesson.numbers["distance squared"] = number(distance_squared, 3, "m²");
    lesson.numbers["reach squared"] = number(reach_squared, 3, "m²");
    viz::Figure figure = draw_test(scene, "The same test without a square root");
    figure.numbers = {{"*d*²", shown(distance_squared, 3) + " m²"},
                      {"(*R*_a + *R*_b)²", shown(reach_squared, 3) + " m²"},
                      {"verdict", touching ? "circles meet" : "apart"}};
    lesson.steps.push_back(
        {"Compare the squares",
         "Pythagoras gives the distance squared: d² = x² + y² = " +
             lesson.numbers["distance squared"].text +
             ". A square root would turn it into d, but why should it? Neither side of the "
             "comparison is negative, and of two such numbers the one with the larger square is "
             "the "
             "larger. So compare d² with (R_a + R_b)² = " +
             lesson.numbers["reach squared"].text +
             " and save the root: two differences, three products, two sums, one comparison.",
         std::move(figure),
         {{"d²", lesson.numbers["distance squared"]},
          {"(R_a + R_b)²", lesson.numbers["reach squared"]}}});
}

void step_overlap(Lesson& lesson, Scene scene) {
    place_star(scene, 1.56);
    scene.star.body.orientation = 0.9;
    lesson.numbers["near distance"] = number(distance_of(scene), 3, "m");
    lesson.numbers["gap"] = number(outline_gap(scene), 3, "m");
    lesson.steps.push_back(
        {"The circles meet. Do the shapes?",
         "The star has come closer: d is now " + lesson.numbers["near distance"].text +
             ", less than the reach of " + lesson.numbers["reach"].text +
             ". The circles overlap, and both are drawn bold. Yet you can see daylight: the "
             "outlines are still " +
             lesson.numbers["gap"].text +
             " apart.\n\n"
             "**Overlap proves nothing.** It says *possible*. The circles also hold empty "
             "corners, and it may be only those that meet. Lesson 2 shrinks the empty corners; "
             "this test stays as it is.",
         draw_test(scene, "The circles meet, the shapes do not"),
         {{"d", lesson.numbers["near distance"]}, {"gap of the outlines", lesson.numbers["gap"]}}});
    lesson.figures["possible"] = lesson.steps.back().figure;
}

/// Two plain circles that meet in exactly one point.
viz::Figure draw_tangent(const Sphere<2>& a, const Sphere<2>& b) {
    viz::Panel panel;
    panel.view = box(-2.6, -2.3, 6.3, 7.2);
    const bool meet = lod::overlap(a, b);
    const viz::Role role = meet ? viz::Role::meeting_node : viz::Role::node;
    add_disc(panel, a, style(role, 0));
    add_disc(panel, b, style(role, 1));
    add_line(panel, viz::Role::construction, a.centre, b.centre);
    const Vec corner(b.centre.x(), a.centre.y());
    add_line(panel, viz::Role::construction, a.centre, corner);
    add_line(panel, viz::Role::construction, corner, b.centre);
    add_label(panel, viz::Role::note, (a.centre + corner) / 2, "3");
    add_label(panel, viz::Role::note, (corner + b.centre) / 2, "4");
    const Vec along = (b.centre - a.centre).normalized();
    add_dot(panel, viz::Role::contact, a.centre);
    add_dot(panel, viz::Role::contact, b.centre);
    add_label(panel, viz::Role::note, a.centre, "*o*_a");
    add_label(panel, viz::Role::note, b.centre, "*o*_b");
    if (meet) add_dot(panel, viz::Role::true_collision, a.centre + a.radius * along);
    return figure_of(std::move(panel), "Circles that touch in one point",
                     "Two circles of radius 2 m and 3 m whose centres are 3 m apart across and 4 m "
                     "up: they touch in a single point.");
}

void step_touching(Lesson& lesson) {
    // listing: touching
    const Sphere<2> a{Vec(0, 0), 2};
    const Sphere<2> b{Vec(3, 4), 3};
    const bool touching = lod::overlap(a, b);
    // end of listing
    const double distance_squared = (b.centre - a.centre).squaredNorm();
    const double reach = a.radius + b.radius;
    viz::Figure figure = draw_tangent(a, b);
    figure.numbers = {{"*d*²", shown(distance_squared, 0) + " m²"},
                      {"(*R*_a + *R*_b)²", shown(reach * reach, 0) + " m²"},
                      {"verdict", touching ? "touching" : "apart"}};
    lesson.numbers["touching d²"] = number(distance_squared, 0, "m²");
    lesson.numbers["touching reach²"] = number(reach * reach, 0, "m²");
    lesson.steps.push_back(
        {"Touching counts",
         "**Predict:** the centres are 3 m apart across and 4 m up, the radii are 2 m and 3 m. Do "
         "these circles meet?\n\n"
         "d² = 3² + 4² = " +
             lesson.numbers["touching d²"].text +
             ", and (2 + 3)² = " + lesson.numbers["touching reach²"].text +
             ". They share exactly one point. The program answers: " +
             (touching ? "they meet" : "apart") +
             ". The sign in the comparison is ≤, not <, for *apart* has to be a proof, and two "
             "bodies that touch are not apart.",
         std::move(figure),
         {{"d²", lesson.numbers["touching d²"]},
          {"(R_a + R_b)²", lesson.numbers["touching reach²"]}}});
}

/// Circles in a row that touch on paper: radii i/10 and j/10, centres (i + j)/10 apart.
struct DecimalTrial {
    int pairs = 0;
    int lost = 0;         ///< called apart
    int lost_safely = 0;  ///< still called apart with the bound of rounding added
};

// listing: decimals
DecimalTrial try_decimals(int most_tenths) {
    DecimalTrial trial;
    for (int i = 1; i <= most_tenths; ++i)
        for (int j = 1; j <= most_tenths; ++j) {
            const Sphere<2> a{Vec(0, 0), i / 10.0};
            const Sphere<2> b{Vec((i + j) / 10.0, 0), j / 10.0};
            const double bound = 1e-12 * (a.radius + b.radius);
            const Sphere<2> safe{a.centre, a.radius + bound};
            ++trial.pairs;
            if (!lod::overlap(a, b)) ++trial.lost;
            if (!lod::overlap(safe, b)) ++trial.lost_safely;
        }
    return trial;
}
// end of listing

void step_rounding(Lesson& lesson) {
    const Sphere<2> a{Vec(0, 0), 0.1};
    const Sphere<2> b{Vec(0.8, 0), 0.7};
    const DecimalTrial trial = try_decimals(20);
    viz::Panel panel;
    panel.view = box(-0.3, -0.8, 1.65, 0.8);
    const bool meet = lod::overlap(a, b);
    const viz::Role role = meet ? viz::Role::meeting_node : viz::Role::node;
    add_disc(panel, a, style(role, 0));
    add_disc(panel, b, style(role, 1));
    add_line(panel, viz::Role::construction, a.centre, b.centre);
    add_dot(panel, viz::Role::contact, a.centre);
    add_dot(panel, viz::Role::contact, b.centre);
    add_label(panel, viz::Role::note, a.centre, "radius 0.1", 0, a.radius);
    add_label(panel, viz::Role::note, b.centre, "radius 0.7");
    constexpr int all_digits = 17;
    viz::Figure figure =
        figure_of(std::move(panel), "Touching on paper, apart in the computer",
                  "Two circles of radius 0.1 m and 0.7 m with centres 0.8 m apart. "
                  "They touch, but the plain test calls them apart.");
    figure.numbers = {{"0.1 + 0.7", shown(a.radius + b.radius, all_digits)},
                      {"verdict", meet ? "touching" : "apart"}};
    lesson.numbers["tangent pairs"] = count(static_cast<std::uint64_t>(trial.pairs));
    lesson.numbers["lost pairs"] = count(static_cast<std::uint64_t>(trial.lost));
    lesson.numbers["lost with bound"] = count(static_cast<std::uint64_t>(trial.lost_safely));
    lesson.numbers["rounded reach"] = number(a.radius + b.radius, all_digits, "m");
    lesson.steps.push_back(
        {"What a computer makes of 0.1 + 0.7",
         "These two touch as well: the radii are 0.1 m and 0.7 m, the distance is 0.8 m. The "
         "program answers: **" +
             std::string(meet ? "touching" : "apart") +
             "**. A computer holds binary fractions, 0.1 and 0.7 are none, and so it finds 0.1 + "
             "0.7 = " +
             lesson.numbers["rounded reach"].text +
             ".\n\n"
             "Of " +
             lesson.numbers["tangent pairs"].text +
             " such pairs with radii in tenths of a metre, " + lesson.numbers["lost pairs"].text +
             " are called apart although they touch. A proof must not depend on luck, so the "
             "traversal "
             "of lesson 3 adds a bound of what rounding can do to every reach. With a bound of one "
             "part "
             "in a million million, " +
             lesson.numbers["lost with bound"].text + " are lost.",
         std::move(figure),
         {{"called apart", lesson.numbers["lost pairs"]},
          {"with the bound", lesson.numbers["lost with bound"]}}});
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
    step_touching(lesson);
    step_rounding(lesson);
    animate(lesson, scene);
}

}  // namespace lessons
