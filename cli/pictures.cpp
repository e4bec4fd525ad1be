#include "cli/pictures.hpp"

#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"

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

viz::Look<2> look_of(const lod2d::Shape& shape, const std::string& name) {
    viz::Look<2> look{name, {}};
    for (const lod2d::Ring& ring : shape.polygon.rings) {
        viz::Ring& copy = look.outline.emplace_back();
        for (const lod2d::Point& point : ring) copy.push_back({point.x(), point.y()});
    }
    return look;
}

viz::Actor<2> actor_of(const scenes::Setup& setup, const std::vector<lod::Body<2>>& bodies,
                       std::int32_t number) {
    const auto i = static_cast<std::size_t>(number);
    return {look_of(*setup.shapes[i], setup.scene.bodies[i].name), bodies[i]};
}

viz::Run<2> seen(const scenes::Setup& setup, const scenes::Run<2>& run, const std::string& name) {
    viz::Run<2> result;
    result.name = name;
    result.time_step = run.settings.time_step;
    for (std::size_t i = 0; i < setup.bodies.size(); ++i)
        result.looks.push_back(look_of(*setup.shapes[i], setup.scene.bodies[i].name));
    const auto bodies_in = [&](const std::vector<scenes::State<2>>& states) {
        std::vector<lod::Body<2>> bodies = setup.bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i) scenes::put(states[i], bodies[i]);
        return bodies;
    };
    for (const scenes::Step<2>& step : run.steps)
        viz::add_instant(result, bodies_in(step.before), step.record);
    viz::add_instant(result, bodies_in(run.end), {});
    return result;
}

void check_outputs(const Options& options, bool has_video) {
    for (const std::string& path : options.out) {
        const bool fits = viz::is_figure_path(path) || (has_video && viz::is_video_path(path));
        if (!fits)
            throw lod::Error(lod::ErrorKind::usage,
                             "cannot write " + path + ": lodlab " +
                                 (has_video ? "does this as png, svg, pdf, json, mp4, webm or gif"
                                            : "does this as png, svg, pdf or json") +
                                 "; give it one of these endings");
        const lod::OutputFile probe(path);  // throws; leaves nothing
    }
    if (!options.trace.empty()) const lod::OutputFile probe(options.trace);
}

void write_outputs(const Options& options, const Drawing& drawing) {
    viz::WriteOptions write;
    write.theme = theme_of(options);
    write.quality = quality_of(options);
    write.warn = [](const std::string& line) { remark(line); };
    for (const std::string& path : options.out) {
        lod::check_interrupted();
        if (viz::is_video_path(path)) {
            ProgressBar bar("Filming " + path);
            write.progress = [&](const viz::Progress& p) {
                bar.show(static_cast<double>(p.done) / p.total);
            };
            viz::write_animation(path, drawing.animation(), write);
        } else if (drawing.json && path.ends_with(".json")) {
            drawing.json(path);
        } else {
            viz::write_figure(path, drawing.figure(), write);
        }
    }
}

}  // namespace cli
