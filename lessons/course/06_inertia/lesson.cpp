#include "lessons/course/06_inertia/lesson.hpp"

#include <cmath>

#include "lodlab/core/response/impact.hpp"
#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/solid/generators.hpp"

namespace lessons {
namespace inertia {

constexpr double degree = 3.14159265358979323846 / 180;

Crate make_crate() {
    Crate crate;
    const lod3d::Solid box = lod3d::generate("box:1,0.6,0.2");
    const auto tree = std::make_shared<const lod::SphereTree<3>>(
        lod3d::build_tree(box, {.depth = 1, .effort = 0}));
    crate.actor = actor("crate", box, tree);
    lod::set_mass(crate.actor.body, crate.mass, crate.mass / box.volume * box.second_moment);
    return crate;
}

viz::Panel panel_round(const Crate& crate, double reach) {
    viz::View<3> view(viz::Viewpoint{.azimuth = 0.5, .elevation = 0.35});
    view.take_in(crate.actor.body.position, reach);
    return viz::blank_panel<3>(view);
}

lod::Spin<3> momentum_of(const Body<3>& body) {
    return lod::Space<3>::carried(body.orientation, body.inertia) * body.spin;
}

std::string vector_text(const Vec& v, int decimals) {
    std::string text = "(";
    text += shown(v.x(), decimals) + ", " + shown(v.y(), decimals) + ", ";
    return text + shown(v.z(), decimals) + ")";
}

double degrees_between(const Vec& a, const Vec& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) / degree;
}

Number degrees(double angle, int decimals) {
    return {angle, shown(angle, decimals) + "°"};
}

namespace {

void step_three_numbers(Lesson& lesson, const Crate& crate) {
    const double w2 = crate.width * crate.width;
    const double h2 = crate.height * crate.height;
    const double d2 = crate.depth * crate.depth;
    const Vec by_hand = crate.mass / 12 * Vec(h2 + d2, w2 + d2, w2 + h2);
    const lod::Inertia<3>& inertia = crate.actor.body.inertia;
    const lod::Inertia<3> expected = by_hand.asDiagonal();
    viz::Panel panel = panel_round(crate, 0.76);
    viz::add_body(panel, crate.actor, 0);
    constexpr double length = 0.72;  // of an axis [m]
    for (const auto& [axis, name] : {std::pair{0, "x"}, {1, "y"}, {2, "z"}}) {
        const std::string key = std::string("I ") + name;
        lesson.numbers[key] = number(inertia(axis, axis), 2, "kg m²");
        add_arrow<3>(panel, viz::Role::normal, Vec::Zero(), length * Vec::Unit(axis),
                     std::string("*") + name + "*: " + lesson.numbers[key].text);
    }
    lesson.numbers["inertia error"] = tiny((inertia - expected).cwiseAbs().maxCoeff(), "kg m²");
    lesson.numbers["mass"] = number(crate.mass, 0, "kg");
    add_step(lesson, "Three numbers where the plane has one",
             "In the plane a body can turn about one axis only, and one number says how hard that "
             "is. A crate in space, 1 m wide, 0.6 m high, 0.2 m deep and {{number: mass}}, has "
             "three such axes. Mass far from an axis makes turning about it hard: m/12 times the "
             "squares of the two sides *across* the axis. About its long side x that is 0.6² + "
             "0.2² = {{number: I x}}, about y {{number: I y}}, about z {{number: I z}}. lodlab "
             "finds the same from the crate's twelve triangles by exact integrals, to {{number: "
             "inertia error}}.\n\n"
             "**Predict:** you turn the crate by 30° about z and set it spinning about the room's "
             "x axis. Which of the three numbers counts?",
             figure_of(std::move(panel), "How hard is it to turn?",
                       "A flat crate with its three axes and the moment of inertia about each."),
             {{"about x", "I x"}, {"about y", "I y"}, {"about z", "I z"}});
}

void step_turned(Lesson& lesson, Crate crate) {
    Body<3>& body = crate.actor.body;
    // listing: turned
    const Vec turn(0, 0, 30 * degree);
    body.orientation = lod::Space<3>::turned(lod::Space<3>::unturned(), turn);
    const lod::Matrix<3> R = lod::Space<3>::rotation(body.orientation);
    const lod::Inertia<3> world = R * body.inertia * R.transpose();
    body.spin = Vec(1, 0, 0);
    const Vec momentum = world * body.spin;
    // end of listing
    viz::Panel panel = panel_round(crate, 0.82);
    viz::add_body(panel, crate.actor, 0);
    constexpr double spin_length = 0.85;     // metres of arrow for a radian a second
    constexpr double momentum_length = 1.4;  // metres of arrow for a kilogram square metre a second
    add_arrow<3>(panel, viz::Role::velocity, Vec::Zero(), spin_length * body.spin, "spin *ω*", 1);
    add_arrow<3>(panel, viz::Role::impulse, Vec::Zero(), momentum_length * momentum, "*I ω*");
    lesson.numbers["I xx"] = number(world(0, 0), 3);
    lesson.numbers["I xy"] = number(world(0, 1), 3);
    lesson.numbers["I yy"] = number(world(1, 1), 3);
    lesson.numbers["I zz"] = number(world(2, 2), 3);
    lesson.numbers["momentum"] = {momentum.x(), vector_text(momentum) + "\u00a0kg\u00a0m²/s"};
    lesson.numbers["tilt"] = degrees(degrees_between(body.spin, momentum));
    add_step(
        lesson, "The numbers turn with the body",
        "Two of them, mixed. The crate carries its axes with it, so in the room its inertia "
        "is R I R^T: take a vector into the body's frame (R^T), multiply by the three "
        "numbers, carry the result back (R). By hand, with cos² 30° = 0.75 and sin² 30° = "
        "0.25: the entry for x is 0.75 · 0.40 + 0.25 · 1.04 = {{number: I xx}}, and a new "
        "entry appears that couples x and y, 0.433 · (0.40 − 1.04) = {{number: I xy}}.\n\n"
        "So a spin of 1 rad/s about x has the angular momentum {{number: momentum}}. It does "
        "**not** point along x: the two arrows are {{number: tilt}} apart.",
        figure_of(std::move(panel), "Spin and angular momentum point different ways",
                  "The crate turned by 30 degrees, with the arrow of its spin to the right and "
                  "the arrow of its angular momentum pointing lower."),
        {{"angular momentum", "momentum"}, {"angle between", "tilt"}}, "turned");
}

/// The lower corner that touches the floor, from the centre of mass.
Vec corner_of(const Crate& crate) {
    return Vec(crate.width, -crate.height, crate.depth) / 2;
}

void steps_push(Lesson& lesson, Crate crate) {
    Body<3>& body = crate.actor.body;
    const Vec r = corner_of(crate);
    // listing: push
    const Vec push(0, 1, 0);           // one newton second, upwards
    const Vec moment = r.cross(push);  // what it does to the angular momentum
    body.spin += lod::world_inverse_inertia(body) * moment;
    // end of listing
    lesson.numbers["moment"] = {moment.x(), vector_text(moment, 1)};
    lesson.numbers["push spin"] = {body.spin.x(), vector_text(body.spin, 4) + "\u00a0rad/s"};
    lesson.numbers["push angle"] = degrees(degrees_between(moment, body.spin));
    constexpr double push_length = 0.45;
    constexpr double moment_length = 1.5;
    constexpr double spin_length = 1.7;
    viz::Panel panel = panel_round(crate, 0.78);
    viz::add_body(panel, crate.actor, 0);
    add_dot<3>(panel, viz::Role::contact, r);
    add_arrow<3>(panel, viz::Role::impulse, r, r + push_length * push, "push");
    add_arrow<3>(panel, viz::Role::normal, Vec::Zero(), moment_length * moment, "*r* × push");
    add_step(lesson, "A push off the centre",
             "The crate stands in its own axes again and hangs still. Push its lower right front "
             "corner upwards with 1 N s. The arm is r = (0.5, −0.3, 0.1), so the angular momentum "
             "becomes r × push = {{number: moment}}.\n\n"
             "**Predict:** about which axis does the crate turn?",
             figure_of(panel, "A push at a corner",
                       "The crate with a push at its lower front corner and the axis of the "
                       "torque."),
             {{"r × push", "moment"}});
    add_arrow<3>(panel, viz::Role::velocity, Vec::Zero(), spin_length * body.spin, "spin *ω*", 1);
    add_step(lesson, "It turns where turning is easy",
             "Not about the axis of the push. Each part is divided by its own number: −0.1 / 0.40 "
             "and 0.5 / 1.36 give a spin of {{number: push spin}}, **{{number: push angle}}** away "
             "from it. The crate gives way where it is easy.",
             figure_of(std::move(panel), "It turns where turning is easy",
                       "The same, with the axis of the spin, clearly apart from that of the "
                       "torque."),
             {{"spin", "push spin"}, {"angle between", "push angle"}}, "push");
}

void step_corner(Lesson& lesson, const Crate& crate) {
    const Vec r = corner_of(crate);
    // listing: corner
    Body<3> floor;
    lod::make_static(floor);
    Body<3> box = crate.actor.body;
    box.velocity = Vec(0, -1, 0);
    const lod::Contact<3> contact{box.position + r, Vec(0, 1, 0), 0};
    const double K = lod::inverse_effective_mass(floor, box, contact);
    const double j = lod::single_impulse(floor, box, contact);
    const double energy_before = lod::kinetic_energy<3>({&box, 1});
    lod::apply_impulse(floor, box, contact, j);
    // end of listing
    Body<2> flat_floor;
    lod::make_static(flat_floor);
    Body<2> flat_box;
    lod::set_mass(flat_box, crate.mass, lod::Inertia<2>::Constant(box.inertia(2, 2)));
    const lod::Contact<2> flat_contact{{r.x(), r.y()}, {0, 1}, 0};
    lesson.numbers["K"] = number(K, 4, "1/kg");
    lesson.numbers["j"] = number(j, 4, "N s");
    lesson.numbers["K flat"] =
        number(lod::inverse_effective_mass(flat_floor, flat_box, flat_contact), 4, "1/kg");
    lesson.numbers["K turn x"] = number(r.z() * r.z() / box.inertia(0, 0), 4);
    lesson.numbers["K turn z"] = number(r.x() * r.x() / box.inertia(2, 2), 4);
    lesson.numbers["K mass"] = number(1 / crate.mass, 4);
    lesson.numbers["energy before"] = number(energy_before, 4, "J");
    lesson.numbers["energy after"] = number(lod::kinetic_energy<3>({&box, 1}), 4, "J");
    lesson.numbers["corner spin"] = {box.spin.x(), vector_text(box.spin) + "\u00a0rad/s"};
    lesson.numbers["corner speed"] = number(box.velocity.y(), 3, "m/s");
    viz::Panel panel = panel_round(crate, 0.72);
    panel.space->ground->height = r.y();
    viz::add_body(panel, crate.actor, 0);
    constexpr double impulse_length = 0.08;
    constexpr double spin_length = 0.25;
    add_dot<3>(panel, viz::Role::contact, r);
    add_arrow<3>(panel, viz::Role::impulse, r, r + impulse_length * j * contact.normal,
                 "*j* = " + lesson.numbers["j"].text);
    add_arrow<3>(panel, viz::Role::velocity, Vec::Zero(), spin_length * box.spin, "spin after", 1);
    viz::Figure figure =
        figure_of(std::move(panel), "A crate lands on one corner",
                  "The crate on the floor, which it touches with its lower front corner. An "
                  "impulse points up from there; the spin after it points to the front.");
    figure.numbers = {{"*K*", lesson.numbers["K"].text}};
    add_step(lesson, "Equation 1 in space, by hand",
             "The same corner meets the floor at 1 m/s, with restitution 1. K asks how much the "
             "corner gives way to 1 N s along n: 1/m for the crate as a whole, and what the spin "
             "of the last step adds at the corner. With r × n = (−0.1, 0, 0.5):\n\n"
             "K = 1/12 + 0.1²/0.40 + 0.5²/1.36 = {{number: K mass}} + {{number: K turn x}} + "
             "{{number: K turn z}} = {{number: K}}, and j = 2/K = {{number: j}}.\n\n"
             "The crate leaves at {{number: corner speed}} with a spin of {{number: corner spin}}: "
             "its centre still falls, but it turns so fast that the corner goes up. Energy before "
             "{{number: energy before}}, after {{number: energy after}}. Without the depth of the "
             "crate, r_z = 0, the middle term goes and K is the plane's, {{number: K flat}}.",
             std::move(figure), {{"K", "K"}, {"j", "j"}, {"K in the plane", "K flat"}}, "corner");
}

}  // namespace
}  // namespace inertia

void make_inertia(Lesson& lesson) {
    const inertia::Crate crate = inertia::make_crate();
    inertia::step_three_numbers(lesson, crate);
    inertia::step_turned(lesson, crate);
    inertia::steps_push(lesson, crate);
    inertia::step_corner(lesson, crate);
    inertia::add_tumbling(lesson, crate);
}

}  // namespace lessons
