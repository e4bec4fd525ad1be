#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/choices.hpp"
#include "cli/arguments/command.hpp"
#include "cli/arguments/misused.hpp"
#include "cli/stage/pictures.hpp"
#include "cli/stage/staging.hpp"
#include "cli/stage/threads.hpp"
#include "cli/terminal/dimension.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/measure/curves.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/spelling.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int usual_impacts = 200;

/// What a dimension is measured with where the command line says nothing.
struct Usual {
    const char* shapes;
    int branching;
    int depth;
};
constexpr Usual usual_in_plane{"box,L,star:5,star:9", 4, 6};
constexpr Usual usual_in_space{"box,L,ring", 8, 3};

measure::Share share_in(const std::string& text) {
    measure::Share share;
    const auto parts = scenes::parted(text, '/');
    const auto number = [](const std::string& digits, int& value) {
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return error == std::errc() && end == digits.data() + digits.size();
    };
    if (parts.size() != 2 || !number(parts[0], share.index) || !number(parts[1], share.count))
        misused("--share must be as in 3/8, the third of eight, not " + text);
    return share;
}

measure::Plan plan_of(const Options& options) {
    measure::Plan plan;
    plan.dim = options.dim.value_or(2);
    const Usual& usual = plan.dim == 3 ? usual_in_space : usual_in_plane;
    plan.shapes = scenes::shapes_in(options.shapes.empty() ? usual.shapes : options.shapes);
    plan.branching = options.branching.value_or(usual.branching);
    plan.depth = options.depth.value_or(usual.depth);
    plan.impacts = options.impacts.value_or(usual_impacts);
    plan.ensemble.seed = options.seed;
    plan.models = choices_in<lod::ContactModel>(
        options.models.empty() ? "centre_line,node_normal,hull" : options.models, "--models");
    plan.responses = choices_in<lod::Response>(
        options.responses.empty() ? "net" : options.responses, "--responses");
    return plan;
}

const lod::Clock& steady_clock() {
    static const lod::SteadyClock clock;
    return clock;
}

template <int Dim>
measure::Outcomes measured(measure::Plan plan, measure::Share part, const Options& options) {
    scenes::TreeChoice tree;
    tree.builder = options.builder;
    tree.branching = plan.branching;
    tree.depth = plan.depth;
    plan.builder = options.builder.empty() ? std::string(scenes::Shapes<Dim>::builders().front())
                                           : options.builder;
    scenes::ShapeChoice choice;
    choice.raise_limits = options.raise_limits;
    static_cast<void>(scenes::Shapes<Dim>::settings(tree));  // throws for an unknown builder
    std::vector<scenes::Shape<Dim>> shapes;  // all of them before the first tree is built
    for (const std::string& name : plan.shapes)
        shapes.push_back(scenes::Shapes<Dim>::named(name, choice));
    std::vector<measure::MeasuredShape<Dim>> measured;
    {
        ProgressBar bar("Building the trees");
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            measured.push_back(
                measure::measured_shape<Dim>(plan.shapes[i], shapes[i], tree, cache_of(options)));
            bar.show(static_cast<double>(measured.size()) / static_cast<double>(shapes.size()));
        }
    }
    ProgressBar bar("Measuring impacts");
    measure::DegradeOptions how;
    how.share = part;
    how.clock = &steady_clock();
    const Threads threads(options);
    how.executor = threads.executor();
    how.progress = [&](double share) { bar.show(share); };
    return measure::degrade<Dim>(plan, measured, how);
}

measure::Outcomes outcomes_for(const Options& options) {
    if (!options.merge.empty()) {
        std::vector<measure::Outcomes> shares;
        for (const std::string& path : options.merge)
            shares.push_back(measure::load_outcomes(path));
        return measure::merged(std::move(shares));
    }
    const measure::Plan plan = plan_of(options);
    const measure::Share share = share_in(options.share);
    measure::check_plan(plan, share);
    measure::Outcomes outcomes;
    in_dimension(plan.dim,
                 [&](auto dimension) { outcomes = measured<dimension()>(plan, share, options); });
    return outcomes;
}

Json spread_json(const measure::Spread& spread) {
    return {{"median", spread.median}, {"p90", spread.p90}};
}

Json level_json(const measure::CurveLevel& level) {
    return {{"level", level.name == "exact" ? Json(level.name) : Json(std::stoi(level.name))},
            {"impacts", level.impacts},
            {"impulse_error", spread_json(level.impulse_error)},
            {"angle_error", spread_json(level.angle_error)},
            {"spin_error", spread_json(level.spin_error)},
            {"gap",
             {{"median", level.gap.median},
              {"max", level.most_gap},
              {"bound_violations", level.bound_violations}}},
            {"delay", spread_json(level.delay)},
            {"tests", level.tests.median},
            {"microseconds", level.microseconds.median},
            {"missed", level.missed}};
}

