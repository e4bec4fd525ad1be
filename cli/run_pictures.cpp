#include "cli/run_pictures.hpp"

#include <algorithm>
#include <memory>

#include "cli/output.hpp"
#include "viz/draw_motion.hpp"
#include "viz/draw_plot.hpp"
#include "viz/draw_strip.hpp"

namespace cli {
namespace {

/// What limited the run: the name of its row.
std::string limit_of(const scenes::Limits& limits) {
    if (limits.level) return "Level " + std::to_string(*limits.level);
    if (limits.node_tests) return std::to_string(*limits.node_tests) + " tests a frame";
    if (limits.milliseconds) return readable(*limits.milliseconds) + " ms a frame";
    return "Down to the leaves";
}

std::string title_of(const scenes::Scene& scene) {
    return viz::literal_text(scene.title.empty() ? scene.name : scene.title);
}

/// Kinetic energy and the two parts of momentum, frame by frame.
struct Course {
    viz::Curve energy{"", {}, {}, {}, 0, false, false};
    viz::Curve along_x{"along x", {}, {}, {}, 0, false, false};
    viz::Curve along_y{"along y", {}, {}, {}, 1, false, false};
};

Course course_of(const scenes::Setup& setup, const scenes::Run<2>& run) {
    Course course;
    std::vector<lod::Body<2>> bodies = setup.bodies;
    const auto add = [&](std::size_t frame, const std::vector<scenes::State<2>>& states) {
        for (std::size_t i = 0; i < bodies.size(); ++i) scenes::put(states[i], bodies[i]);
        const double time = static_cast<double>(frame) * run.settings.time_step;
        const lod::Vector<2> momentum = lod::momentum<2>(bodies);
        course.energy.points.push_back({time, lod::kinetic_energy<2>(bodies)});
        course.along_x.points.push_back({time, momentum.x()});
        course.along_y.points.push_back({time, momentum.y()});
    };
    for (std::size_t k = 0; k < run.steps.size(); ++k) add(k, run.steps[k].before);
    add(run.steps.size(), run.end);
    return course;
}

/// All of a curve that is never below zero, with zero.
viz::Box from_zero(const viz::Curve& curve) {
    double highest = 0;
    for (const viz::Point& point : curve.points) highest = std::max(highest, point.y);
    const double margin = 1.1;
    return {{0, 0}, {curve.points.back().x, highest > 0 ? margin * highest : 1}};
}

viz::Figure plot_of(const scenes::Setup& setup, const scenes::Run<2>& run,
                    const std::string& name) {
    const Course course = course_of(setup, run);
    viz::Axes energy;
    energy.x.label = "time [s]";
    energy.y.label = "kinetic energy [J]";
    viz::Axes momentum = energy;
    momentum.y.label = "momentum [kg m/s]";
    viz::Figure figure;
    figure.title = title_of(setup.scene);
    figure.numbers = {{"energy before", readable(run.energy_start, 4) + " J"},
                      {"after", readable(run.energy_end, 4) + " J"}};
    figure.caption =
        name + ". Between moving bodies momentum is kept; walls that do not move change it.";
    figure.alt = "Two plots over " + readable(course.energy.points.back().x) +
                 " seconds: kinetic energy goes from " + readable(run.energy_start, 4) + " to " +
                 readable(run.energy_end, 4) + " joules; momentum from (" +
                 readable(run.momentum_start.x(), 4) + ", " + readable(run.momentum_start.y(), 4) +
                 ") to (" + readable(run.momentum_end.x(), 4) + ", " +
                 readable(run.momentum_end.y(), 4) + ") kilogram metres a second.";
    figure.panels = {
        viz::plot_panel("Kinetic energy", energy, {course.energy}, from_zero(course.energy)),
        viz::plot_panel("Momentum of all that moves", momentum, {course.along_x, course.along_y})};
    figure.scale_bar = false;
    return figure;
}

viz::SimulationMotion motion_of(const scenes::Scene& scene) {
    viz::SimulationMotion choice;
    choice.title = title_of(scene);
    return choice;
}

/// Two bodies: the strip of their collision. More: where all of them end.
viz::Figure still_of(const scenes::Setup& setup, const viz::Run<2>& run,
                     const std::string& picture) {
    if (picture != "strip" && setup.bodies.size() > 2)
        return viz::simulation_picture(run, run.instants.back().time, motion_of(setup.scene));
    viz::StripWords words;
    words.title = title_of(setup.scene);
    return viz::strips<2>({run}, words);
}

/// The film of two bodies dwells on their collision; more bodies are filmed as they move.
viz::Animation film_of(const scenes::Setup& setup, const viz::Run<2>& run) {
    if (setup.bodies.size() > 2 || viz::first_impact(run) < 0)
        return viz::simulation_motion(run, motion_of(setup.scene));
    viz::ImpactMotion choice;
    choice.title = title_of(setup.scene);
    return viz::impact_motion<2>({run}, choice);
}

/// The figure with its scenes seen by the scene's camera, where it has one.
viz::Figure framed(viz::Figure figure, const scenes::Scene& scene) {
    if (!scene.camera) return figure;
    const auto& [centre, width] = *scene.camera;
    const double height = width * 9 / 16;
    for (viz::Panel& panel : figure.panels)
        if (!panel.axes)
            panel.view = {{centre[0] - width / 2, centre[1] - height / 2},
                          {centre[0] + width / 2, centre[1] + height / 2}};
    return figure;
}

viz::Animation framed(viz::Animation animation, const scenes::Scene& scene) {
    if (!scene.camera) return animation;
    for (viz::Shot& shot : animation.shots)
        shot.draw = [draw = std::move(shot.draw), scene] { return framed(draw(), scene); };
    return animation;
}

}  // namespace

Drawing drawing_of(const scenes::Setup& setup, const scenes::Run<2>& run, const Options& options) {
    const std::string name =
        options.replay.empty() ? limit_of(setup.scene.limits) : "Played again from a trace";
    const auto shown = std::make_shared<const viz::Run<2>>(seen(setup, run, name));
    Drawing drawing;
    drawing.figure = [&setup, &run, &options, shown] {
        if (options.picture == "plot") return plot_of(setup, run, shown->name);
        return framed(still_of(setup, *shown, options.picture), setup.scene);
    };
    drawing.animation = [&setup, shown] { return framed(film_of(setup, *shown), setup.scene); };
    return drawing;
}

}  // namespace cli
