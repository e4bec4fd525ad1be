#include <algorithm>
#include <array>
#include <cmath>

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/math/sphere.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"

namespace lessons {
namespace {

using lod::Sphere;
using Vec = lod::Vector<2>;

/// Two bodies, and a circle round the centre of mass of each that just holds it.
struct Scene {
    lod2d::Shape gear_shape = scaled(lod2d::generate("gear:9"), 2);
    lod2d::Shape star_shape = scaled(lod2d::generate("star:5"), 1.3);
    viz::Actor<2> gear = actor("gear", gear_shape);
    viz::Actor<2> star = actor("star", star_shape);
    double gear_radius = 0;
    double star_radius = 0;

    [[nodiscard]] Sphere<2> gear_circle() const { return {gear.body.position, gear_radius}; }
    [[nodiscard]] Sphere<2> star_circle() const { return {star.body.position, star_radius}; }
    [[nodiscard]] bool circles_meet() const { return lod::overlap(gear_circle(), star_circle()); }
    [[nodiscard]] Number distance() const { return number(star.body.position.norm(), 3, "m"); }
    [[nodiscard]] Number reach() const { return number(gear_radius + star_radius, 3, "m"); }
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

/// The gear at the origin and the star at a distance from it, towards (0.8, 0.6).
Scene make_scene(double distance, double turn) {
    Scene scene;
    scene.gear_radius = holding_radius(scene.gear_shape);
    scene.star_radius = holding_radius(scene.star_shape);
    scene.star.body.position = distance * Vec(0.8, 0.6);
    scene.star.body.orientation = turn;
    return scene;
}

viz::Panel draw_shapes(const Scene& scene, const viz::Box& view = box(-1.15, -1.1, 2.35, 1.9)) {
    viz::Panel panel;
    panel.view = view;
    add_body(panel, scene.gear, 0);
    add_body(panel, scene.star, 1);
    return panel;
}

viz::Figure draw_test(const Scene& scene) {
    viz::Panel panel = draw_shapes(scene);
    const Sphere<2> a = scene.gear_circle();
    const Sphere<2> b = scene.star_circle();
    add_circles(panel, a, b, scene.circles_meet());
    const Vec along = (b.centre - a.centre).normalized();
    add_centres(panel, a, b);
    add_arrow(panel, viz::Role::velocity, a.centre, a.centre + a.radius * along, "*R*_a", 0);
    add_arrow(panel, viz::Role::velocity, b.centre, b.centre - b.radius * along, "*R*_b", 1);
    viz::Figure figure = figure_of(std::move(panel));
    figure.numbers = {{"distance *d*", scene.distance().text},
                      {"reach *R*_a + *R*_b", scene.reach().text},
                      {"verdict", scene.circles_meet() ? "circles meet" : "apart"}};
    return figure;
}

void give_shapes(Lesson& lesson, const Scene& scene) {
    give(lesson, "edge pairs",
         count(edge_count(scene.gear_shape.polygon) * edge_count(scene.star_shape.polygon)));
    constexpr int bodies = 100;
    give(lesson, "bodies", count(bodies));
    give(lesson, "other bodies", count(bodies - 1));
    give(lesson, "body pairs", count(bodies * (bodies - 1) / 2));
    viz::Panel panel = draw_shapes(scene);
    add_label(panel, viz::Role::body, scene.gear.body.position, "A", 0);
    add_label(panel, viz::Role::body, scene.star.body.position, "B", 1);
    give(lesson, "shapes", std::move(panel), {{"edge pairs", "edge pairs"}});
}

void give_circles(Lesson& lesson, const Scene& scene) {
    give(lesson, "R_a", number(scene.gear_radius, 3, "m"));
    give(lesson, "R_b", number(scene.star_radius, 3, "m"));
    viz::Panel panel = draw_shapes(scene);
    add_circles(panel, scene.gear_circle(), scene.star_circle(), false);
    for (const auto& [circle, centre, radius] : {std::tuple{scene.gear_circle(), "*o*_a", "*R*_a"},
                                                 {scene.star_circle(), "*o*_b", "*R*_b"}}) {
        const Vec edge = circle.centre + circle.radius * Vec(-0.6, 0.8);
        add_line(panel, viz::Role::construction, circle.centre, edge);
        add_dot(panel, viz::Role::contact, circle.centre);
        add_label(panel, viz::Role::note, circle.centre, centre);
        add_label(panel, viz::Role::note, (circle.centre + edge) / 2, radius);
    }
    give(lesson, "circles", std::move(panel));
}

void give_squares(Lesson& lesson, const Scene& scene) {
    const Sphere<2> a = scene.gear_circle();
    const Sphere<2> b = scene.star_circle();
    // listing: squared
    const Vec gap = b.centre - a.centre;
    const double distance_squared = gap.x() * gap.x() + gap.y() * gap.y();
    const double reach = a.radius + b.radius;
    const double reach_squared = reach * reach;
    const bool touching = distance_squared <= reach_squared;
    // end of listing
    give(lesson, "distance squared", number(distance_squared, 3, "m²"));
    give(lesson, "reach squared", number(reach_squared, 3, "m²"));
    viz::Figure figure = draw_test(scene);
    add_sides(figure.panels[0], a.centre, b.centre, "*x* = " + shown(gap.x(), 2) + " m",
              "*y* = " + shown(gap.y(), 2) + " m");
    figure.numbers = {{"*d*²", lesson.numbers["distance squared"].text},
                      {"(*R*_a + *R*_b)²", lesson.numbers["reach squared"].text},
                      {"verdict", touching ? "circles meet" : "apart"}};
    give(lesson, "squares", std::move(figure));
}

/// The place where the outlines come nearest, enlarged.
viz::Panel draw_gap(const Scene& scene, const lod2d::ClosestPoints& gap) {
    const Vec centre = (gap.on_a + gap.on_b) / 2;
    const Vec reach = Vec::Constant(0.16);
    viz::Panel panel = draw_shapes(scene, {at(centre - reach), at(centre + reach)});
    panel.title = "where they come nearest";
    add_circles(panel, scene.gear_circle(), scene.star_circle(), true);
    add_line(panel, viz::Role::contact, gap.on_a, gap.on_b);
    for (const Vec& end : {gap.on_a, gap.on_b}) add_dot(panel, viz::Role::contact, end);
    add_label(panel, viz::Role::note, centre, "gap " + shown(gap.distance, 3) + " m");
    return panel;
}

void give_overlap(Lesson& lesson, const Scene& scene) {
    const lod2d::ClosestPoints gap =
        lod2d::closest_points(outline_of(scene.gear_shape, scene.gear.body),
                              outline_of(scene.star_shape, scene.star.body));
    give(lesson, "near distance", scene.distance());
    give(lesson, "gap", number(gap.distance, 3, "m"));
    viz::Figure figure = draw_test(scene);
    figure.panels.push_back(draw_gap(scene, gap));
    figure.panels[0].title = "the whole scene";
    figure.columns = 2;
    figure.shared_scale = false;
    figure.aspect = 16.0 / 9;
    give(lesson, "possible", std::move(figure));
}

/// Stars round the gear, some of whose circles meet its own.
std::vector<Scene> stars_round_the_gear() {
    constexpr std::array shares{0.90, 1.13, 0.96, 1.08, 0.78, 1.2};  // of the reach
    std::vector<Scene> stars;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double turn = static_cast<double>(i) / shares.size();
        Scene one = make_scene(0, lod::full_turn * (0.3 * turn + 0.07));
        one.star_shape = scaled(lod2d::generate("star:5"), 0.8);
        one.star_radius = holding_radius(one.star_shape);
        one.star = actor("star", one.star_shape);
        const auto [sine, cosine] = lod::sine_cosine(lod::full_turn * (turn + 0.04));
        one.star.body.position =
            shares[i] * (one.gear_radius + one.star_radius) * Vec(cosine, sine);
        one.star.body.orientation = lod::full_turn * (0.3 * turn + 0.07);
        stars.push_back(std::move(one));
    }
    return stars;
}

bool shapes_meet(const Scene& scene) {
    return lod2d::overlap(outline_of(scene.gear_shape, scene.gear.body),
                          outline_of(scene.star_shape, scene.star.body));
}

/// Which stars need a closer look: before their circles are tested, and after.
void give_many(Lesson& lesson) {
    const std::vector<Scene> stars = stars_round_the_gear();
    viz::Panel before;
    before.view = box(-2.3, -1.75, 2.3, 1.75);
    add_body(before, stars[0].gear, 0);
    viz::Panel after = before;
    add_ball(before, stars[0].gear_circle(), style(viz::Role::level_node, 0, 0));
    add_ball(after, stars[0].gear_circle(), style(viz::Role::meeting_node, 0, 0));
    Picks picks;
    int possible = 0;
    int touching = 0;
    for (const Scene& one : stars) {
        const Sphere<2> circle = one.star_circle();
        const std::string name = shown_count(picks.size() + 1);
        const bool meet = one.circles_meet();
        possible += meet ? 1 : 0;
        touching += shapes_meet(one) ? 1 : 0;
        picks.push_back({name, at(circle.centre), circle.radius, meet, ""});
        for (viz::Panel* panel : {&before, &after}) {
            const viz::Role tested = meet ? viz::Role::meeting_node : viz::Role::node;
            add_body(*panel, one.star, 1);
            add_ball(*panel, circle,
                     style(panel == &before ? viz::Role::level_node : tested, 1, 0));
            add_label(*panel, viz::Role::body, circle.centre, name, 1, circle.radius);
        }
    }
    give(lesson, "stars", count(stars.size()));
    give(lesson, "possible stars", count(possible));
    give(lesson, "proved stars", count(static_cast<int>(stars.size()) - possible));
    give(lesson, "touching stars",
         words(touching == 1 ? "one" : std::to_string(touching), touching));
    give(lesson, "stars untested", std::move(before));
    give(lesson, "stars tested", std::move(after));
    give(lesson, "star circles", std::move(picks));
}

/// Two plain circles that meet in exactly one point.
void give_touching(Lesson& lesson) {
    // listing: touching
    const Sphere<2> a{Vec(0, 0), 2};
    const Sphere<2> b{Vec(3, 4), 3};
    const bool touching = lod::overlap(a, b);
    // end of listing
    const double reach = a.radius + b.radius;
    give(lesson, "touching d²", number((b.centre - a.centre).squaredNorm(), 0, "m²"));
    give(lesson, "touching reach²", number(reach * reach, 0, "m²"));
    give(lesson, "touching verdict", words(touching ? "they meet" : "apart"));
    viz::Panel panel;
    panel.view = box(-2.6, -2.3, 6.3, 7.2);
    add_centres(panel, a, b);
    add_sides(panel, a.centre, b.centre, "3", "4");
    give(lesson, "centres", panel);
    add_circles(panel, a, b, touching);
    const Vec along = (b.centre - a.centre).normalized();
    if (touching) add_dot(panel, viz::Role::true_collision, a.centre + a.radius * along);
    viz::Figure figure = figure_of(std::move(panel));
    figure.numbers = {{"*d*²", lesson.numbers["touching d²"].text},
                      {"(*R*_a + *R*_b)²", lesson.numbers["touching reach²"].text},
                      {"verdict", touching ? "touching" : "apart"}};
    give(lesson, "tangent", std::move(figure));
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

void give_rounding(Lesson& lesson) {
    constexpr int all_digits = 17;
    const Sphere<2> a{Vec(0, 0), 0.1};
    const Sphere<2> b{Vec(0.8, 0), 0.7};
    const std::string verdict = lod::overlap(a, b) ? "touching" : "apart";
    const DecimalTrial trial = try_decimals(20);
    give(lesson, "tangent pairs", count(trial.pairs));
    give(lesson, "lost pairs", count(trial.lost));
    give(lesson, "lost with bound", count(trial.lost_safely));
    give(lesson, "rounded reach", number(a.radius + b.radius, all_digits, "m"));
    give(lesson, "rounded verdict", words(verdict));
    viz::Panel panel;
    panel.view = box(-0.3, -0.8, 1.65, 0.8);
    add_circles(panel, a, b, lod::overlap(a, b));
    add_line(panel, viz::Role::construction, a.centre, b.centre);
    for (const Vec& centre : {a.centre, b.centre}) add_dot(panel, viz::Role::contact, centre);
    add_label(panel, viz::Role::note, a.centre, "radius 0.1", 0, a.radius);
    add_label(panel, viz::Role::note, b.centre, "radius 0.7");
    viz::Figure figure = figure_of(std::move(panel));
    figure.numbers = {{"0.1 + 0.7", shown(a.radius + b.radius, all_digits)}, {"verdict", verdict}};
    give(lesson, "decimals", std::move(figure));
}

/// The two bodies with their circles for trees. A frame stops at level 0, the circles.
live::Scene play(const Scene& scene) {
    const auto circled = [](viz::Actor<2> body, const lod2d::Shape& shape, double radius) {
        auto tree = std::make_shared<lod::SphereTree<2>>(*tree_of(shape, 1));
        for (std::vector<double>& coordinates : tree->centre) coordinates[0] = 0;
        tree->radius[0] = radius;
        lod::renew<2>(*tree);
        body.body.tree = std::move(tree);
        return body;
    };
    live::Scene play = to_play_with({circled(scene.gear, scene.gear_shape, scene.gear_radius),
                                     circled(scene.star, scene.star_shape, scene.star_radius)},
                                    box(-1.6, -1.3, 2.6, 1.9), live::Told::verdicts);
    play.settings.deepest_level = 0;
    return play;
}

/// The star passes the gear: far, near, far.
void animate(Lesson& lesson) {
    constexpr int pictures = 72;
    constexpr double far = 2.15, near = 1.42;  // [m]
    const std::string meet = video_words(lesson, "meet");
    const std::string apart = video_words(lesson, "apart");
    for (int i = 0; i < pictures; ++i) {
        const double phase = 2 * std::acos(-1.0) * i / pictures;
        const double distance = near + (far - near) * (0.5 + 0.5 * std::cos(phase));
        const Scene now = make_scene(distance, 0.35 + phase / 5);
        const auto draw = [now, title = now.circles_meet() ? meet : apart] {
            viz::Figure figure = draw_test(now);
            figure.title = title;
            return figure;
        };
        lesson.animation.shots.push_back({draw, 2});
    }
}

}  // namespace

void make_distance_test(Lesson& lesson) {
    const Scene scene = make_scene(1.95, 0.35);
    give(lesson, "apart distance", scene.distance());
    give(lesson, "reach", scene.reach());
    give_shapes(lesson, scene);
    give_circles(lesson, scene);
    give(lesson, "apart", draw_test(scene));
    give_squares(lesson, scene);
    give_overlap(lesson, make_scene(1.56, 0.9));
    give_many(lesson);
    give_touching(lesson);
    give_rounding(lesson);
    give(lesson, play(scene));
    animate(lesson);
}

}  // namespace lessons
