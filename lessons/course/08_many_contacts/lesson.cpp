#include "lessons/course/08_many_contacts/lesson.hpp"

#include <cmath>

#include "lessons/engine/meeting.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/viz/draw/motion/draw_motion.hpp"

namespace lessons {
namespace many {

using lod::Body;
using lod::Response;
using Vec = lod::Vector<2>;

// listing: answered
Touching answered(Touching touching, Response response) {
    lod::Resolver<2>().resolve(response, touching.impacts, touching.bodies, touching.impulses);
    return touching;
}
// end of listing

namespace {

/// A ball of 1 kg, 1 m wide.
viz::Actor<2> ball(const std::string& name, const Vec& place, const Vec& velocity = Vec(0, 0)) {
    viz::Actor<2> ball =
        actor(name, lod2d::generate("disc"),
              std::make_shared<const lod::SphereTree<2>>(lod::single_sphere<2>({Vec(0, 0), 0.5})));
    lod::set_mass<2>(ball.body, 1.0, lod::Inertia<2>::Constant(0.125));
    ball.body.position = place;
    ball.body.velocity = velocity;
    return ball;
}

/// One ball comes to two that touch, and touches both.
std::vector<viz::Actor<2>> break_of_two() {
    const double across = std::sqrt(0.75);
    return {ball("A", Vec(0, 0), Vec(1, 0)), ball("B", Vec(across, 0.5)),
            ball("C", Vec(across, -0.5))};
}

/// Three in a row: the first comes, the others touch.
std::vector<viz::Actor<2>> row_of_three() {
    return {ball("A", Vec(0, 0), Vec(1, 0)), ball("B", Vec(1, 0)), ball("C", Vec(2, 0))};
}

/// Contacts of balls, in the order in which they are named.
Touching touching(const std::vector<viz::Actor<2>>& balls,
                  const std::vector<std::pair<int, int>>& pairs) {
    Touching result;
    for (const viz::Actor<2>& one : balls) result.bodies.push_back(one.body);
    for (const auto& [a, b] : pairs) {
        const Vec& from = balls[static_cast<std::size_t>(a)].body.position;
        const Vec& to = balls[static_cast<std::size_t>(b)].body.position;
        const auto pair = static_cast<std::int32_t>(result.impacts.size());
        result.impacts.push_back({a, b, pair, {(from + to) / 2, (to - from).normalized(), 0}});
    }
    return result;
}

viz::Panel draw(std::vector<viz::Actor<2>> balls, const Touching& after, const std::string& title) {
    constexpr double velocity_length = 0.9;  // [m] for 1 m/s
    viz::Panel panel;
    panel.title = title;
    panel.view = box(-0.75, -1.05, 1.75, 1.05);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const auto index = static_cast<int>(i);
        balls[i].body = after.bodies[i];
        const Vec x = balls[i].body.position;
        const Vec v = balls[i].body.velocity;
        add_body(panel, balls[i], index);
        add_label(panel, viz::Role::body, x, balls[i].visual.name, index, 0.5);
        if (v.norm() > 1e-9)
            add_arrow(panel, viz::Role::velocity, x, x + velocity_length * v, "", index);
    }
    return panel;
}

/// The velocities of some balls after an answer.
void give_velocities(Lesson& lesson, const std::string& name, const Touching& after,
                     const std::string& balls) {
    for (const char ball : balls) {
        const Vec& v = after.bodies[static_cast<std::size_t>(ball - 'A')].velocity;
        give(lesson, name + " " + ball, words(vector_text<2>(v) + " m/s", v.x()));
    }
}

void give_break(Lesson& lesson) {
    const std::vector<viz::Actor<2>> balls = break_of_two();
    const Touching before = touching(balls, {{0, 1}, {0, 2}});
    const Touching one = answered(touching(balls, {{0, 1}}), Response::net);
    const Touching b_first = answered(before, Response::sequential);
    const Touching c_first = answered(touching(balls, {{0, 2}, {0, 1}}), Response::sequential);
    const Touching sum = answered(before, Response::sum);
    const Touching net = answered(before, Response::net);
    const lod::Contact<2>& second = before.impacts[1].contact;
    const double closing = -lod::closing_velocity(before.bodies[0], before.bodies[2], second);
    const double later = -lod::closing_velocity(one.bodies[0], one.bodies[2], second);
    give(lesson, "closing", number(closing, 3, "m/s"));
    give(lesson, "first j", number(one.impulses[0], 3, "N s"));
    give(lesson, "A after one", words(vector_text<2>(one.bodies[0].velocity) + " m/s"));
    give(lesson, "second closing", number(later, 3, "m/s"));
    give(lesson, "energy start", number(before.energy(), 3, "J"));
    give(lesson, "sum energy", number(sum.energy(), 3, "J"));
    give(lesson, "sum share", number(sum.energy() / before.energy(), 2));
    give(lesson, "net energy", number(net.energy(), 3, "J"));
    give(lesson, "ordered energy", number(b_first.energy(), 3, "J"));
    give(lesson, "net factor", number(net.impulses[0] / sum.impulses[0], 2));
    give_velocities(lesson, "B first", b_first, "ABC");
    give_velocities(lesson, "C first", c_first, "BC");
    give_velocities(lesson, "sum", sum, "ABC");
    give_velocities(lesson, "net", net, "ABC");
    give_velocities(lesson, "lcp", answered(before, Response::lcp), "B");
    give(lesson, "break", draw(balls, before, ""));
    give(lesson, "orders",
         figure_of({draw(balls, b_first, "B first"), draw(balls, c_first, "C first")}, 2));
    give(lesson, "both at once", draw(balls, sum, ""));
    give(lesson, "shared", draw(balls, net, ""));
}

void give_row(Lesson& lesson) {
    const std::vector<viz::Actor<2>> balls = row_of_three();
    const Touching before = touching(balls, {{0, 1}, {1, 2}});
    std::vector<viz::Panel> panels;
    for (const auto& [response, name] : {std::pair{Response::net, "net"}, {Response::lcp, "lcp"}}) {
        const Touching after = answered(before, response);
        for (const std::size_t i : {0, 1, 2})
            give(lesson, std::string("row ") + name + " " + "ABC"[i],
                 number(after.bodies[i].velocity.x(), 2, "m/s"));
        panels.push_back(draw(balls, after, name));
        panels.back().view = box(-1.0, -0.7, 3.4, 0.8);
    }
    give(lesson, "rows", figure_of(std::move(panels), 1));
}

/// A comes to B and C from so long ago.
std::vector<viz::Actor<2>> coming(double seconds) {
    std::vector<viz::Actor<2>> balls = break_of_two();
    balls[0] = earlier(balls[0], seconds);
    return balls;
}

void animate(Lesson& lesson) {
    std::vector<viz::Run<2>> runs;
    for (const Response response : {Response::sequential, Response::sum, Response::net}) {
        lod::FrameSettings settings;
        settings.response = response;
        runs.push_back(run_of(coming(0.8), settings, 2.4,
                              video_words(lesson, std::string(lod::name_of(response)))));
    }
    viz::ImpactMotion motion;
    motion.seconds = 4;
    motion.title = video_words(lesson, "title");
    lesson.animation = viz::impact_motion<2>(runs, motion);
}

}  // namespace
}  // namespace many

void make_many_contacts(Lesson& lesson) {
    many::give_landings(lesson);
    many::give_break(lesson);
    many::give_row(lesson);
    give(lesson, to_play_with(many::coming(0.8), box(-1.6, -1.5, 2.8, 1.5)));
    many::animate(lesson);
}

}  // namespace lessons
