#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/choices.hpp"
#include "cli/arguments/misused.hpp"
#include "cli/commands/crowd.hpp"
#include "cli/stage/staging.hpp"
#include "cli/stage/threads.hpp"
#include "cli/terminal/dimension.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "lodlab/measure/crowd/quota.hpp"
#include "lodlab/measure/curves.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"
#include "lodlab/viz/draw/scene_view.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int usual_seeds = 5;
/// Quotas as shares of what the dearest frame needs.
const std::vector<double> quota_shares{1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1};

/// Where the plot's title looks.
constexpr double told_share = 0.25;

/// One priority under one quota, over the seeds.
struct Row {
    double share = 0;
    measure::Spread error;
    measure::Spread attended;  ///< the same where the observer looks
    /// Both over those of level_order, seed by seed; nothing where that was not measured.
    std::optional<measure::Spread> error_ratio;
    std::optional<measure::Spread> attended_ratio;
    double level = 0;
    double cut = 0;
};

struct Curve {
    lod::Priority priority{};
    std::vector<Row> rows;
};

struct Errors {
    std::string scene;
    int dim = 2;
    std::size_t bodies = 0;
    std::int64_t frames = 0;
    std::vector<std::string> seeds;  ///< each as a crowd's name
    std::vector<std::uint64_t> dearest;
    std::vector<Curve> curves;
};

/// All policies, or those that the options name.
std::vector<lod::Priority> compared(const Options& options) {
    constexpr auto all = lod::choices<lod::Priority>();
    if (options.policies.empty()) return {all.begin(), all.end()};
    return choices_in<lod::Priority>(options.policies, "--policies");
}

/// The same crowd with as many seeds as are asked for; a scene that is no crowd, once.
std::vector<std::string> seeded(const Options& options) {
    if (!scenes::names_crowd(options.scene)) {
        if (options.seeds)
            misused("--seeds are of a crowd, and " + options.scene +
                    " is a scene; drop --seeds, or name a crowd, as in gas:100");
        return {options.scene};
    }
    const std::size_t comma = options.scene.find(',');
    std::uint64_t first = 1;
    if (comma != std::string::npos)
        std::from_chars(options.scene.data() + comma + 1,
                        options.scene.data() + options.scene.size(), first);
    std::vector<std::string> specs;
    for (int i = 0; i < options.seeds.value_or(usual_seeds); ++i)
        specs.push_back(options.scene.substr(0, comma) + "," +
                        std::to_string(first + static_cast<std::uint64_t>(i)));
    return specs;
}

/// How one seed is measured.
struct Measuring {
    std::vector<lod::Priority> priorities;
    lod::Executor* executor = nullptr;
    std::function<void(double)> progress;
};

template <int Dim>
measure::QuotaOutcomes outcomes_of(const scenes::Scene& scene, const Options& options,
                                   const Measuring& how) {
    const scenes::Setup<Dim> setup = stage<Dim>(scene, options);
    measure::QuotaPlan<Dim> plan;
    plan.bodies = setup.bodies;
    plan.settings = scenes::frame_settings(scene, {});
    plan.frames = scene.frames();
    plan.shares = quota_shares;
    plan.priorities = how.priorities;
    plan.executor = how.executor;
    plan.progress = how.progress;
    return measure::try_quotas(plan);
}

using Outcomes = std::vector<measure::QuotaOutcomes>;
using ErrorOf = double measure::QuotaOutcome::*;

std::vector<double> errors_of(const Outcomes& seeds, std::size_t priority, std::size_t share,
                              ErrorOf error) {
    std::vector<double> errors;
    for (const measure::QuotaOutcomes& seed : seeds)
        errors.push_back(seed.of_priority[priority][share].*error);
    return errors;
}

/// Of each seed the one over the other; 1 where both are nothing.
measure::Spread ratio(std::vector<double> errors, const std::vector<double>& others) {
    for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i] = errors[i] == others[i] ? 1 : errors[i] / others[i];
    return measure::spread(std::move(errors));
}

/// Puts the seeds together.
std::vector<Curve> curves_of(const Outcomes& seeds, const std::vector<lod::Priority>& priorities) {
    const auto hubbard =
        std::find(priorities.begin(), priorities.end(), lod::Priority::level_order);
    const auto reference = static_cast<std::size_t>(hubbard - priorities.begin());
    const ErrorOf seen = &measure::QuotaOutcome::error;
    const ErrorOf attended = &measure::QuotaOutcome::attended_error;
    std::vector<Curve> curves;
    for (std::size_t p = 0; p < priorities.size(); ++p) {
        Curve curve{priorities[p], {}};
        for (std::size_t q = 0; q < quota_shares.size(); ++q) {
            Row row;
            row.share = quota_shares[q];
            row.error = measure::spread(errors_of(seeds, p, q, seen));
            row.attended = measure::spread(errors_of(seeds, p, q, attended));
            if (hubbard != priorities.end()) {
                row.error_ratio =
                    ratio(errors_of(seeds, p, q, seen), errors_of(seeds, reference, q, seen));
                row.attended_ratio = ratio(errors_of(seeds, p, q, attended),
                                           errors_of(seeds, reference, q, attended));
            }
            for (const measure::QuotaOutcomes& seed : seeds) {
                const measure::QuotaOutcome& outcome = seed.of_priority[p][q];
                row.level += outcome.level / static_cast<double>(seeds.size());
                row.cut += outcome.cut / static_cast<double>(seeds.size());
            }
            curve.rows.push_back(row);
        }
        curves.push_back(curve);
    }
    return curves;
}

