#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/draw/motion/draw_motion.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

constexpr double contact_seconds = 0.25;  ///< of video that a contact stays to be seen
constexpr std::size_t most_curve_points = 2000;

/// What does not change from frame to frame.
template <int Dim>
struct Stage {
    std::shared_ptr<const Run<Dim>> run;
    SimulationMotion choice;
    View<Dim> view;
    Curve energy;
    std::vector<Curve> momentum;  ///< one an axis
    Panel energy_panel;           ///< of the whole run: gives the view
    Panel momentum_panel;
};

Axes over_time(const char* what) {
    Axes axes;
    axes.x.label = "time [s]";
    axes.y.label = what;
    return axes;
}

template <int Dim>
std::shared_ptr<const Stage<Dim>> stage_of(const Run<Dim>& run, const SimulationMotion& choice,
                                           const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    if (run.instants.empty())
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot film a simulation: it has no instants; simulate at least one "
                         "frame");
    auto stage = std::make_shared<Stage<Dim>>();
    stage->run = std::make_shared<const Run<Dim>>(run);
    stage->choice = choice;
    stage->view = view_of<Dim>({run}, run.instants.back().time, viewpoint);
    stage->energy.name = "energy";
    constexpr std::array<const char*, 3> names{"*p_x*", "*p_y*", "*p_z*"};
    for (int axis = 0; axis < Dim; ++axis) {
        Curve& curve = stage->momentum.emplace_back();
        curve.name = names[static_cast<std::size_t>(axis)];
        curve.series = axis;
    }
    const std::size_t step = 1 + run.instants.size() / most_curve_points;
    for (std::size_t i = 0; i < run.instants.size(); i += step) {
        const Instant<Dim>& instant = run.instants[i];
        const std::span<const lod::Body<Dim>> bodies(instant.bodies);
        const lod::Vector<Dim> p = lod::momentum<Dim>(bodies);
        stage->energy.points.push_back({instant.time, lod::kinetic_energy<Dim>(bodies)});
        for (int axis = 0; axis < Dim; ++axis)
            stage->momentum[static_cast<std::size_t>(axis)].points.push_back(
                {instant.time, p[axis]});
    }
    stage->energy_panel = plot_panel("", over_time("kinetic energy [J]"), {stage->energy});
    stage->energy_panel.view.low.y = 0;  // what is lost or won shows as a share of the whole
    stage->energy_panel.view.high.y *= 1.15;
    stage->momentum_panel = plot_panel("", over_time("momentum [kg m/s]"), stage->momentum);
    return stage;
}

Curve until(const Curve& curve, double time) {
    Curve cut = curve;
    const auto later = std::find_if(cut.points.begin(), cut.points.end(),
                                    [&](Point p) { return p.x > time + 1e-12; });
    cut.points.erase(later, cut.points.end());
    if (cut.points.empty()) cut.points.push_back(curve.points.front());
    return cut;
}

Panel plot_until(const Panel& whole, const std::vector<Curve>& curves, double time) {
    std::vector<Curve> cut;
    for (const Curve& curve : curves) cut.push_back(until(curve, time));
    // A run of one instant has no time to show.
    Box view = whole.view;
    if (view.high.x <= view.low.x) view.high.x = view.low.x + 1;
    Panel panel = plot_panel("", *whole.axes, cut, view);
    for (const Curve& curve : cut)
        panel.marks.push_back(
            Dot{{.role = Role::curve, .body = curve.series}, curve.points.back(), 0.7});
    return panel;
}

/// The contacts resolved a moment ago, fading.
template <int Dim>
void add_recent_contacts(Panel& panel, const Stage<Dim>& stage, double time) {
    const Run<Dim>& run = *stage.run;
    const double seen = contact_seconds * stage.choice.speed;
    const auto first =
        static_cast<std::size_t>(std::max(0.0, std::ceil((time - seen) / run.time_step)));
    for (std::size_t i = first; i < run.instants.size() && run.instants[i].time <= time; ++i) {
        const lod::FrameRecord<Dim>& record = run.instants[i].record;
        std::vector<lod::Contact<Dim>> pushed;
        for (std::size_t c = 0; c < record.impacts.size(); ++c)
            if (record.impulses[c] > 0) pushed.push_back(record.impacts[c].contact);
        const double age = (time - run.instants[i].time) / seen;
        add_contact_points<Dim>(panel, pushed, std::clamp(1 - age, 0.0, 1.0));
    }
}

