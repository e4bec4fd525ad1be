#include "cli/stage/run_pictures.hpp"

#include <algorithm>
#include <memory>

#include "cli/arguments/misused.hpp"
#include "cli/terminal/numbers.hpp"
#include "cli/terminal/output.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/viz/draw/motion/draw_motion.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"
#include "lodlab/viz/draw/motion/draw_strip.hpp"

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

viz::Curve curve_named(const std::string& name, int series) {
    return {name, {}, {}, {}, series, false, false};
}

/// Kinetic energy and the parts of momentum along the axes, frame by frame.
template <int Dim>
struct Course {
    viz::Curve energy = curve_named("", 0);
    std::vector<viz::Curve> momentum;
};

template <int Dim>
Course<Dim> course_of(const scenes::Setup<Dim>& setup, const scenes::Run<Dim>& run) {
    Course<Dim> course;
    for (int axis = 0; axis < Dim; ++axis)
        course.momentum.push_back(curve_named("along " + std::string(1, "xyz"[axis]), axis));
    std::vector<lod::Body<Dim>> bodies = setup.bodies;
    const auto add = [&](std::size_t frame, const std::vector<scenes::State<Dim>>& states) {
        for (std::size_t i = 0; i < bodies.size(); ++i) scenes::put(states[i], bodies[i]);
        const double time = static_cast<double>(frame) * run.settings.time_step;
        const lod::Vector<Dim> momentum = lod::momentum<Dim>(bodies);
        course.energy.points.push_back({time, lod::kinetic_energy<Dim>(bodies)});
        for (std::size_t axis = 0; axis < course.momentum.size(); ++axis)
            course.momentum[axis].points.push_back({time, momentum[static_cast<int>(axis)]});
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

template <int Dim>
viz::Figure plot_of(const scenes::Setup<Dim>& setup, const scenes::Run<Dim>& run,
                    const std::string& name) {
    const Course<Dim> course = course_of(setup, run);
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
                 readable(run.energy_end, 4) + " joules; momentum from " +
                 in_brackets(run.momentum_start, 4) + " to " + in_brackets(run.momentum_end, 4) +
                 " kilogram metres a second.";
    figure.panels = {
        viz::plot_panel("Kinetic energy", energy, {course.energy}, from_zero(course.energy)),
        viz::plot_panel("Momentum of all that moves", momentum, course.momentum)};
    figure.scale_bar = false;
    return figure;
}

viz::SimulationMotion motion_of(const scenes::Scene& scene) {
    viz::SimulationMotion choice;
    choice.title = title_of(scene);
    return choice;
}

/// Two bodies: the strip of their collision. More: where all of them end.
template <int Dim>
viz::Figure still_of(const scenes::Setup<Dim>& setup, const viz::Run<Dim>& run,
                     const std::string& picture) {
    const auto viewpoint = viewpoint_of<Dim>(setup.scene);
    if (picture != "strip" && setup.bodies.size() != 2)
        return viz::simulation_picture<Dim>(run, run.instants.back().time, motion_of(setup.scene),
                                            viewpoint);
    viz::StripWords words;
    words.title = title_of(setup.scene);
    return viz::strips<Dim>({run}, words, viewpoint);
}

/// The film of two bodies dwells on their collision; more bodies are filmed as they move.
template <int Dim>
viz::Animation film_of(const scenes::Setup<Dim>& setup, const viz::Run<Dim>& run) {
    const auto viewpoint = viewpoint_of<Dim>(setup.scene);
    if (setup.bodies.size() != 2 || viz::first_impact(run) < 0)
        return viz::simulation_motion<Dim>(run, motion_of(setup.scene), viewpoint);
    viz::ImpactMotion choice;
    choice.title = title_of(setup.scene);
    return viz::impact_motion<Dim>({run}, choice, viewpoint);
}

/// Where a crowd runs under a quota, or where that is asked for.
bool shows_quota(const Options& options, const scenes::Limits& limits) {
    if (options.picture == "quota") return true;
    const bool limited = limits.node_tests || limits.milliseconds;
    return options.picture.empty() && limited && scenes::names_crowd(options.scene);
}

/// The frames of a run; its end, where nothing is refined, is none.
template <int Dim>
viz::Run<Dim> frames_of(const scenes::Setup<Dim>& setup, const scenes::Run<Dim>& run,
                        const std::string& name) {
    viz::Run<Dim> shown = seen(setup, run, name);
    if (shown.instants.size() > 1) shown.instants.pop_back();
    return shown;
}

/// The film of the crowd, or the frame in which most pairs meet.
template <int Dim>
Drawing quota_drawing(const scenes::Setup<Dim>& setup, const scenes::Run<Dim>& run,
                      const std::string& name) {
    const auto shown = std::make_shared<const viz::Run<Dim>>(frames_of(setup, run, name));
    const auto choice = crowd_choice(run.settings, run.limits);
    const auto viewpoint = viewpoint_of<Dim>(setup.scene);
    Drawing drawing;
    drawing.figure = [&setup, shown, choice, viewpoint] {
        return framed<Dim>(
            viz::crowd_picture<Dim>(*shown, viz::fullest_instant(*shown), choice, viewpoint),
            setup.scene);
    };
    drawing.animation = [&setup, shown, choice, viewpoint] {
        return framed<Dim>(viz::crowd_motion<Dim>(*shown, choice, viewpoint), setup.scene);
    };
    return drawing;
}

}  // namespace

viz::CrowdChoice crowd_choice(const lod::FrameSettings& settings, const scenes::Limits& limits) {
    viz::CrowdChoice choice;
    choice.quota = {limits.node_tests, limits.milliseconds};
    if (settings.priority == lod::Priority::perceptual) choice.fixation = settings.viewer.fixation;
    return choice;
}

void check_quota(const Options& options, const scenes::Limits& limits) {
    if (options.picture != "quota" || limits.node_tests || limits.milliseconds) return;
    misused(
        options.replay.empty()
            ? "--quota shows what a quota was spent on, and there is none; add --budget TESTS or "
              "--milliseconds TIME"
            : "--quota shows what a quota was spent on, and the run of the trace had none; drop "
              "--quota");
}

template <int Dim>
Drawing drawing_of(const scenes::Setup<Dim>& setup, const scenes::Run<Dim>& run,
                   const Options& options) {
    const std::string name =
        options.replay.empty() ? limit_of(setup.scene.limits) : "Played again from a trace";
    if (shows_quota(options, run.limits)) return quota_drawing(setup, run, name);
    const auto shown = std::make_shared<const viz::Run<Dim>>(seen(setup, run, name));
    Drawing drawing;
    drawing.figure = [&setup, &run, &options, shown] {
        if (options.picture == "plot") return plot_of(setup, run, shown->name);
        return framed<Dim>(still_of(setup, *shown, options.picture), setup.scene);
    };
    drawing.animation = [&setup, shown] {
        return framed<Dim>(film_of(setup, *shown), setup.scene);
    };
    return drawing;
}

template Drawing drawing_of(const scenes::Setup<2>&, const scenes::Run<2>&, const Options&);
template Drawing drawing_of(const scenes::Setup<3>&, const scenes::Run<3>&, const Options&);

}  // namespace cli
