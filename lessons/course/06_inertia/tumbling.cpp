#include <algorithm>
#include <cmath>

#include "lessons/course/06_inertia/lesson.hpp"
#include "lodlab/core/frame/integrate.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"

namespace lessons::inertia {
namespace {

constexpr double time_step = 1.0 / 120;  // [s]
constexpr int steps_between_points = 4;  // of a trace

// listing: naive
/// Euler's equations, I w' = (I w) x w in the body's frame, by explicit steps: the change at the
/// beginning of the step, times its length.
void naive_step(Body<3>& body, double h) {
    const lod::Matrix<3> R = lod::Space<3>::rotation(body.orientation);
    const lod::Spin<3> spin = R.transpose() * body.spin;
    const lod::Spin<3> change = body.inverse_inertia * (body.inertia * spin).cross(spin);
    body.orientation = lod::Space<3>::turned(body.orientation, h * body.spin);
    body.spin = lod::Space<3>::rotation(body.orientation) * (spin + h * change);
}
// end of listing

void sound_step(Body<3>& body, double h) {
    lod::integrate<3>({&body, 1}, h);
}

double energy_of(const Body<3>& body) {
    return lod::kinetic_energy<3>({&body, 1});
}

/// What becomes of energy and angular momentum.
struct Drift {
    double energy = 0;         ///< largest |E / E at the start - 1|
    double momentum = 0;       ///< largest change, as a share
    double spin_angle = 0;     ///< furthest that the spin turned [degrees]
    double energy_at_end = 1;  ///< of that at the start
    viz::Curve curve;          ///< of the energy over time
};

template <typename Step>
Drift drift_over(Body<3> body, int steps, const Step& step) {
    constexpr int steps_a_point = 100;
    const double energy = energy_of(body);
    const Vec momentum = momentum_of(body);
    const Vec spin = body.spin;
    Drift drift;
    drift.curve.points.push_back({0, 1});
    for (int i = 1; i <= steps; ++i) {
        step(body, time_step);
        drift.energy_at_end = energy_of(body) / energy;
        drift.energy = std::max(drift.energy, std::abs(drift.energy_at_end - 1));
        drift.momentum =
            std::max(drift.momentum, (momentum_of(body) - momentum).norm() / momentum.norm());
        drift.spin_angle = std::max(drift.spin_angle, degrees_between(spin, body.spin));
        if (i % steps_a_point == 0)
            drift.curve.points.push_back({i * time_step, drift.energy_at_end});
    }
    return drift;
}

/// A body on its way, with the way of the tip of its spin.
struct Flight {
    double spin_length = 0.3;      ///< metres of arrow for a radian a second
    double momentum_length = 0.3;  ///< metres of arrow for a kilogram square metre a second
    std::vector<Body<3>> bodies;   ///< every steps_between_points steps
    [[nodiscard]] std::vector<Vec> spin_tips(std::size_t until) const {
        std::vector<Vec> tips;
        for (std::size_t i = 0; i <= until; ++i) tips.push_back(spin_length * bodies[i].spin);
        return tips;
    }
};

Flight fly(Body<3> body, double seconds) {
    Flight flight;
    flight.bodies.push_back(body);
    const int steps = static_cast<int>(std::lround(seconds / time_step));
    for (int i = 1; i <= steps; ++i) {
        sound_step(body, time_step);
        if (i % steps_between_points == 0) flight.bodies.push_back(body);
    }
    return flight;
}

/// The crate at an instant of its flight with both arrows and the trace of the spin.
viz::Panel draw_instant(const Crate& crate, const Flight& flight, std::size_t instant) {
    viz::Panel panel = panel_round(crate, 0.88);
    viz::Actor<3> now = crate.actor;
    now.body = flight.bodies[instant];
    viz::add_body(panel, now, 0);
    const std::vector<Vec> tips = flight.spin_tips(instant);
    viz::add_line<3>(panel, style(viz::Role::trajectory, 1), tips, 0.25);
    add_arrow<3>(panel, viz::Role::velocity, Vec::Zero(), tips.back(), "*ω*", 1);
    add_arrow<3>(panel, viz::Role::impulse, Vec::Zero(),
                 flight.momentum_length * momentum_of(now.body), "*L*");
    return panel;
}

Body<3> spinning(const Crate& crate, const Vec& spin) {
    Body<3> body = crate.actor.body;
    body.spin = spin;
    return body;
}

constexpr int many_steps = 10000;

void step_wander(Lesson& lesson, const Crate& crate, const Drift& sound, const Vec& spin) {
    constexpr double seconds = 5;
    const Flight flight = fly(spinning(crate, spin), seconds);
    lesson.numbers["start spin"] = {spin.x(), vector_text(spin, 1) + "\u00a0rad/s"};
    lesson.numbers["spin angle"] = degrees(sound.spin_angle, 0);
    lesson.numbers["momentum drift"] = tiny(sound.momentum);
    viz::Figure figure =
        figure_of(draw_instant(crate, flight, flight.bodies.size() - 1),
                  "The spin wanders, the angular momentum stands still",
                  "The crate after five seconds of free tumbling. The tip of the spin's arrow has "
                  "drawn a loop; the arrow of the angular momentum is where it was.");
    add_step(lesson, "Nothing pushes, and the spin wanders",
             "Throw the crate up with a spin of {{number: start spin}} and let it be. Nothing "
             "turns it, so its angular momentum L = I ω stands still in the room. But I turns with "
             "the body, so ω has to change to make up for it: its tip draws the orange line, up to "
             "{{number: spin angle}} away from where it began. In the plane I is one number, and "
             "the spin of a free body never changes.\n\n"
             "**Predict:** a program takes the change of ω at the beginning of a step, times the "
             "length of the step. For the position of a ball that flies straight on that is exact. "
             "What happens to "
             "the energy of the crate?",
             std::move(figure),
             {{"spin turns by up to", "spin angle"}, {"L changes by", "momentum drift"}}, "wander");
}

void step_energy(Lesson& lesson, const Drift& sound, const Drift& naive) {
    lesson.numbers["steps"] = count(many_steps);
    lesson.numbers["seconds"] = number(many_steps * time_step, 0, "s");
    lesson.numbers["sound energy"] = tiny(sound.energy);
    lesson.numbers["naive energy"] = number(naive.energy_at_end, 2);
    lesson.numbers["naive momentum"] = number(100 * naive.momentum, 0, "%");
    std::vector<viz::Curve> curves{naive.curve, sound.curve};
    curves[0].name = "explicit steps";
    curves[0].series = 1;
    curves[1].name = "implicit midpoint";
    const viz::Axes axes{{"time [s]", viz::Scale::linear, {}, false},
                         {"energy / energy at the start", viz::Scale::linear, {}, false}};
    viz::Box view{{0, 0}, {many_steps * time_step, 1.1 * naive.energy_at_end}};
    add_step(lesson, "Ten thousand steps",
             "After {{number: steps}} steps of 1/120 s, {{number: seconds}} of tumbling, the naive "
             "program has multiplied the energy by **{{number: naive energy}}**, and L is off by "
             "{{number: naive momentum}}. Every step leaves along the tangent of a curve, and "
             "ends a little outside of it.\n\n"
             "lodlab solves each step for the middle: find the spin in whose direction the body "
             "turns, such that it is the one that belongs to the *mean* of the angular momentum "
             "before and after. This *implicit midpoint rule* keeps the energy exactly, and L too, "
             "for any length of the step; what is left is rounding, {{number: sound energy}} of "
             "the energy and {{number: momentum drift}} of L.\n\n"
             "**Predict:** spin the crate about each of its three axes in turn, as exactly as you "
             "can. Which of the three spins stays as it is?",
             figure_of(viz::plot_panel("", axes, curves, view), "Who keeps the energy?",
                       "Two curves of the energy over time: the explicit steps' rises steeply, the "
                       "implicit midpoint rule's is flat at 1."),
             {{"explicit: energy", "naive energy"}, {"midpoint: energy off by", "sound energy"}},
             "energy");
}

constexpr double turning = 3;   ///< about the axis [rad/s]
constexpr double slip = 0.03;   ///< about the two others [rad/s]
constexpr double watched = 20;  ///< [s]

Body<3> started_about(const Crate& crate, int axis) {
    Vec spin = Vec::Constant(slip);
    spin[axis] = turning;
    return spinning(crate, spin);
}

/// The spin about the axis that it was started about, in the body's frame.
viz::Curve spin_about(const Crate& crate, int axis, const std::string& name) {
    viz::Curve curve;
    curve.name = name;
    curve.series = axis;
    const Flight flight = fly(started_about(crate, axis), watched);
    for (std::size_t i = 0; i < flight.bodies.size(); ++i) {
        const lod::Matrix<3> R = lod::Space<3>::rotation(flight.bodies[i].orientation);
        const double about = (R.transpose() * flight.bodies[i].spin)[axis];
        curve.points.push_back({static_cast<double>(i) * steps_between_points * time_step, about});
    }
    return curve;
}

/// When a curve crosses zero.
std::vector<double> crossings(const viz::Curve& curve) {
    std::vector<double> times;
    for (std::size_t i = 1; i < curve.points.size(); ++i)
        if (curve.points[i - 1].y * curve.points[i].y < 0) times.push_back(curve.points[i].x);
    return times;
}

void step_flip(Lesson& lesson, const Crate& crate) {
    const std::vector<viz::Curve> curves{spin_about(crate, 0, "x, the easiest"),
                                         spin_about(crate, 1, "y, the middle one"),
                                         spin_about(crate, 2, "z, the hardest")};
    const std::vector<double> flips = crossings(curves[1]);
    lesson.numbers["flips"] = count(flips.size());
    lesson.numbers["first flip"] = number(flips.at(0), 1, "s");
    lesson.numbers["between flips"] = number(flips.at(1) - flips.at(0), 1, "s");
    for (const auto& [curve, name] : {std::pair{0, "x"}, {2, "z"}}) {
        double most = 0;
        for (const viz::Point& p : curves[static_cast<std::size_t>(curve)].points)
            most = std::max(most, std::abs(p.y - turning));
        lesson.numbers[std::string("wobble ") + name] = number(most, 4, "rad/s");
    }
    lesson.numbers["slip"] = number(100 * slip / turning, 0, "%");
    lesson.numbers["turning"] = number(turning, 0, "rad/s");
    const viz::Axes axes{{"time [s]", viz::Scale::linear, {}, false},
                         {"spin about that axis [rad/s]", viz::Scale::linear, {}, false}};
    const viz::Box view{{0, -1.25 * turning}, {watched, 1.25 * turning}};
    add_step(lesson, "The middle axis will not have it",
             "Three starts with {{number: turning}} about one axis of the body and a slip of "
             "{{number: slip}} about the two others. About the easiest axis the spin changes "
             "by no more than {{number: wobble x}}, about the hardest by no more than {{number: "
             "wobble z}}. About the **middle** one it holds for a while, then the crate turns "
             "over: after {{number: "
             "first flip}}, and again every {{number: between flips}}, {{number: flips}} times in "
             "this plot. An astronaut saw it in 1985 on a wing nut that flew off its screw: the "
             "Dzhanibekov effect.\n\n"
             "Nothing is wrong with the program: energy and angular momentum stand still all the "
             "while. Two of the three spins are a ball in a bowl, the third is a ball on a saddle.",
             figure_of(viz::plot_panel("", axes, curves, view), "Which spin stays?",
                       "Three curves of the spin about the axis of the start. Those of the easiest "
                       "and the hardest axis are flat, that of the middle axis jumps between plus "
                       "and minus three."),
             {{"first flip", "first flip"}, {"then every", "between flips"}}, "flip");
}

/// The flight about the middle axis, with an arrow fixed to the crate along it.
viz::Figure draw_flip(const Crate& crate, const Flight& flight, std::size_t instant) {
    viz::Panel panel = draw_instant(crate, flight, instant);
    const Body<3>& body = flight.bodies[instant];
    const Vec up = lod::Space<3>::rotation(body.orientation).col(1);
    add_arrow<3>(panel, viz::Role::normal, 0.3 * up, 0.62 * up, "top");
    viz::Figure figure = figure_of(std::move(panel), "A spin about the middle axis turns over",
                                   "The tumbling crate with its spin and angular momentum.");
    const double time = static_cast<double>(instant) * steps_between_points * time_step;
    figure.numbers = {{"time", shown(time, 1) + " s"}};
    return figure;
}

void animate(Lesson& lesson, const Crate& crate) {
    constexpr std::size_t instants_a_picture = 4;  // 2/15 s of flight
    constexpr int held = 3;                        // frames
    constexpr double seconds = 8;
    lesson.animation.title =
        "The crate spins about its middle axis and turns over; L stands still, ω wanders";
    lesson.animation.frames_per_second = 30;
    Flight flight = fly(started_about(crate, 1), seconds);
    flight.spin_length = flight.momentum_length = 0.2;  // it spins faster than the other
    for (std::size_t i = 0; i < flight.bodies.size(); i += instants_a_picture)
        lesson.animation.shots.push_back(
            {[crate, flight, i] { return draw_flip(crate, flight, i); }, held});
}

}  // namespace

void add_tumbling(Lesson& lesson, const Crate& crate) {
    const Vec spin(2, 1.5, 1);
    const Body<3> start = spinning(crate, spin);
    const Drift sound = drift_over(start, many_steps, sound_step);
    const Drift naive = drift_over(start, many_steps, naive_step);
    step_wander(lesson, crate, sound, spin);
    step_energy(lesson, sound, naive);
    step_flip(lesson, crate);
    animate(lesson, crate);
}

}  // namespace lessons::inertia
