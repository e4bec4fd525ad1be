#include "lessons/course/04_contact_and_impulse/lesson.hpp"

#include <cmath>

#include "lodlab/core/frame/frame.hpp"
#include "lodlab/core/tree/traversal.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"

namespace lessons {
namespace {

using impact::impulse_length;
using impact::Scene;
using lod::Body;
using lod::Contact;
using lod::Sphere;
using Vec = lod::Vector<2>;

constexpr double velocity_length = 0.5;  ///< metres of arrow for a metre a second
constexpr double normal_length = 0.35;   ///< metres of arrow for a unit normal

viz::Box view_round(const Vec& centre, double reach) {
    constexpr double wide = page_aspect;
    return box(centre.x() - wide * reach, centre.y() - reach, centre.x() + wide * reach,
               centre.y() + reach);
}

std::string vector_text(const Vec& v) {
    std::string text = "(";
    text += shown(v.x(), 3) + ", " + shown(v.y(), 3) + ")";
    return text;
}

/// The two nodes, near by.
viz::Panel nodes_panel(const Scene& scene) {
    viz::Panel panel;
    const double reach = 1.7 * std::max(scene.node_a.radius, scene.node_b.radius);
    panel.view = view_round((scene.node_a.centre + scene.node_b.centre) / 2, reach);
    add_body(panel, scene.gear, 0);
    add_body(panel, scene.star, 1);
    add_ball(panel, scene.node_a, style(viz::Role::meeting_node, 0));
    add_ball(panel, scene.node_b, style(viz::Role::meeting_node, 1));
    return panel;
}

/// Both bodies whole, with the contact point.
viz::Panel bodies_panel(const Scene& scene) {
    viz::Panel panel;
    panel.view = scene.view;
    add_body(panel, scene.gear, 0);
    add_body(panel, scene.star, 1);
    add_dot(panel, viz::Role::contact, scene.contact.point);
    return panel;
}

void add_motion(viz::Panel& panel, const viz::Actor<2>& actor, int index) {
    const Vec x = actor.body.position;
    add_arrow(panel, viz::Role::velocity, x, x + velocity_length * actor.body.velocity,
              index == 0 ? "*v*_a" : "*v*_b", index);
}

void step_nodes(Lesson& lesson, const Scene& scene) {
    viz::Panel panel = nodes_panel(scene);
    add_label(panel, viz::Role::body, scene.node_a.centre, "node of A", 0, scene.node_a.radius);
    add_label(panel, viz::Role::body, scene.node_b.centre, "node of B", 1, scene.node_b.radius);
    viz::Figure figure = figure_of(std::move(panel), "Two nodes overlap: now what?",
                                   "A node of the gear and a node of the star, which overlap.");
    figure.numbers = {{"level", std::to_string(scene.level)},
                      {"gap of the outlines", shown(scene.gap, 3) + " m"}};
    lesson.numbers["level"] = count(static_cast<std::uint64_t>(scene.level));
    lesson.numbers["gap"] = number(scene.gap, 3, "m");
    add_step(
        lesson, "Two nodes overlap",
        "A gear (A) and a star (B) fly towards each other. The traversal was interrupted at "
        "level " +
            std::to_string(scene.level) +
            ", and one pair of nodes is in the front. The outlines are still {{number: gap}} "
            "apart, but there is no time to find out: *possible* now counts as a collision.\n\n"
            "To push bodies apart we need three things: a direction, a point, and a strength. All "
            "we have is two circles.\n\n"
            "**Predict:** which direction would you take, and which point?",
        std::move(figure), {{"gap of the outlines", "gap"}});
}

void step_normal(Lesson& lesson, const Scene& scene) {
    viz::Panel panel = nodes_panel(scene);
    add_centres(panel, scene.node_a, scene.node_b);
    const Vec from = scene.contact.point;
    add_arrow(panel, viz::Role::normal, from,
              from + 0.6 * scene.node_b.radius * scene.contact.normal, "*n*");
    lesson.numbers["normal"] = {scene.contact.normal.x(), vector_text(scene.contact.normal)};
    add_step(lesson, "Which way: along the line of the centres",
             "The line from the centre o_a to the centre o_b is the direction in which the two "
             "circles meet. Made one unit long it is the contact normal n = {{number: normal}}. By "
             "convention it points **from A towards B**: B will be pushed along n, A against it. "
             "Swap the bodies and n changes its sign, while what happens stays the same.",
             figure_of(std::move(panel), "The normal is the line of the centres",
                       "The two nodes with the line through their centres and the normal, an arrow "
                       "from A towards B."),
             {{"n", "normal"}}, "normal");
}

void step_point(Lesson& lesson, const Scene& scene) {
    viz::Panel panel = nodes_panel(scene);
    add_centres(panel, scene.node_a, scene.node_b);
    add_dot(panel, viz::Role::contact, scene.contact.point);
    add_label(panel, viz::Role::contact, scene.contact.point, "*c*");
    const double d = (scene.node_b.centre - scene.node_a.centre).norm();
    const double share = scene.node_a.radius / (scene.node_a.radius + scene.node_b.radius);
    lesson.numbers["R_a"] = number(scene.node_a.radius, 3, "m");
    lesson.numbers["R_b"] = number(scene.node_b.radius, 3, "m");
    lesson.numbers["d"] = number(d, 3, "m");
    lesson.numbers["share"] = number(share, 3);
    lesson.numbers["c from o_a"] =
        number((scene.contact.point - scene.node_a.centre).norm(), 3, "m");
    lesson.numbers["depth"] = number(scene.contact.depth, 3, "m");
    add_step(
        lesson, "Where: in the ratio of the radii",
        "The point lies on the same line. It divides the distance d = {{number: d}} as the radii "
        "R_a = {{number: R_a}} and R_b = {{number: R_b}} are to each other: a share of {{number: "
        "share}} of the way, {{number: c from o_a}} from o_a. The smaller circle is nearer to the "
        "point. The circles overlap by the depth {{number: depth}}.",
        figure_of(std::move(panel), "The point divides the line as the radii do",
                  "The contact point c on the line of the centres, nearer to the smaller node."),
        {{"d", "d"}, {"c from o_a", "c from o_a"}});
}

/// The example: radii 2 and 1, centres 2 apart.
void step_two_points(Lesson& lesson) {
    // listing: two points
    const Sphere<2> a{Vec(0, 0), 2};
    const Sphere<2> b{Vec(2, 0), 1};
    const auto ratio = lod::model_contact<2>(a, b, lod::PointModel::radius_ratio);
    const auto plane = lod::model_contact<2>(a, b, lod::PointModel::plane_of_intersection);
    // end of listing
    viz::Panel panel;
    panel.view = box(-2.6, -2.2, 4.4, 2.2);
    add_ball(panel, a, style(viz::Role::meeting_node, 0));
    add_ball(panel, b, style(viz::Role::meeting_node, 1));
    add_centres(panel, a, b);
    const double half = std::sqrt(a.radius * a.radius - plane->point.x() * plane->point.x());
    add_line(panel, viz::Role::reference, plane->point + Vec(0, -half),
             plane->point + Vec(0, half));
    add_dot(panel, viz::Role::contact, ratio->point);
    add_dot(panel, viz::Role::contact, plane->point);
    add_label(panel, viz::Role::note, ratio->point, "ratio");
    add_label(panel, viz::Role::note, plane->point, "plane");
    lesson.numbers["ratio point"] = number(ratio->point.x(), 4, "m");
    lesson.numbers["plane point"] = number(plane->point.x(), 4, "m");
    viz::Figure figure =
        figure_of(std::move(panel), "Two points that the paper calls one",
                  "Circles of radius 2 m and 1 m, centres 2 m apart. The point in the ratio of the "
                  "radii lies left of the plane of intersection.");
    figure.numbers = {{"ratio of the radii", shown(ratio->point.x(), 4) + " m"},
                      {"plane of intersection", shown(plane->point.x(), 4) + " m"}};
    add_step(lesson, "The other point: the plane of intersection",
             "The paper says that the point lies on the *plane of intersection* of the two "
             "circles, the straight line through the two points where they cross. Check it: with "
             "R_a = 2, R_b = 1 and d = 2 the ratio of the radii gives {{number: ratio point}}, the "
             "plane {{number: plane point}}. They are two different points! They agree when the "
             "radii are equal, or when the circles only just touch. lodlab takes the ratio, as the "
             "paper's equation does, and offers the plane by name.",
             std::move(figure), {{"ratio", "ratio point"}, {"plane", "plane point"}}, "two points");
}

void step_closing(Lesson& lesson, const Scene& scene) {
    viz::Panel panel = bodies_panel(scene);
    const Vec p = scene.contact.point;
    const Vec r_a = p - scene.gear.body.position;
    const Vec r_b = p - scene.star.body.position;
    add_line(panel, viz::Role::construction, scene.gear.body.position, p);
    add_line(panel, viz::Role::construction, scene.star.body.position, p);
    add_label(panel, viz::Role::note, scene.gear.body.position + r_a / 2, "*r*_a");
    add_label(panel, viz::Role::note, scene.star.body.position + r_b / 2, "*r*_b");
    const Vec at_a = lod::velocity_at(scene.gear.body, r_a);
    const Vec at_b = lod::velocity_at(scene.star.body, r_b);
    add_arrow(panel, viz::Role::velocity, p, p + velocity_length * at_a, "A at *c*", 0);
    add_arrow(panel, viz::Role::velocity, p, p + velocity_length * at_b, "B at *c*", 1);
    add_motion(panel, scene.gear, 0);
    add_motion(panel, scene.star, 1);
    const double v_c = lod::closing_velocity(scene.gear.body, scene.star.body, scene.contact);
    lesson.numbers["v_c"] = number(v_c, 3, "m/s");
    viz::Figure figure = figure_of(std::move(panel), "How fast do they meet at that point?",
                                   "The gear and the star with their velocities, and the "
                                   "velocities of their two material points at the contact.");
    figure.numbers = {{"closing velocity *v*_c", shown(v_c, 3) + " m/s"}};
    add_step(lesson, "How fast they close",
             "Both bodies turn, so their material points at c move differently from their centres. "
             "A body's point at the arm r has the velocity v + ω × r. At c the gear moves with " +
                 vector_text(at_a) + " m/s, the star with " + vector_text(at_b) +
                 " m/s. Of the difference, only the part along n matters: the closing velocity v_c "
                 "= {{number: v_c}}. It is negative, so the bodies **approach**.",
             std::move(figure), {{"v_c", "v_c"}}, "closing");
}

void step_compliance(Lesson& lesson, const Scene& scene) {
    viz::Panel panel = bodies_panel(scene);
    const Vec p = scene.contact.point;
    const Vec n = scene.contact.normal;
    const Vec far = n * 1.2;
    add_line(panel, viz::Role::construction, p - far, p + far);
    for (const viz::Actor<2>* one : {&scene.gear, &scene.star}) {
        const Vec x = one->body.position;
        const Vec foot = p + n * n.dot(x - p);
        const int index = one == &scene.gear ? 0 : 1;
        add_line(panel, viz::Role::curve, x, foot, index);
        add_dot(panel, viz::Role::contact, x);
        add_label(panel, viz::Role::note, (x + foot) / 2,
                  "lever " + shown((foot - x).norm(), 2) + " m");
    }
    add_arrow(panel, viz::Role::normal, p, p + normal_length * n, "*n*");
    const auto turning = [&](const Body<2>& body) {
        const double moment = lod::Space<2>::moment(p - body.position, n)[0];
        return moment * moment * body.inverse_inertia(0, 0);
    };
    const Body<2>& a = scene.gear.body;
    const Body<2>& b = scene.star.body;
    const double k = lod::inverse_effective_mass(a, b, scene.contact);
    lesson.numbers["K"] = number(k, 3, "1/kg");
    lesson.numbers["K mass a"] = number(a.inverse_mass, 3);
    lesson.numbers["K mass b"] = number(b.inverse_mass, 3);
    lesson.numbers["K turn a"] = number(turning(a), 3);
    lesson.numbers["K turn b"] = number(turning(b), 3);
    viz::Figure figure =
        figure_of(std::move(panel), "How easily does the contact give way?",
                  "The line of the push through the contact point, and the lever of each body: the "
                  "distance of its centre of mass from that line.");
    figure.numbers = {{"*K*", shown(k, 3) + " 1/kg"}};
    add_step(lesson, "How easily they give way",
             "Push with an impulse of 1 N s along n. By how much does v_c change? That is K. Light "
             "bodies give way easily, and so do bodies that can turn: the longer the *lever*, the "
             "distance of the centre of mass from the line of the push, the more of the push goes "
             "into spin.\n\n"
             "K = 1/m_a + 1/m_b + turning of A + turning of B = {{number: K mass a}} + {{number: K "
             "mass b}} + {{number: K turn a}} + {{number: K turn b}} = {{number: K}}.",
             std::move(figure), {{"K", "K"}}, "levers");
}

void step_impulse(Lesson& lesson, const Scene& scene, const Scene& after) {
    viz::Panel panel = bodies_panel(scene);
    const Vec p = scene.contact.point;
    const double j = lod::single_impulse(scene.gear.body, scene.star.body, scene.contact);
    const Vec push = impulse_length * j * scene.contact.normal;
    add_arrow(panel, viz::Role::impulse, p, p + push, "*j n* on B");
    add_arrow(panel, viz::Role::impulse, p, p - push, "−*j n* on A");
    lesson.numbers["j"] = number(j, 3, "N s");
    const std::vector<Body<2>> before{scene.gear.body, scene.star.body};
    const std::vector<Body<2>> then{after.gear.body, after.star.body};
    lesson.numbers["energy before"] = number(lod::kinetic_energy<2>(before), 4, "J");
    lesson.numbers["energy after"] = number(lod::kinetic_energy<2>(then), 4, "J");
    viz::Figure figure = figure_of(std::move(panel), "One impulse, equal and opposite",
                                   "Two green arrows of equal length at the contact point: the "
                                   "impulse on the star along the normal, on the gear against it.");
    figure.numbers = {{"impulse *j*", shown(j, 3) + " N s"}};
    add_step(lesson, "How hard",
             "The impulse shall turn the closing velocity round: from v_c to −e v_c, where e is "
             "the restitution, 1 for a perfect bounce. It has to change v_c by −(1 + e) v_c, and "
             "every N s changes it by K. So j = −(1 + e) v_c / K = {{number: j}}. What B gets "
             "along n, A gets against it: momentum is kept, whatever j is.",
             std::move(figure), {{"j", "j"}}, "impulse");
}

void step_after(Lesson& lesson, const Scene& scene, const Scene& after) {
    viz::Panel panel = bodies_panel(after);
    add_motion(panel, after.gear, 0);
    add_motion(panel, after.star, 1);
    const double v_c = lod::closing_velocity(after.gear.body, after.star.body, after.contact);
    const double again = lod::single_impulse(after.gear.body, after.star.body, after.contact);
    // Equation (1) without asking whether the bodies approach: a pull.
    const double ungated =
        -2 * v_c / lod::inverse_effective_mass(after.gear.body, after.star.body, after.contact);
    lesson.numbers["v_c after"] = number(v_c, 3, "m/s");
    lesson.numbers["second j"] = number(again, 0, "N s");
    lesson.numbers["pull"] = number(ungated, 3, "N s");
    viz::Figure figure =
        figure_of(std::move(panel), "They part as fast as they came",
                  "The gear and the star with their velocities after the impulse.");
    figure.numbers = {{"*v*_c", shown(v_c, 3) + " m/s"},
                      {"energy", lesson.numbers["energy after"].text}};
    const auto motion = [](const Body<2>& body) {
        return vector_text(body.velocity) + " m/s, spin " + shown(body.spin[0], 3) + " rad/s";
    };
    add_step(
        lesson, "After the impulse",
        "The gear now moves with " + motion(after.gear.body) +
            " (before: " + motion(scene.gear.body) + "), the star with " + motion(after.star.body) +
            " (before: " + motion(scene.star.body) +
            "). v_c is {{number: v_c after}}, the kinetic energy {{number: energy after}} as "
            "before.\n\n"
            "**Predict:** in the next frame the nodes still overlap a little. Shall we push again?",
        std::move(figure),
        {{"v_c", "v_c after"},
         {"energy before", "energy before"},
         {"energy after", "energy after"}});
    viz::Panel parting = bodies_panel(after);
    add_ball(parting, scene.node_a, style(viz::Role::meeting_node, 0));
    add_ball(parting, scene.node_b, style(viz::Role::meeting_node, 1));
    viz::Figure gate =
        figure_of(std::move(parting), "Only approaching bodies are pushed",
                  "The nodes of the gear and the star still overlap while the bodies part.");
    gate.numbers = {{"*v*_c", shown(v_c, 3) + " m/s"}, {"impulse", shown(again, 0) + " N s"}};
    add_step(lesson, "The gate: only those that approach",
             "No. v_c is positive, they part already, and lodlab gives an impulse of {{number: "
             "second j}}. The equation alone would say j = {{number: pull}}, a *pull*: it would "
             "turn the parting bodies round again, every frame anew, and they would stick "
             "together. The method does not move bodies back to the instant of the impact, so "
             "overlaps of parting bodies are usual, and the gate v_c < 0 is needed.",
             std::move(gate), {{"impulse", "second j"}});
}

}  // namespace

void make_contact_and_impulse(Lesson& lesson) {
    const Scene scene = impact::make_scene();
    Scene after = scene;
    // listing: respond
    Body<2>& a = after.gear.body;
    Body<2>& b = after.star.body;
    const double j = lod::single_impulse(a, b, after.contact);
    lod::apply_impulse(a, b, after.contact, j);
    // end of listing
    step_nodes(lesson, scene);
    step_normal(lesson, scene);
    step_point(lesson, scene);
    step_two_points(lesson);
    step_closing(lesson, scene);
    step_compliance(lesson, scene);
    step_impulse(lesson, scene, after);
    step_after(lesson, scene, after);
    impact::add_many_contacts(lesson);
    impact::animate(lesson, scene);
}

}  // namespace lessons
