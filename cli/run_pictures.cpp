#include "cli/run_pictures.hpp"

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

viz::Figure plot_of(const scenes::Setup& setup, const scenes::Run<2>& run) {
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
    figure.caption = limit_of(setup.scene.limits) +
                     ". Between moving bodies momentum is kept; walls that do not move change it.";
    figure.alt = "Two plots over " + readable(setup.scene.duration) +
                 " seconds: kinetic energy goes from " + readable(run.energy_start, 4) + " to " +
                 readable(run.energy_end, 4) + " joules; momentum from (" +
                 readable(run.momentum_start.x(), 4) + ", " + readable(run.momentum_start.y(), 4) +
                 ") to (" + readable(run.momentum_end.x(), 4) + ", " +
                 readable(run.momentum_end.y(), 4) + ") kilogram metres a second.";
    figure.panels = {
        viz::plot_panel("Kinetic energy", energy, {course.energy}),
        viz::plot_panel("Momentum of all that moves", momentum, {course.along_x, course.along_y})};
    figure.scale_bar = false;
    return figure;
}

}  // namespace

Drawing drawing_of(const scenes::Setup& setup, const scenes::Run<2>& run, const Options& options) {
    const auto shown =
        std::make_shared<const viz::Run>(seen(setup, run, limit_of(setup.scene.limits)));
    Drawing drawing;
    drawing.figure = [&setup, &run, &options, shown] {
        if (options.plot) return plot_of(setup, run);
        viz::StripWords words;
        words.title = title_of(setup.scene);
        return viz::strips({*shown}, words);
    };
    drawing.animation = [&setup, shown] {
        const bool one_collision = setup.bodies.size() == 2 && viz::first_impact(*shown) >= 0;
        if (one_collision) {
            viz::ImpactMotion choice;
            choice.title = title_of(setup.scene);
            return viz::impact_motion({*shown}, choice);
        }
        viz::SimulationMotion choice;
        choice.title = title_of(setup.scene);
        return viz::simulation_motion(*shown, choice);
    };
    return drawing;
}

}  // namespace cli
