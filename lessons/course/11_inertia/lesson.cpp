#include "lessons/course/11_inertia/lesson.hpp"

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

double degrees_between(const Vec& a, const Vec& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) / degree;
}

Number degrees(double angle, int decimals) {
    return words(shown(angle, decimals) + "°", angle);
}

namespace {

void give_three_numbers(Lesson& lesson, const Crate& crate) {
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
        give(lesson, key, number(inertia(axis, axis), 2, "kg m²"));
        add_arrow<3>(panel, viz::Role::normal, Vec::Zero(), length * Vec::Unit(axis),
                     std::string("*") + name + "*: " + lesson.numbers[key].text);
    }
    give(lesson, "inertia error", tiny((inertia - expected).cwiseAbs().maxCoeff(), "kg m²"));
    give(lesson, "mass", number(crate.mass, 0, "kg"));
    give(lesson, "axes", std::move(panel));
}

void give_turned(Lesson& lesson, Crate crate) {
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
    give(lesson, "I xx", number(world(0, 0), 3));
    give(lesson, "I xy", number(world(0, 1), 3));
    give(lesson, "I yy", number(world(1, 1), 3));
    give(lesson, "I zz", number(world(2, 2), 3));
    give(lesson, "momentum", words(vector_text<3>(momentum) + "\u00a0kg\u00a0m²/s", momentum.x()));
    give(lesson, "tilt", degrees(degrees_between(body.spin, momentum)));
    give(lesson, "turned", std::move(panel));
}

/// The lower corner that touches the floor, from the centre of mass.
Vec corner_of(const Crate& crate) {
    return Vec(crate.width, -crate.height, crate.depth) / 2;
}

void give_push(Lesson& lesson, Crate crate) {
    Body<3>& body = crate.actor.body;
    const Vec r = corner_of(crate);
    const Vec push(0, 1, 0);           // one newton second, upwards
    const Vec moment = r.cross(push);  // what it does to the angular momentum
    body.spin += lod::world_inverse_inertia(body) * moment;
    give(lesson, "moment", words(vector_text<3>(moment, 1), moment.x()));
    give(lesson, "push spin", words(vector_text<3>(body.spin, 4) + "\u00a0rad/s", body.spin.x()));
    give(lesson, "push angle", degrees(degrees_between(moment, body.spin)));
    constexpr double push_length = 0.75;  // past the crate, so that its word stands on the paper
    constexpr double moment_length = 1.5;
    constexpr double spin_length = 1.7;
    viz::Panel panel = panel_round(crate, 0.78);
    viz::add_body(panel, crate.actor, 0);
    add_dot<3>(panel, viz::Role::contact, r);
    add_arrow<3>(panel, viz::Role::impulse, r, r + push_length * push, "push");
    add_arrow<3>(panel, viz::Role::normal, Vec::Zero(), moment_length * moment, "*r* × push");
    give(lesson, "corner push", panel);
    add_arrow<3>(panel, viz::Role::velocity, Vec::Zero(), spin_length * body.spin, "spin *ω*", 1);
    give(lesson, "push", std::move(panel));
}

void give_corner(Lesson& lesson, const Crate& crate) {
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
    give(lesson, "K", number(K, 4, "1/kg"));
    give(lesson, "j", number(j, 4, "N s"));
    give(lesson, "K flat",
         number(lod::inverse_effective_mass(flat_floor, flat_box, flat_contact), 4, "1/kg"));
    give(lesson, "K turn x", number(r.z() * r.z() / box.inertia(0, 0), 4));
    give(lesson, "K turn z", number(r.x() * r.x() / box.inertia(2, 2), 4));
    give(lesson, "K mass", number(1 / crate.mass, 4));
    give(lesson, "energy before", number(energy_before, 4, "J"));
    give(lesson, "energy after", number(lod::kinetic_energy<3>({&box, 1}), 4, "J"));
    give(lesson, "corner spin", words(vector_text<3>(box.spin) + "\u00a0rad/s", box.spin.x()));
    give(lesson, "corner speed", number(box.velocity.y(), 3, "m/s"));
    viz::Panel panel = panel_round(crate, 0.72);
    constexpr double post = 0.2;  // [m]
    panel.space->ground->height = r.y() - post;
    viz::add_body(panel, crate.actor, 0);
    constexpr double impulse_length = 0.115;  // past the crate, too
    constexpr double spin_length = 0.25;
    add_line<3>(panel, viz::Role::wall, r - Vec(0, post, 0), r);
    add_dot<3>(panel, viz::Role::contact, r);
    add_arrow<3>(panel, viz::Role::impulse, r, r + impulse_length * j * contact.normal,
                 "*j* = " + lesson.numbers["j"].text);
    add_arrow<3>(panel, viz::Role::velocity, Vec::Zero(), spin_length * box.spin, "spin after", 1);
    give(lesson, "corner", std::move(panel), {{"*K*", "K"}});
}

}  // namespace
}  // namespace inertia

void make_inertia(Lesson& lesson) {
    const inertia::Crate crate = inertia::make_crate();
    inertia::give_three_numbers(lesson, crate);
    inertia::give_turned(lesson, crate);
    inertia::give_push(lesson, crate);
    inertia::give_corner(lesson, crate);
    inertia::give_tumbling(lesson, crate);
}

}  // namespace lessons
