#include "cli/stage/pictures.hpp"

#include <algorithm>
#include <map>

#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/scenes/spelling.hpp"
#include "lodlab/viz/film/write.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace cli {
viz::Theme theme_of(const Options& options) {
    return options.theme == "dark" ? viz::Theme::dark : viz::Theme::light;
}

viz::Quality quality_of(const Options& options) {
    if (options.quality == "draft") return viz::Quality::draft;
    if (options.quality == "1080p") return viz::Quality::p1080;
    if (options.quality == "4k") return viz::Quality::p4k;
    return viz::Quality::p720;
}

template <int Dim>
viz::Visual<Dim> visual_of(const scenes::Shape<Dim>& shape, const std::string& name) {
    viz::Visual<Dim> visual = viz::visual_of(shape);
    visual.name = name;
    return visual;
}

template <int Dim>
viz::Actor<Dim> actor_of(const scenes::Setup<Dim>& setup, const std::vector<lod::Body<Dim>>& bodies,
                         std::int32_t number) {
    const auto i = static_cast<std::size_t>(number);
    return {visual_of<Dim>(*setup.shapes[i], setup.scene.bodies[i].name), bodies[i]};
}

template <int Dim>
viz::Run<Dim> seen(const scenes::Setup<Dim>& setup, const scenes::Run<Dim>& run,
                   const std::string& name) {
    viz::Run<Dim> result;
    result.name = name;
    result.time_step = run.settings.time_step;
    std::map<const scenes::Shape<Dim>*, viz::Visual<Dim>> visuals;  // bodies of one shape share it
    for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
        const scenes::Shape<Dim>* shape = setup.shapes[i].get();
        if (visuals.find(shape) == visuals.end()) visuals[shape] = visual_of<Dim>(*shape, "");
        result.visuals.push_back(visuals[shape]);
        result.visuals.back().name = setup.scene.bodies[i].name;
    }
    const auto bodies_in = [&](const std::vector<scenes::State<Dim>>& states) {
        std::vector<lod::Body<Dim>> bodies = setup.bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i) scenes::put(states[i], bodies[i]);
        return bodies;
    };
    for (const scenes::Step<Dim>& step : run.steps)
        viz::add_instant<Dim>(result, bodies_in(step.before), step.record);
    viz::add_instant<Dim>(result, bodies_in(run.end), {});
    return result;
}

namespace {

void look_from(const scenes::Camera&, viz::FlatViewpoint&) {}
void look_from(const scenes::Camera& camera, viz::Viewpoint& viewpoint) {
    viewpoint.azimuth = camera.azimuth;
    if (camera.elevation) viewpoint.elevation = *camera.elevation;
    viewpoint.perspective = camera.perspective;
}

}  // namespace

template <int Dim>
typename viz::DrawTraits<Dim>::Viewpoint viewpoint_of(const scenes::Scene& scene) {
    typename viz::DrawTraits<Dim>::Viewpoint viewpoint;
    if (scene.camera) look_from(*scene.camera, viewpoint);
    return viewpoint;
}

#define CLI_INSTANTIATE(Dim)                                                             \
    template viz::Visual<Dim> visual_of(const scenes::Shape<Dim>&, const std::string&);  \
    template viz::Actor<Dim> actor_of(const scenes::Setup<Dim>&,                         \
                                      const std::vector<lod::Body<Dim>>&, std::int32_t); \
    template viz::Run<Dim> seen(const scenes::Setup<Dim>&, const scenes::Run<Dim>&,      \
                                const std::string&);                                     \
    template typename viz::DrawTraits<Dim>::Viewpoint viewpoint_of<Dim>(const scenes::Scene&);
CLI_INSTANTIATE(2)
CLI_INSTANTIATE(3)
#undef CLI_INSTANTIATE

template <int Dim>
viz::Figure framed(viz::Figure figure, const scenes::Scene& scene) {
    if (!scene.camera || scene.camera->width == 0) return figure;
    lod::Vector<Dim> centre;
    for (int i = 0; i < Dim; ++i) centre[i] = scene.camera->centre[static_cast<std::size_t>(i)];
    const double width = scene.camera->width;
    const double height = width * 9 / 16;
    for (viz::Panel& panel : figure.panels) {
        if (panel.axes) continue;
        const viz::Point middle = viz::DrawTraits<Dim>::on(panel, centre);
        panel.view = {{middle.x - width / 2, middle.y - height / 2},
                      {middle.x + width / 2, middle.y + height / 2}};
    }
    return figure;
}

template <int Dim>
viz::Animation framed(viz::Animation animation, const scenes::Scene& scene) {
    if (!scene.camera) return animation;
    for (viz::Shot& shot : animation.shots)
        shot.draw = [draw = std::move(shot.draw), scene] { return framed<Dim>(draw(), scene); };
    return animation;
}

template viz::Figure framed<2>(viz::Figure, const scenes::Scene&);
template viz::Figure framed<3>(viz::Figure, const scenes::Scene&);
template viz::Animation framed<2>(viz::Animation, const scenes::Scene&);
template viz::Animation framed<3>(viz::Animation, const scenes::Scene&);

void write_outputs(const Options& options, const Drawing& drawing) {
    viz::WriteOptions write;
    write.theme = theme_of(options);
    write.quality = quality_of(options);
    write.warn = [](const std::string& line) { remark(line); };
    for (const std::string& path : options.out) {
        lod::check_interrupted();
        const auto exported =
            std::find_if(drawing.exports.begin(), drawing.exports.end(),
                         [&](const Export& one) { return path.ends_with(one.ending); });
        if (exported != drawing.exports.end()) {
            exported->write(path);
        } else if (viz::is_video_path(path)) {
            ProgressBar bar("Filming " + path);
            write.progress = [&](const viz::Progress& p) {
                bar.show(static_cast<double>(p.done) / p.total);
            };
            viz::write_animation(path, drawing.animation(), write);
        } else {
            viz::write_figure(path, drawing.figure(), write);
        }
    }
}

}  // namespace cli
