#include <algorithm>
#include <array>

#include "lessons/course/08_many_contacts/lesson.hpp"
#include "lodlab/lod2d/shape/generators.hpp"

namespace lessons::many {
namespace {

using lod::Body;
using lod::Response;
using Vec = lod::Vector<2>;

// listing: landing
/// A 2 x 1 box of 1 kg that falls flat on a floor at 1 m/s, with contacts spread evenly along its
/// foot.
Touching falling(int contacts, double restitution = 1) {
    Body<2> floor;
    lod::make_static(floor);
    Body<2> box;
    lod::set_mass(box, 1.0, lod::Inertia<2>::Constant((2.0 * 2.0 + 1.0 * 1.0) / 12));
    box.restitution = restitution;
    box.position = Vec(0, 0.5);
    box.velocity = Vec(0, -1);
    Touching landing;
    landing.bodies = {floor, box};
    for (int i = 0; i < contacts; ++i) {
        const double x = contacts == 1 ? 0 : -1 + 2.0 * i / (contacts - 1);
        landing.impacts.push_back({0, 1, 0, {Vec(x, 0), Vec(0, 1), 0}});
    }
    landing.impulses.assign(landing.impacts.size(), 0.0);
    return landing;
}
// end of listing

/// Energy after / before.
double share(Response response, int contacts, double restitution = 1) {
    const Touching before = falling(contacts, restitution);
    return answered(before, response).energy() / before.energy();
}

constexpr std::array<std::pair<Response, const char*>, 3> ways{
    {{Response::sum, "sum"}, {Response::mean, "mean"}, {Response::net, "net"}}};

/// As many digits as tell: 0.0035, 0.031, 4.74, 357.
std::string share_text(double share) {
    if (share < 0.01) return shown(share, 4);
    if (share < 0.9995) return shown(share, 3);
    return shown(share, share < 100 ? 2 : 0);
}

/// Boxes on a floor, with their impulses and velocities.
viz::Panel draw(const Touching& landing, double top) {
    constexpr double velocity_length = 0.6;
    const double right = landing.bodies.back().position.x() + 1.7;
    viz::Panel panel;
    panel.view = box(-1.8, -0.4, right + 0.1, top);
    viz::Actor<2> floor;
    floor.visual = {"floor", {{{-1.7, -0.25}, {right, -0.25}, {right, 0}, {-1.7, 0}}}};
    add_body(panel, floor, 0);
    for (std::size_t i = 1; i < landing.bodies.size(); ++i) {
        viz::Actor<2> one;
        one.visual = {"box", {{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}}};
        one.body = landing.bodies[i];
        const auto index = static_cast<int>(i);
        add_body(panel, one, index);
        const Vec above = one.body.position + Vec(0, 0.55);
        const Vec& v = one.body.velocity;
        add_arrow(panel, viz::Role::velocity, above, above + velocity_length * v,
                  shown(v.y(), 2) + " m/s", index);
    }
    for (std::size_t i = 0; i < landing.impacts.size(); ++i) {
        const Vec& point = landing.impacts[i].contact.point;
        add_dot(panel, viz::Role::contact, point);
        if (landing.impulses[i] > 0) add_push(panel, point, Vec(0, 0.7 * landing.impulses[i]));
    }
    return panel;
}

void give_answers(Lesson& lesson) {
    constexpr int contacts = 4;
    viz::Figure figure;
    figure.columns = 3;
    for (const auto& [response, name] : ways) {
        viz::Panel panel = draw(answered(falling(contacts), response), 3.1);
        panel.title = std::string(name) + ": × " + share_text(share(response, contacts));
        figure.panels.push_back(std::move(panel));
    }
    give(lesson, "four contacts", draw(falling(contacts), 2.1));
    give(lesson, "single j", number(answered(falling(1), Response::net).impulses[0], 3, "N s"));
    give(lesson, "landing", std::move(figure));
}

void give_meter(Lesson& lesson) {
    constexpr int most = 64;
    viz::Panel panel;
    panel.view = box(1, 1e-3, most, 2e4);
    panel.axes = viz::Axes{{"contacts", viz::Scale::logarithmic, {1, 2, 4, 8, 16, 32, 64}, true},
                           {"energy after / before", viz::Scale::logarithmic, {}, false}};
    int series = 0;
    for (const auto& [response, name] : {ways[2], ways[0], ways[1]}) {
        viz::Polyline curve = lessons::curve(series++, name);
        for (int contacts = 1; contacts <= most; ++contacts)
            curve.points.push_back({static_cast<double>(contacts), share(response, contacts)});
        for (const int contacts : {2, 3, 4, 16, 64})
            give(lesson, std::string(name) + " " + std::to_string(contacts),
                 words(share_text(share(response, contacts)), share(response, contacts)));
        panel.marks.push_back(std::move(curve));
    }
    give(lesson, "energy meter", std::move(panel));
}

/// Two corners, by hand: what one asks for, and what is right.
void give_corners(Lesson& lesson) {
    const Touching before = falling(2);
    const Touching sum = answered(before, Response::sum);
    const Touching net = answered(before, Response::net);
    give(lesson, "corner K",
         number(lod::inverse_effective_mass(before.bodies[0], before.bodies[1],
                                            before.impacts[0].contact),
                1, "1/kg"));
    give(lesson, "corner j", number(sum.impulses[0], 3, "N s"));
    give(lesson, "both corners", number(sum.impulses[0] + sum.impulses[1], 3, "N s"));
    give(lesson, "short speed", number(sum.bodies[1].velocity.y(), 3, "m/s"));
    give(lesson, "right corner j", number(net.impulses[0], 0, "N s"));
    give(lesson, "corner factor", number(net.impulses[0] / sum.impulses[0], 2));
    give(lesson, "corners", draw(sum, 2.1), {{"*K* of a corner", "corner K"}});
}

/// An L that lands on its foot off its centre, so that it must turn.
void give_letter(Lesson& lesson) {
    constexpr int contacts = 8;
    const lod2d::Shape shape = lod2d::generate("L");
    const lod2d::Box bounds = lod2d::bounds(shape.polygon);
    const double foot = bounds.low.y();
    viz::Actor<2> letter = actor("L", shape);
    viz::Actor<2> floor = actor("floor", lod2d::generate("box:2.4,0.15"));
    lod::make_static(floor.body);
    floor.body.position = Vec(0, foot - 0.075);
    letter.body.velocity = Vec(0, -1);
    Touching landing{{floor.body, letter.body}, {}, {}};
    for (int i = 0; i < contacts; ++i) {
        const Vec point(bounds.low.x() + 1.0 * i / (contacts - 1), foot);
        landing.impacts.push_back({0, 1, 0, {point, Vec(0, 1), 0}});
    }
    const double before = landing.energy();
    landing = answered(std::move(landing), Response::net);
    letter.body = landing.bodies[1];
    viz::Panel panel;
    panel.view = box(-1.0, foot - 0.25, 1.0, 1.0);
    add_body(panel, floor, 0);
    add_body(panel, letter, 1);
    for (std::size_t i = 0; i < landing.impacts.size(); ++i)
        add_push(panel, landing.impacts[i].contact.point, Vec(0, 1.5 * landing.impulses[i]));
    add_arrow(panel, viz::Role::velocity, letter.body.position,
              letter.body.position + 0.4 * letter.body.velocity, "*v*_b", 1);
    give(lesson, "L energy", number(landing.energy() / before, 12));
    give(lesson, "L spin", number(letter.body.spin[0], 3, "rad/s"));
    give(lesson, "L speed", number(letter.body.velocity.y(), 3, "m/s"));
    give(lesson, "half bounce", number(share(Response::net, 16, 0.5), 3));
    give(lesson, "net", std::move(panel),
         {{"energy after / before", "L energy"}, {"spin", "L spin"}});
}

/// Two boxes land on one floor in the same instant: what the one changes for the other [m/s].
void give_floor(Lesson& lesson) {
    Touching both = falling(4);
    Touching other = falling(2, 0.5);
    both.bodies.push_back(other.bodies[1]);
    both.bodies[2].position.x() = 2.6;
    for (lod::Impact<2>& impact : other.impacts) {
        impact.b = 2;
        impact.pair = 1;
        impact.contact.point.x() += 2.6;
        both.impacts.push_back(impact);
    }
    const Touching alone = answered(falling(4), Response::net);
    const Touching together = answered(both, Response::net);
    give(lesson, "neighbour speed", number(together.bodies[2].velocity.y(), 2, "m/s"));
    give(lesson, "floor speed", number(together.bodies[1].velocity.y(), 2, "m/s"));
    give(lesson, "floor change",
         number(together.bodies[1].velocity.y() - alone.bodies[1].velocity.y(), 0, "m/s"));
    give(lesson, "floor", draw(together, 2.2));
}

}  // namespace

void give_landings(Lesson& lesson) {
    give_answers(lesson);
    give_meter(lesson);
    give_corners(lesson);
    give_letter(lesson);
    give_floor(lesson);
}

}  // namespace lessons::many