template <int Dim>
Panel scene_panel(const Stage<Dim>& stage, double time) {
    const std::vector<lod::Body<Dim>> bodies = bodies_at(*stage.run, time);
    Panel panel = blank_panel<Dim>(stage.view);
    add_trails(panel, *stage.run, bodies,
               {.from = std::max(0.0, time - stage.choice.trail), .until = time});
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Visual<Dim> visual = visual_at(*stage.run, b);
        add_body<Dim>(panel, {visual, bodies[b]}, static_cast<int>(b));
    }
    add_recent_contacts(panel, stage, time);
    return panel;
}

template <int Dim>
const lod::FrameRecord<Dim>& record_at(const Run<Dim>& run, double time) {
    return run.instants[instant_at(run, time)].record;
}

template <int Dim>
Figure picture(const Stage<Dim>& stage, double time) {
    const Run<Dim>& run = *stage.run;
    const lod::FrameRecord<Dim>& record = record_at(run, time);
    const double energy = until(stage.energy, time).points.back().y;
    Figure figure;
    figure.title = stage.choice.title.empty() ? literal_text(run.name) : stage.choice.title;
    figure.caption = stage.choice.caption;
    figure.numbers = {{"time", fixed_text(time, 2) + "\u00A0s"},
                      {"energy", quantity_text(energy, "J")},
                      {"node tests", number_text(static_cast<double>(record.tests), 9)}};
    figure.alt = plain_text(figure.title) + ": " +
                 count_text(static_cast<long long>(run.instants.front().bodies.size()), "body") +
                 " after " + quantity_text(time, "s") + ", kinetic energy " +
                 quantity_text(energy, "J") + ", " +
                 count_text(static_cast<long long>(record.impacts.size()), "contact") + ".";
    figure.panels.push_back(scene_panel(stage, time));
    if (!stage.choice.plots) return figure;
    figure.columns = 2;
    figure.column_weights = {1.75, 1};
    figure.panels[0].cell = Cell{0, 0, 2, 1};
    figure.panels.push_back(plot_until(stage.energy_panel, {stage.energy}, time));
    figure.panels.back().cell = Cell{0, 1};
    figure.panels.push_back(plot_until(stage.momentum_panel, stage.momentum, time));
    figure.panels.back().cell = Cell{1, 1};
    return figure;
}

}  // namespace

template <int Dim>
Figure simulation_picture(const Run<Dim>& run, double time, const SimulationMotion& choice,
                          const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    return picture(*stage_of(run, choice, viewpoint), time);
}

template <int Dim>
Animation simulation_motion(const Run<Dim>& run, const SimulationMotion& choice,
                            const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    if (!(choice.speed > 0) || !(choice.frames_per_second >= 1))
        throw lod::Error(lod::ErrorKind::usage,
                         "cannot film a simulation: its speed and frame rate must be above zero; "
                         "give positive numbers");
    const auto stage = stage_of(run, choice, viewpoint);
    const double end = run.instants.back().time;
    const int frames = 1 + static_cast<int>(end / choice.speed * choice.frames_per_second);
    Animation animation;
    animation.frames_per_second = choice.frames_per_second;
    animation.title = choice.title.empty() ? run.name : choice.title;
    for (int i = 0; i < frames; ++i) {
        const double time = std::min(end, i * choice.speed / choice.frames_per_second);
        animation.shots.push_back({[stage, time] { return picture(*stage, time); }, 1});
    }
    return animation;
}

template Figure simulation_picture<2>(const Run<2>&, double, const SimulationMotion&,
                                      const DrawTraits<2>::Viewpoint&);
template Figure simulation_picture<3>(const Run<3>&, double, const SimulationMotion&,
                                      const DrawTraits<3>::Viewpoint&);
template Animation simulation_motion<2>(const Run<2>&, const SimulationMotion&,
                                        const DrawTraits<2>::Viewpoint&);
template Animation simulation_motion<3>(const Run<3>&, const SimulationMotion&,
                                        const DrawTraits<3>::Viewpoint&);

}  // namespace viz
