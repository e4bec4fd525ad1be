#include <algorithm>
#include <cmath>

#include "lessons/course/11_inertia/lesson.hpp"
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

void give_wander(Lesson& lesson, const Crate& crate, const Drift& sound, const Vec& spin) {
    constexpr double seconds = 5;
    const Flight flight = fly(spinning(crate, spin), seconds);
    give(lesson, "start spin", words(vector_text<3>(spin, 1) + "\u00a0rad/s", spin.x()));
    give(lesson, "spin angle", degrees(sound.spin_angle, 0));
    give(lesson, "momentum drift", tiny(sound.momentum));
    give(lesson, "wander", draw_instant(crate, flight, flight.bodies.size() - 1));
}

void give_energy(Lesson& lesson, const Drift& sound, const Drift& naive) {
    give(lesson, "steps", count(many_steps));
    give(lesson, "seconds", number(many_steps * time_step, 0, "s"));
    give(lesson, "sound energy", tiny(sound.energy));
    give(lesson, "naive energy", number(naive.energy_at_end, 2));
    give(lesson, "naive momentum", number(100 * naive.momentum, 0, "%"));
    std::vector<viz::Curve> curves{naive.curve, sound.curve};
    curves[0].name = "explicit steps";
    curves[0].series = 1;
    curves[1].name = "implicit midpoint";
    const viz::Axes axes{{"time [s]", viz::Scale::linear, {}, false},
                         {"energy / energy at the start", viz::Scale::linear, {}, false}};
    viz::Box view{{0, 0}, {many_steps * time_step, 1.1 * naive.energy_at_end}};
    give(lesson, "energy", viz::plot_panel("", axes, curves, view));
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

void give_flip(Lesson& lesson, const Crate& crate) {
    const std::vector<viz::Curve> curves{spin_about(crate, 0, "x, the easiest"),
                                         spin_about(crate, 1, "y, the middle one"),
                                         spin_about(crate, 2, "z, the hardest")};
    const std::vector<double> flips = crossings(curves[1]);
    give(lesson, "flips", count(flips.size()));
    give(lesson, "first flip", number(flips.at(0), 1, "s"));
    give(lesson, "between flips", number(flips.at(1) - flips.at(0), 1, "s"));
    for (const auto& [curve, name] : {std::pair{0, "x"}, {2, "z"}}) {
        double most = 0;
        for (const viz::Point& p : curves[static_cast<std::size_t>(curve)].points)
            most = std::max(most, std::abs(p.y - turning));
        give(lesson, std::string("wobble ") + name, number(most, 4, "rad/s"));
    }
    give(lesson, "slip", number(100 * slip / turning, 0, "%"));
    give(lesson, "turning", number(turning, 0, "rad/s"));
    const viz::Axes axes{{"time [s]", viz::Scale::linear, {}, false},
                         {"spin about that axis [rad/s]", viz::Scale::linear, {}, false}};
    const viz::Box view{{0, -1.25 * turning}, {watched, 1.25 * turning}};
    give(lesson, "flip", viz::plot_panel("", axes, curves, view));
}

/// The flight about the middle axis, with an arrow fixed to the crate along it.
viz::Figure draw_flip(const Crate& crate, const Flight& flight, std::size_t instant) {
    viz::Panel panel = draw_instant(crate, flight, instant);
    const Body<3>& body = flight.bodies[instant];
    const Vec up = lod::Space<3>::rotation(body.orientation).col(1);
    add_arrow<3>(panel, viz::Role::normal, 0.3 * up, 0.62 * up, "top");
    viz::Figure figure = figure_of(std::move(panel));
    const double time = static_cast<double>(instant) * steps_between_points * time_step;
    figure.numbers = {{"time", shown(time, 1) + " s"}};
    return figure;
}

void animate(Lesson& lesson, const Crate& crate) {
    constexpr std::size_t instants_a_picture = 4;  // 2/15 s of flight
    constexpr int held = 3;                        // frames
    constexpr double seconds = 8;
    const std::string title = video_words(lesson, "flip");
    Flight flight = fly(started_about(crate, 1), seconds);
    flight.spin_length = flight.momentum_length = 0.2;  // it spins faster than the other
    for (std::size_t i = 0; i < flight.bodies.size(); i += instants_a_picture)
        lesson.animation.shots.push_back({[crate, flight, title, i] {
                                              viz::Figure figure = draw_flip(crate, flight, i);
                                              figure.title = title;
                                              return figure;
                                          },
                                          held});
}

}  // namespace

void give_tumbling(Lesson& lesson, const Crate& crate) {
    const Vec spin(2, 1.5, 1);
    const Body<3> start = spinning(crate, spin);
    const Drift sound = drift_over(start, many_steps, sound_step);
    const Drift naive = drift_over(start, many_steps, naive_step);
    give_wander(lesson, crate, sound, spin);
    give_energy(lesson, sound, naive);
    give_flip(lesson, crate);
    animate(lesson, crate);
}

}  // namespace lessons::inertia