Json result_of(const measure::Plan& plan, const std::vector<measure::DegradationCurve>& curves) {
    Json list = Json::array();
    for (const measure::DegradationCurve& curve : curves) {
        Json levels = Json::array();
        for (const measure::CurveLevel& level : curve.levels) levels.push_back(level_json(level));
        list.push_back({{"model", lod::name_of(curve.model)},
                        {"response", lod::name_of(curve.response)},
                        {"levels", std::move(levels)}});
    }
    return {{"dim", plan.dim},
            {"shapes", plan.shapes},
            {"builder", plan.builder},
            {"branching", plan.branching},
            {"depth", plan.depth},
            {"seed", plan.ensemble.seed},
            {"time_step", plan.time_step},
            {"curves", std::move(list)}};
}

std::string report_of(const measure::Plan& plan,
                      const std::vector<measure::DegradationCurve>& curves) {
    std::string text;
    for (const std::string& shape : plan.shapes)
        text.append(text.empty() ? "" : ", ").append(shape);
    text.append(": trees by ").append(plan.builder);
    text.append(", branching ").append(std::to_string(plan.branching)).append("\n");
    for (const measure::DegradationCurve& curve : curves) {
        text.append(lod::name_of(curve.model)).append(", ").append(lod::name_of(curve.response));
        text += curve.falls_at_every_level() ? " (the median error falls at every level)\n" : "\n";
        text +=
            "  level   impulse error       p90   gap [m]    at most  delay [ms]   tests      us\n";
        for (const measure::CurveLevel& level : curve.levels) {
            text +=
                "  " + right(level.name, 5) + right(readable(level.impulse_error.median, 3), 16);
            text += right(readable(level.impulse_error.p90, 3), 10);
            text += right(readable(level.gap.median, 3), 10);
            text += right(readable(level.most_gap, 3), 11);
            text += right(readable(1000 * level.delay.median, 3), 12);
            text += right(readable(level.tests.median), 8);
            text += right(readable(level.microseconds.median, 3), 8);
            if (level.missed > 0) text.append("  missed ").append(std::to_string(level.missed));
            if (level.bound_violations > 0)
                text.append("  GAP BEYOND ITS BOUND: ")
                    .append(std::to_string(level.bound_violations));
            text += "\n";
        }
    }
    return text +
           "impulse error: |J - J exact| / |J exact|, median and 90th percentile over the impacts; "
           "delay: of the push after the exact impact\n";
}

/// "box, L and star:5", or how many there are; a file by its name alone.
std::string listed_shapes(const std::vector<std::string>& shapes) {
    constexpr std::size_t most_named = 6;
    if (shapes.size() > most_named) return std::to_string(shapes.size()) + ".";
    std::string text;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (i > 0) text += i + 1 < shapes.size() ? ", " : " and ";
        const std::filesystem::path path = shapes[i];
        text +=
            viz::literal_text(std::filesystem::exists(path) ? path.filename().string() : shapes[i]);
    }
    return text + ".";
}

viz::Figure figure_of(const measure::Outcomes& outcomes,
                      const std::vector<measure::DegradationCurve>& curves) {
    std::vector<viz::Curve> drawn;
    for (const measure::DegradationCurve& curve : curves) {
        viz::Curve line;
        line.name = in_words(curve.model);
        if (outcomes.plan.responses.size() > 1)
            line.name.append(", ").append(in_words(curve.response));
        line.series = static_cast<int>(drawn.size());
        line.dots = true;
        // The exact level's error is zero, which a logarithm cannot show.
        for (std::size_t level = 0; level + 1 < curve.levels.size(); ++level) {
            const measure::Spread& error = curve.levels[level].impulse_error;
            line.points.push_back({static_cast<double>(level), error.median});
            line.low.push_back(error.p10);
            line.high.push_back(error.p90);
        }
        drawn.push_back(std::move(line));
    }
    viz::Axes axes;
    axes.x.label = "level";
    axes.x.whole_numbers = true;
    axes.y.label = "error of the impulse";
    axes.y.scale = viz::Scale::logarithmic;
    std::string caption =
        "Random impacts against the exact answer: median, and the band from the "
        "10th to the 90th percentile. Shapes: ";
    caption += listed_shapes(outcomes.plan.shapes);
    return viz::plot("How far each level is from the exact answer", axes, drawn, caption,
                     static_cast<long long>(outcomes.impacts.size()));
}

}  // namespace

void run_degrade(const Options& options) {
    check_outputs(options, {false, {".csv", ".json"}});
    const measure::Outcomes outcomes = outcomes_for(options);
    const auto curves = measure::curves_of(outcomes);
    Drawing drawing;
    drawing.figure = [&] { return figure_of(outcomes, curves); };
    drawing.exports.push_back({".csv", [&](const std::string& path) {
                                   lod::write_text_file(path, measure::curves_csv(curves));
                               }});
    drawing.exports.push_back(
        {".json", [&](const std::string& path) { measure::save_outcomes(path, outcomes); }});
    write_outputs(options, drawing);
    if (options.json)
        print(result_of(outcomes.plan, curves));
    else
        print(report_of(outcomes.plan, curves));
}

}  // namespace cli
