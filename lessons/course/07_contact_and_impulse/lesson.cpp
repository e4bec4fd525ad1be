#include "lessons/course/07_contact_and_impulse/lesson.hpp"

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

void give_nodes(Lesson& lesson, const Scene& scene) {
    viz::Panel panel = nodes_panel(scene);
    add_label(panel, viz::Role::body, scene.node_a.centre, "node of A", 0, scene.node_a.radius);
    add_label(panel, viz::Role::body, scene.node_b.centre, "node of B", 1, scene.node_b.radius);
    give(lesson, "level", count(scene.level));
    give(lesson, "gap", number(scene.gap, 3, "m"));
    give(lesson, "nodes", std::move(panel), {{"level", "level"}, {"gap of the outlines", "gap"}});
}

void give_normal(Lesson& lesson, const Scene& scene) {
    viz::Panel panel = nodes_panel(scene);
    add_centres(panel, scene.node_a, scene.node_b);
    const Vec from = scene.node_b.centre;
    const Vec n = scene.contact.normal;
    add_arrow(panel, viz::Role::normal, from, from + 2.5 * scene.node_b.radius * n, "*n*");
    give(lesson, "n", words(vector_text<2>(n), n.x()));
    give(lesson, "normal", std::move(panel));
}

void give_point(Lesson& lesson, const Scene& scene) {
    const Sphere<2>& a = scene.node_a;
    const Sphere<2>& b = scene.node_b;
    viz::Panel panel = nodes_panel(scene);
    add_centres(panel, a, b);
    add_dot(panel, viz::Role::contact, scene.contact.point);
    add_label(panel, viz::Role::contact, scene.contact.point, "*c*");
    give(lesson, "R_a", number(a.radius, 3, "m"));
    give(lesson, "R_b", number(b.radius, 3, "m"));
    give(lesson, "d", number((b.centre - a.centre).norm(), 3, "m"));
    give(lesson, "share", number(a.radius / (a.radius + b.radius), 3));
    give(lesson, "c from o_a", number((scene.contact.point - a.centre).norm(), 3, "m"));
    give(lesson, "depth", number(scene.contact.depth, 3, "m"));
    give(lesson, "point", std::move(panel));
}

/// The example: radii 2 and 1, centres 2 apart.
void give_two_points(Lesson& lesson) {
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
    give(lesson, "ratio point", number(ratio->point.x(), 4, "m"));
    give(lesson, "plane point", number(plane->point.x(), 4, "m"));
    give(lesson, "two points", std::move(panel),
         {{"ratio of the radii", "ratio point"}, {"plane of intersection", "plane point"}});
}

void give_closing(Lesson& lesson, const Scene& scene) {
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
    give(lesson, "v_c", number(v_c, 3, "m/s"));
    give(lesson, "gear at c", words(vector_text<2>(at_a) + " m/s", at_a.x()));
    give(lesson, "star at c", words(vector_text<2>(at_b) + " m/s", at_b.x()));
    give(lesson, "closing", std::move(panel), {{"closing velocity *v*_c", "v_c"}});
}

void give_compliance(Lesson& lesson, const Scene& scene) {
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
    give(lesson, "K", number(lod::inverse_effective_mass(a, b, scene.contact), 3, "1/kg"));
    give(lesson, "K mass a", number(a.inverse_mass, 3));
    give(lesson, "K mass b", number(b.inverse_mass, 3));
    give(lesson, "K turn a", number(turning(a), 3));
    give(lesson, "K turn b", number(turning(b), 3));
    give(lesson, "levers", std::move(panel), {{"*K*", "K"}});
}

void give_impulse(Lesson& lesson, const Scene& scene, const Scene& after) {
    viz::Panel panel = bodies_panel(scene);
    const Vec p = scene.contact.point;
    const double j = lod::single_impulse(scene.gear.body, scene.star.body, scene.contact);
    const Vec push = impulse_length * j * scene.contact.normal;
    add_arrow(panel, viz::Role::impulse, p, p + push, "*j n* on B");
    add_arrow(panel, viz::Role::impulse, p, p - push, "−*j n* on A");
    give(lesson, "j", number(j, 3, "N s"));
    const std::vector<Body<2>> before{scene.gear.body, scene.star.body};
    const std::vector<Body<2>> then{after.gear.body, after.star.body};
    give(lesson, "energy before", number(lod::kinetic_energy<2>(before), 4, "J"));
    give(lesson, "energy after", number(lod::kinetic_energy<2>(then), 4, "J"));
    give(lesson, "impulse", std::move(panel), {{"impulse *j*", "j"}});
}

Number motion(const Body<2>& body) {
    return words(vector_text<2>(body.velocity) + " m/s, spin " + shown(body.spin[0], 3) + " rad/s",
                 body.velocity.x());
}

void give_after(Lesson& lesson, const Scene& scene, const Scene& after) {
    const double v_c = lod::closing_velocity(after.gear.body, after.star.body, after.contact);
    const double again = lod::single_impulse(after.gear.body, after.star.body, after.contact);
    // Equation (1) without asking whether the bodies approach: a pull.
    const double ungated =
        -2 * v_c / lod::inverse_effective_mass(after.gear.body, after.star.body, after.contact);
    give(lesson, "v_c after", number(v_c, 3, "m/s"));
    give(lesson, "second j", number(again, 0, "N s"));
    give(lesson, "pull", number(ungated, 3, "N s"));
    for (const auto& [name, scene_then] : {std::pair{"before", &scene}, {"after", &after}}) {
        give(lesson, std::string("gear ") + name, motion(scene_then->gear.body));
        give(lesson, std::string("star ") + name, motion(scene_then->star.body));
    }
    viz::Panel panel = bodies_panel(after);
    add_motion(panel, after.gear, 0);
    add_motion(panel, after.star, 1);
    give(lesson, "after", std::move(panel), {{"*v*_c", "v_c after"}, {"energy", "energy after"}});
    viz::Panel parting = bodies_panel(after);
    add_ball(parting, scene.node_a, style(viz::Role::meeting_node, 0));
    add_ball(parting, scene.node_b, style(viz::Role::meeting_node, 1));
    viz::Figure gate = figure_of(std::move(parting));
    gate.numbers = {{"*v*_c", lesson.numbers["v_c after"].text},
                    {"impulse", lesson.numbers["second j"].text}};
    give(lesson, "gate", std::move(gate));
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
    give_nodes(lesson, scene);
    give_normal(lesson, scene);
    give_point(lesson, scene);
    give_two_points(lesson);
    impact::give_surface(lesson);
    give_closing(lesson, scene);
    give_compliance(lesson, scene);
    give_impulse(lesson, scene, after);
    give_after(lesson, scene, after);
    give(lesson, impact::play(scene));
    impact::animate(lesson, scene);
}

}  // namespace lessons