Errors measured_errors(const Options& options) {
    Errors result;
    result.seeds = seeded(options);
    Outcomes outcomes;
    const Threads threads(options);
    Measuring how{compared(options), threads.executor(), {}};
    ProgressBar bar("Trying quotas");
    for (const std::string& spec : result.seeds) {
        Options one = options;
        one.scene = spec;
        const scenes::Scene scene = scene_of(one);
        result.scene = scene.name;
        result.dim = scene.dim;
        result.bodies = moving_in(scene);
        result.frames = scene.frames();
        const auto before = static_cast<double>(outcomes.size());
        how.progress = [&](double share) {
            bar.show((before + share) / static_cast<double>(result.seeds.size()));
        };
        in_dimension(scene.dim,
                     [&](auto dim) { outcomes.push_back(outcomes_of<dim()>(scene, one, how)); });
        result.dearest.push_back(outcomes.back().dearest);
    }
    result.curves = curves_of(outcomes, how.priorities);
    return result;
}

Json json_of(const Errors& result) {
    Json curves = Json::array();
    for (const Curve& curve : result.curves) {
        Json rows = Json::array();
        for (const Row& row : curve.rows) {
            Json one = {{"share", row.share},
                        {"error", cli::json_of(row.error)},
                        {"attended_error", cli::json_of(row.attended)}};
            if (row.error_ratio) {
                one["over_level_order"] = {{"error", cli::json_of(*row.error_ratio)},
                                           {"attended_error", cli::json_of(*row.attended_ratio)}};
            }
            one["level"] = row.level;
            one["cut"] = row.cut;
            rows.push_back(std::move(one));
        }
        curves.push_back({{"priority", lod::name_of(curve.priority)}, {"quotas", rows}});
    }
    return {{"scene", result.scene},   {"dim", result.dim},     {"bodies", result.bodies},
            {"frames", result.frames}, {"seeds", result.seeds}, {"dearest_frame", result.dearest},
            {"priorities", curves}};
}

std::string columns(const measure::Spread& spread) {
    return right(readable(spread.median, 3), 10) + right(readable(spread.p10, 3), 9) +
           right(readable(spread.p90, 3), 9);
}

std::string report_of(const Errors& result) {
    std::string text = result.scene + ": " + std::to_string(result.bodies) + " bodies, " +
                       std::to_string(result.frames) + " frames, " +
                       std::to_string(result.seeds.size()) +
                       (result.seeds.size() == 1 ? " run\n" : " seeds\n");
    for (const Curve& curve : result.curves) {
        text.append(lod::name_of(curve.priority)).append("\n");
        text +=
            "   quota     error   10 % to 90 %      attended   10 % to 90 %     level   frames "
            "cut\n";
        for (const Row& row : curve.rows)
            text += right(readable(100 * row.share, 3), 6) + " %" + columns(row.error) + "    " +
                    columns(row.attended) + right(readable(row.level, 3), 8) +
                    right(readable(100 * row.cut, 3), 11) + " %\n";
    }
    return text +
           "quota: of the node tests that the dearest frame needs; error: of all that the "
           "impulses of a frame change, the share that is wrong; attended: the same with each body "
           "weighted by an observer's attention\n";
}

double told_error(const Curve& curve) {
    const auto row = std::find_if(curve.rows.begin(), curve.rows.end(),
                                  [](const Row& one) { return one.share == told_share; });
    return row->error.median;
}

/// What the plot finds.
std::string title_of(const Errors& result) {
    const auto best = std::min_element(
        result.curves.begin(), result.curves.end(),
        [](const Curve& x, const Curve& y) { return told_error(x) < told_error(y); });
    return "A quarter of the tests leaves " + readable(100 * told_error(*best), 2) +
           " % of the impulses wrong, by " + in_words(best->priority);
}

/// Errors over quotas, a curve each policy.
viz::Panel panel_of(const Errors& result, const std::string& title, measure::Spread Row::*error) {
    std::vector<viz::Curve> drawn;
    for (const Curve& curve : result.curves) {
        viz::Curve line;
        line.name = in_words(curve.priority);
        line.series = static_cast<int>(drawn.size());
        line.dots = true;
        for (const Row& row : curve.rows) {
            if (row.share == 1) continue;  // nothing is wrong there, which a logarithm cannot show
            line.points.push_back({100 * row.share, 100 * (row.*error).median});
        }
        drawn.push_back(std::move(line));
    }
    viz::Axes axes;
    axes.x.label = "quota [% of the dearest frame]";
    axes.x.scale = viz::Scale::logarithmic;
    axes.y.label = "error [% of what impulses change]";
    axes.y.scale = viz::Scale::logarithmic;
    return viz::plot_panel(title, axes, drawn);
}

viz::Figure figure_of(const Errors& result) {
    viz::Figure figure;
    figure.title = title_of(result);
    figure.caption =
        "Every frame of " + viz::literal_text(result.scene) + " with " +
        std::to_string(result.bodies) +
        " bodies is done again under each quota (of the tests of the frame that needs most). " +
        (result.seeds.size() == 1 ? std::string()
                                  : "Median of " + std::to_string(result.seeds.size()) + " seeds.");
    figure.panels = {panel_of(result, "All bodies", &Row::error),
                     panel_of(result, "Weighted by attention", &Row::attended)};
    viz::Box& all = figure.panels[0].view;
    viz::Box& attended = figure.panels[1].view;
    all = attended = viz::united(all, attended);
    figure.scale_bar = false;
    return figure;
}

}  // namespace

void show_errors(const Options& options) {
    check_outputs(options, {});
    const Errors result = measured_errors(options);
    show(
        options, [&] { return figure_of(result); }, [&] { return json_of(result); },
        [&] { return report_of(result); });
}

}  // namespace cli
