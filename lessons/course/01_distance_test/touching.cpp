#include "lessons/course/01_distance_test/lesson.hpp"

namespace lessons::distance {
namespace {

using lod::Sphere;
using Vec = lod::Vector<2>;

/// Bold where the test says that they meet.
void add_circles(viz::Panel& panel, const Sphere<2>& a, const Sphere<2>& b) {
    const viz::Role role = lod::overlap(a, b) ? viz::Role::meeting_node : viz::Role::node;
    add_ball(panel, a, style(role, 0));
    add_ball(panel, b, style(role, 1));
}

/// Two plain circles that meet in exactly one point.
viz::Figure draw_tangent(const Sphere<2>& a, const Sphere<2>& b) {
    viz::Panel panel;
    panel.view = box(-2.6, -2.3, 6.3, 7.2);
    const bool meet = lod::overlap(a, b);
    add_circles(panel, a, b);
    add_centres(panel, a, b);
    const Vec corner(b.centre.x(), a.centre.y());
    add_line(panel, viz::Role::construction, a.centre, corner);
    add_line(panel, viz::Role::construction, corner, b.centre);
    add_label(panel, viz::Role::note, (a.centre + corner) / 2, "3");
    add_label(panel, viz::Role::note, (corner + b.centre) / 2, "4");
    const Vec along = (b.centre - a.centre).normalized();
    if (meet) add_dot(panel, viz::Role::true_collision, a.centre + a.radius * along);
    return figure_of(std::move(panel), "Circles that touch in one point",
                     "Two circles of radius 2 m and 3 m whose centres are 3 m apart across and 4 m "
                     "up: they touch in a single point.");
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

}  // namespace

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
    add_step(lesson, "Touching counts",
             "**Predict:** the centres are 3 m apart across and 4 m up, the radii are 2 m and 3 m. "
             "Do these circles meet?\n\n"
             "d² = 3² + 4² = {{number: touching d²}}, and (2 + 3)² = {{number: touching reach²}}. "
             "They share exactly one point. The program answers: " +
                 std::string(touching ? "they meet" : "apart") +
                 ". The sign in the comparison is ≤, not <, for *apart* has to be a proof, and two "
                 "bodies that touch are not apart.",
             std::move(figure), {{"d²", "touching d²"}, {"(R_a + R_b)²", "touching reach²"}});
}

void step_rounding(Lesson& lesson) {
    const Sphere<2> a{Vec(0, 0), 0.1};
    const Sphere<2> b{Vec(0.8, 0), 0.7};
    const DecimalTrial trial = try_decimals(20);
    viz::Panel panel;
    panel.view = box(-0.3, -0.8, 1.65, 0.8);
    const bool meet = lod::overlap(a, b);
    add_circles(panel, a, b);
    add_line(panel, viz::Role::construction, a.centre, b.centre);
    add_dot(panel, viz::Role::contact, a.centre);
    add_dot(panel, viz::Role::contact, b.centre);
    add_label(panel, viz::Role::note, a.centre, "radius 0.1", 0, a.radius);
    add_label(panel, viz::Role::note, b.centre, "radius 0.7");
    constexpr int all_digits = 17;
    viz::Figure figure = figure_of(std::move(panel), "Touching on paper, apart in the computer",
                                   "Two circles of radius 0.1 m and 0.7 m with centres 0.8 m "
                                   "apart. They touch, but the plain test calls them apart.");
    figure.numbers = {{"0.1 + 0.7", shown(a.radius + b.radius, all_digits)},
                      {"verdict", meet ? "touching" : "apart"}};
    lesson.numbers["tangent pairs"] = count(static_cast<std::uint64_t>(trial.pairs));
    lesson.numbers["lost pairs"] = count(static_cast<std::uint64_t>(trial.lost));
    lesson.numbers["lost with bound"] = count(static_cast<std::uint64_t>(trial.lost_safely));
    lesson.numbers["rounded reach"] = number(a.radius + b.radius, all_digits, "m");
    add_step(
        lesson, "What a computer makes of 0.1 + 0.7",
        "These two touch as well: the radii are 0.1 m and 0.7 m, the distance is 0.8 m. The "
        "program answers: **" +
            std::string(meet ? "touching" : "apart") +
            "**. A computer holds binary fractions, 0.1 and 0.7 are none, and so it finds 0.1 + "
            "0.7 = {{number: rounded reach}}.\n\n"
            "Of {{number: tangent pairs}} such pairs with radii in tenths of a metre, {{number: "
            "lost pairs}} are called apart although they touch. A proof must not depend on luck, "
            "so the traversal of lesson 3 adds a bound of what rounding can do to every reach. "
            "With a bound of one part in a million million, {{number: lost with bound}} are lost.",
        std::move(figure), {{"called apart", "lost pairs"}, {"with the bound", "lost with bound"}});
}

}  // namespace lessons::distance
