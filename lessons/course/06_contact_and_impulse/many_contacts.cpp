#include <algorithm>
#include <array>
#include <cmath>

#include "lessons/course/06_contact_and_impulse/lesson.hpp"
#include "lodlab/core/response/response.hpp"
#include "lodlab/core/tree/traversal.hpp"
#include "lodlab/lod2d/shape/generators.hpp"

namespace lessons::impact {
namespace {

using lod::Body;
using lod::Response;
using Vec = lod::Vector<2>;

/// A 2 x 1 box of 1 kg that falls flat on a floor at 1 m/s, with contacts spread evenly along its
/// foot.
struct Landing {
    std::vector<Body<2>> bodies;  ///< floor, box
    std::vector<lod::Impact<2>> impacts;
    std::vector<double> impulses;
    double energy_before = 0;
    double energy_after = 0;

    [[nodiscard]] double share() const { return energy_after / energy_before; }
};

// listing: landing
Landing land(Response response, int contacts, double restitution = 1) {
    Landing landing;
    Body<2> floor;
    floor.restitution = restitution;
    lod::make_static(floor);
    Body<2> box;
    lod::set_mass(box, 1.0, lod::Inertia<2>::Constant((2.0 * 2.0 + 1.0 * 1.0) / 12));
    box.position = Vec(0, 0.5);
    box.velocity = Vec(0, -1);
    landing.bodies = {floor, box};
    for (int i = 0; i < contacts; ++i) {
        const double x = contacts == 1 ? 0 : -1 + 2.0 * i / (contacts - 1);
        landing.impacts.push_back({0, 1, 0, {Vec(x, 0), Vec(0, 1), 0}});
    }
    landing.energy_before = lod::kinetic_energy<2>(landing.bodies);
    lod::Resolver<2>().resolve(response, landing.impacts, landing.bodies, landing.impulses);
    landing.energy_after = lod::kinetic_energy<2>(landing.bodies);
    return landing;
}
// end of listing

constexpr std::array<std::pair<Response, const char*>, 3> ways{
    {{Response::sum, "sum"}, {Response::mean, "mean"}, {Response::net, "net"}}};

/// As many digits as tell: 0.0035, 0.031, 4.74, 357.
std::string share_text(double share) {
    if (share < 0.01) return shown(share, 4);
    if (share < 0.9995) return shown(share, 3);
    return shown(share, share < 100 ? 2 : 0);
}

void add_landing(viz::Panel& panel, const Landing& landing) {
    constexpr double velocity_length = 0.6;
    viz::Actor<2> box_actor;
    box_actor.visual = {"box", {{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}}};
    box_actor.body = landing.bodies[1];
    viz::Actor<2> floor;
    floor.visual = {"floor", {{{-1.7, -0.25}, {1.7, -0.25}, {1.7, 0}, {-1.7, 0}}}};
    add_body(panel, floor, 0);
    add_body(panel, box_actor, 1);
    for (std::size_t i = 0; i < landing.impacts.size(); ++i)
        if (landing.impulses[i] > 0)
            add_push(panel, landing.impacts[i].contact.point, Vec(0, 0.7 * landing.impulses[i]));
    const Vec v = landing.bodies[1].velocity;
    add_arrow(panel, viz::Role::velocity, Vec(0, 1.05), Vec(0, 1.05) + velocity_length * v,
              shown(v.y(), 2) + " m/s", 1);
}

void give_landing(Lesson& lesson) {
    constexpr int contacts = 4;
    viz::Figure figure;
    figure.columns = 3;
    for (const auto& [response, name] : ways) {
        const Landing landing = land(response, contacts);
        viz::Panel panel;
        panel.view = box(-1.8, -0.4, 1.8, 3.1);
        panel.title = std::string(name) + ": × " + share_text(landing.share());
        add_landing(panel, landing);
        figure.panels.push_back(std::move(panel));
    }
    Landing falling = land(Response::net, contacts);
    falling.bodies[1].velocity = Vec(0, -1);
    falling.impulses.assign(falling.impulses.size(), 0.0);
    viz::Panel before;
    before.view = box(-1.8, -0.4, 1.8, 2.1);
    add_landing(before, falling);
    for (const lod::Impact<2>& impact : falling.impacts)
        add_dot(before, viz::Role::contact, impact.contact.point);
    give(lesson, "four contacts", std::move(before));
    give(lesson, "single j", number(land(Response::net, 1).impulses[0], 3, "N s"));
    give(lesson, "landing", std::move(figure));
}

viz::Polyline curve_of(Response response, const char* name, int series, int most) {
    viz::Polyline curve = lessons::curve(series, name);
    for (int contacts = 1; contacts <= most; ++contacts)
        curve.points.push_back({static_cast<double>(contacts), land(response, contacts).share()});
    return curve;
}

void give_meter(Lesson& lesson) {
    constexpr int most = 64;
    constexpr double lowest = 1e-3;
    viz::Panel panel;
    panel.view = box(1, lowest, most, 2e4);
    panel.axes = viz::Axes{{"contacts", viz::Scale::logarithmic, {1, 2, 4, 8, 16, 32, 64}, true},
                           {"energy after / before", viz::Scale::logarithmic, {}, false}};
    int series = 0;
    for (const auto& [response, name] : {ways[2], ways[0], ways[1]})
        panel.marks.push_back(curve_of(response, name, series++, most));
    for (const int contacts : {2, 3, 4, 16, 64})
        for (const auto& [response, name] : ways) {
            const double share = land(response, contacts).share();
            give(lesson, std::string(name) + " " + std::to_string(contacts),
                 words(share_text(share), share));
        }
    give(lesson, "energy meter", std::move(panel));
}

/// An L that lands on its foot off its centre, so that it must turn.
struct LetterLanding {
    viz::Actor<2> letter;
    viz::Actor<2> floor;
    std::vector<lod::Impact<2>> impacts;
    std::vector<double> impulses;
    double share = 0;  ///< energy after / before
    double foot = 0;   ///< height of the floor [m]
};

LetterLanding land_letter() {
    constexpr int contacts = 8;
    const lod2d::Shape shape = lod2d::generate("L");
    LetterLanding landing;
    double left = 0;
    for (const lod2d::Point& p : shape.polygon.rings[0]) {
        landing.foot = std::min(landing.foot, p.y());
        left = std::min(left, p.x());
    }
    landing.letter = actor("L", shape);
    landing.letter.body.velocity = Vec(0, -1);
    landing.floor = actor("floor", lod2d::generate("box:2.4,0.15"));
    lod::make_static(landing.floor.body);
    landing.floor.body.position = Vec(0, landing.foot - 0.075);
    for (int i = 0; i < contacts; ++i) {
        const Vec point(left + 1.0 * i / (contacts - 1), landing.foot);
        landing.impacts.push_back({0, 1, 0, {point, Vec(0, 1), 0}});
    }
    std::vector<Body<2>> bodies{landing.floor.body, landing.letter.body};
    const double before = lod::kinetic_energy<2>(bodies);
    lod::Resolver<2>().resolve(Response::net, landing.impacts, bodies, landing.impulses);
    landing.letter.body = bodies[1];
    landing.share = lod::kinetic_energy<2>(bodies) / before;
    return landing;
}

viz::Figure draw_letter(const LetterLanding& landing) {
    viz::Panel panel;
    panel.view = box(-1.0, landing.foot - 0.25, 1.0, 1.0);
    add_body(panel, landing.floor, 0);
    add_body(panel, landing.letter, 1);
    for (std::size_t i = 0; i < landing.impacts.size(); ++i)
        add_push(panel, landing.impacts[i].contact.point, Vec(0, 1.5 * landing.impulses[i]));
    const Body<2>& body = landing.letter.body;
    add_arrow(panel, viz::Role::velocity, body.position, body.position + 0.4 * body.velocity,
              "*v*_b", 1);
    return figure_of(std::move(panel));
}

void give_net(Lesson& lesson) {
    const LetterLanding landing = land_letter();
    give(lesson, "L energy", number(landing.share, 12));
    give(lesson, "L spin", number(landing.letter.body.spin[0], 3, "rad/s"));
    give(lesson, "L speed", number(landing.letter.body.velocity.y(), 3, "m/s"));
    give(lesson, "half bounce", number(land(Response::net, 16, 0.5).share(), 3));
    viz::Figure figure = draw_letter(landing);
    figure.numbers = {{"energy after / before", lesson.numbers["L energy"].text},
                      {"spin", lesson.numbers["L spin"].text}};
    give(lesson, "net", std::move(figure));
}

}  // namespace

void give_many_contacts(Lesson& lesson) {
    give_landing(lesson);
    give_meter(lesson);
    give_net(lesson);
}

}  // namespace lessons::impact
