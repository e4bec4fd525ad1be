#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/command.hpp"
#include "cli/arguments/misused.hpp"
#include "cli/stage/pictures.hpp"
#include "cli/stage/staging.hpp"
#include "cli/terminal/dimension.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "lodlab/measure/crowd/quota.hpp"
#include "lodlab/measure/curves.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int usual_seeds = 5;
/// Quotas as shares of what the dearest frame needs.
const std::vector<double> quota_shares{1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1};

constexpr auto priorities = lod::choices<lod::Priority>();

/// One priority under one quota, over the seeds.
struct Row {
    double share = 0;
    measure::Spread error;
    double level = 0;
    double cut = 0;
};

struct Curve {
    lod::Priority priority{};
    std::vector<Row> rows;
};

struct Result {
    std::string scene;
    int dim = 2;
    std::size_t bodies = 0;
    std::int64_t frames = 0;
    std::vector<std::string> seeds;  ///< each as a crowd's name
    std::vector<std::uint64_t> dearest;
    std::vector<Curve> curves;
};

std::size_t moving_in(const scenes::Scene& scene) {
    return static_cast<std::size_t>(
        std::count_if(scene.bodies.begin(), scene.bodies.end(),
                      [](const scenes::BodySpec& body) { return !body.is_static; }));
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

template <int Dim>
measure::QuotaOutcomes outcomes_of(const scenes::Scene& scene, const Options& options,
                                   const std::function<void(double)>& progress) {
    const scenes::Setup<Dim> setup = stage<Dim>(scene, options);
    measure::QuotaPlan<Dim> plan;
    plan.bodies = setup.bodies;
    plan.settings = scenes::frame_settings(scene, {});
    plan.frames = scene.frames();
    plan.shares = quota_shares;
    plan.priorities.assign(priorities.begin(), priorities.end());
    plan.progress = progress;
    return measure::try_quotas(plan);
}

/// Puts the seeds together.
std::vector<Curve> curves_of(const std::vector<measure::QuotaOutcomes>& seeds) {
    std::vector<Curve> curves;
    for (std::size_t p = 0; p < priorities.size(); ++p) {
        Curve curve{priorities[p], {}};
        for (std::size_t q = 0; q < quota_shares.size(); ++q) {
            Row row;
            row.share = quota_shares[q];
            std::vector<double> errors;
            for (const measure::QuotaOutcomes& seed : seeds) {
                const measure::QuotaOutcome& outcome = seed.of_priority[p][q];
                errors.push_back(outcome.error);
                row.level += outcome.level / static_cast<double>(seeds.size());
                row.cut += outcome.cut / static_cast<double>(seeds.size());
            }
            row.error = measure::spread(errors);
            curve.rows.push_back(row);
        }
        curves.push_back(curve);
    }
    return curves;
}

Result measured(const Options& options) {
    Result result;
    result.seeds = seeded(options);
    std::vector<measure::QuotaOutcomes> outcomes;
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
        const auto progress = [&](double share) {
            bar.show((before + share) / static_cast<double>(result.seeds.size()));
        };
        in_dimension(scene.dim, [&](auto dim) {
            outcomes.push_back(outcomes_of<dim()>(scene, one, progress));
        });
        result.dearest.push_back(outcomes.back().dearest);
    }
    result.curves = curves_of(outcomes);
    return result;
}

Json json_of(const Result& result) {
    Json curves = Json::array();
    for (const Curve& curve : result.curves) {
        Json rows = Json::array();
        for (const Row& row : curve.rows)
            rows.push_back(
                {{"share", row.share},
                 {"error",
                  {{"p10", row.error.p10}, {"median", row.error.median}, {"p90", row.error.p90}}},
                 {"level", row.level},
                 {"cut", row.cut}});
        curves.push_back({{"priority", lod::name_of(curve.priority)}, {"quotas", rows}});
    }
    return {{"scene", result.scene},   {"dim", result.dim},     {"bodies", result.bodies},
            {"frames", result.frames}, {"seeds", result.seeds}, {"dearest_frame", result.dearest},
            {"priorities", curves}};
}

std::string report_of(const Result& result) {
    std::string text = result.scene + ": " + std::to_string(result.bodies) + " bodies, " +
                       std::to_string(result.frames) + " frames, " +
                       std::to_string(result.seeds.size()) +
                       (result.seeds.size() == 1 ? " run\n" : " seeds\n");
    for (const Curve& curve : result.curves) {
        text.append(lod::name_of(curve.priority)).append("\n");
        text += "   quota     error   10 % to 90 %     level   frames cut\n";
        for (const Row& row : curve.rows)
            text += right(readable(100 * row.share, 3), 6) + " %" +
                    right(readable(row.error.median, 3), 10) +
                    right(readable(row.error.p10, 3), 9) + right(readable(row.error.p90, 3), 9) +
                    right(readable(row.level, 3), 8) + right(readable(100 * row.cut, 3), 11) +
                    " %\n";
    }
    return text +
           "quota: of the node tests that the dearest frame needs; error: of all that the "
           "impulses of a frame change, the share that is wrong\n";
}

/// What the plot finds.
std::string title_of(const Result& result) {
    const auto quarter = [](const Curve& curve) {
        return std::find_if(curve.rows.begin(), curve.rows.end(),
                            [](const Row& row) { return row.share == 0.25; })
            ->error.median;
    };
    const auto best =
        std::min_element(result.curves.begin(), result.curves.end(),
                         [&](const Curve& x, const Curve& y) { return quarter(x) < quarter(y); });
    std::string name(lod::name_of(best->priority));
    std::replace(name.begin(), name.end(), '_', ' ');
    return "A quarter of the tests leaves " + readable(100 * quarter(*best), 2) +
           " % of the impulses wrong, by " + name;
}

viz::Figure figure_of(const Result& result) {
    std::vector<viz::Curve> drawn;
    for (const Curve& curve : result.curves) {
        viz::Curve line;
        line.name = std::string(lod::name_of(curve.priority));
        std::replace(line.name.begin(), line.name.end(), '_', ' ');
        line.series = static_cast<int>(drawn.size());
        line.dots = true;
        for (const Row& row : curve.rows) {
            if (row.share == 1) continue;  // nothing is wrong there, which a logarithm cannot show
            line.points.push_back({100 * row.share, 100 * row.error.median});
        }
        drawn.push_back(std::move(line));
    }
    viz::Axes axes;
    axes.x.label = "quota [% of the tests that the dearest frame needs]";
    axes.x.scale = viz::Scale::logarithmic;
    axes.y.label = "error [% of what impulses change]";
    axes.y.scale = viz::Scale::logarithmic;
    const std::string caption =
        "Every frame of " + viz::literal_text(result.scene) + " with " +
        std::to_string(result.bodies) +
        " bodies is done again under each quota from the same "
        "state. " +
        (result.seeds.size() == 1 ? std::string()
                                  : "Median of " + std::to_string(result.seeds.size()) + " seeds.");
    return viz::plot(title_of(result), axes, drawn, caption);
}

}  // namespace

void run_crowd(const Options& options) {
    check_outputs(options, {});
    const Result result = measured(options);
    Drawing drawing;
    drawing.figure = [&] { return figure_of(result); };
    write_outputs(options, drawing);
    if (options.json)
        print(json_of(result));
    else
        print(report_of(result));
}

}  // namespace cli
