#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/choices.hpp"
#include "cli/commands/crowd.hpp"
#include "cli/stage/staging.hpp"
#include "cli/terminal/dimension.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "lodlab/measure/crowd/course.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/threads/thread_clock.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;
using Frames = std::vector<measure::CourseFrame>;

constexpr std::size_t most_with_least = 3;  // policies whose least level is drawn, dashed

struct LevelFrames {
    std::string scene;
    int dim = 2;
    std::size_t bodies = 0;
    double time_step = 0;
    std::vector<lod::Priority> policies;
    measure::LevelCourses courses;
};

template <int Dim>
measure::LevelCourses courses_of(const scenes::Scene& scene, const Options& options,
                                 const std::vector<lod::Priority>& policies) {
    const scenes::Setup<Dim> setup = stage<Dim>(scene, options);
    ProgressBar bar("Following levels");
    const scenes::ThreadClock clock;
    const scenes::Limits limits{{}, options.budget, options.milliseconds};
    measure::CoursePlan<Dim> plan;
    plan.bodies = setup.bodies;
    plan.settings = scenes::frame_settings(scene, {});
    plan.frames = scene.frames();
    plan.budget = [&] { return scenes::budget_of(limits, &clock); };
    plan.clock = &clock;
    plan.progress = [&](double share) { bar.show(share); };
    return measure::level_courses<Dim>(plan, policies);
}

LevelFrames measured_levels(const Options& options) {
    const scenes::Scene scene = scene_of(options);
    LevelFrames result;
    result.scene = scene.name;
    result.dim = scene.dim;
    result.bodies = moving_in(scene);
    result.time_step = scene.time_step;
    result.policies = policies_of(options, scene);
    in_dimension(scene.dim, [&](auto dim) {
        result.courses = courses_of<dim()>(scene, options, result.policies);
    });
    return result;
}

Json or_null(const lod::LevelsReached& reached) {
    return reached.pairs == 0 ? Json() : Json(reached.mean);
}

Json json_of(const Frames& frames) {
    Json list = Json::array();
    for (const measure::CourseFrame& frame : frames)
        list.push_back(
            {{"pairs", frame.reached.pairs},
             {"mean_level", or_null(frame.reached)},
             {"least_level", frame.reached.pairs == 0 ? Json() : Json(frame.reached.least)},
             {"tests", frame.tests}});
    return list;
}

Json json_of(const LevelFrames& result, const Options& options) {
    Json policies = Json::array();
    for (std::size_t p = 0; p < result.policies.size(); ++p) {
        Json frames = json_of(result.courses.of_priority[p]);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            frames[i]["milliseconds"] = result.courses.of_priority[p][i].milliseconds;
            frames[i]["cut"] = result.courses.of_priority[p][i].cut;
        }
        policies.push_back({{"policy", lod::name_of(result.policies[p])}, {"frames", frames}});
    }
    return {{"scene", result.scene},
            {"dim", result.dim},
            {"bodies", result.bodies},
            {"time_step", result.time_step},
            {"quota", quota_json(options)},
            {"without", {{"frames", json_of(result.courses.without)}}},
            {"policies", std::move(policies)}};
}

/// The frame in which most pairs meet, whatever is refined.
std::size_t fullest(const LevelFrames& result) {
    const Frames& frames = result.courses.without;
    return static_cast<std::size_t>(std::max_element(frames.begin(), frames.end(),
                                                     [](const auto& x, const auto& y) {
                                                         return x.reached.pairs < y.reached.pairs;
                                                     }) -
                                    frames.begin());
}

std::string title_of(const LevelFrames& result, const Options& options) {
    const std::size_t at = fullest(result);
    const std::size_t pairs = result.courses.without[at].reached.pairs;
    if (pairs == 0) return "No two bodies meet";
    std::string title =
        "Where " + std::to_string(pairs) + " pairs meet, " + quota_words(options) + " reach level ";
    for (std::size_t p = 0; p < std::min<std::size_t>(2, result.policies.size()); ++p) {
        if (p > 0) title += " or ";
        title += readable(result.courses.of_priority[p][at].reached.mean, 2) + " by " +
                 in_words(result.policies[p]);
    }
    return title + "; without a quota " + readable(result.courses.without[at].reached.mean, 2);
}

std::string report_of(const LevelFrames& result, const Options& options) {
    std::string text = result.scene + ": " + std::to_string(result.bodies) + " bodies, " +
                       quota_words(options) + " a frame\n" + title_of(result, options) +
                       "\n   time    pairs  no quota";
    for (const lod::Priority policy : result.policies)
        text += right(in_words(policy) + ", least", 24);
    text += "\n";
    constexpr std::size_t most_rows = 24;
    const std::size_t frames = result.courses.without.size();
    const std::size_t step = (frames + most_rows - 1) / most_rows;
    for (std::size_t i = 0; i < frames; i += step) {
        const lod::LevelsReached& without = result.courses.without[i].reached;
        text += right(readable(static_cast<double>(i) * result.time_step, 3), 7) +
                right(std::to_string(without.pairs), 9) + right(readable(without.mean, 3), 10);
        for (const Frames& of : result.courses.of_priority)
            text += right(readable(of[i].reached.mean, 3) + ", " +
                              std::to_string(std::max(0, of[i].reached.least)),
                          24);
        text += "\n";
    }
    return text +
           "level: mean over the pairs that nothing proved apart, and the least; every frame "
           "is done in all ways from the same state\n";
}

/// A value of every frame in which something meets.
template <class Value>
viz::Curve curve_of(const LevelFrames& result, const Frames& frames, const std::string& name,
                    const Value& value) {
    viz::Curve curve;
    curve.name = name;
    for (std::size_t i = 0; i < frames.size(); ++i)
        if (frames[i].reached.pairs > 0)
            curve.points.push_back(
                {static_cast<double>(i) * result.time_step, static_cast<double>(value(frames[i]))});
    return curve;
}

std::vector<viz::Curve> level_curves(const LevelFrames& result) {
    const auto mean = [](const measure::CourseFrame& frame) { return frame.reached.mean; };
    const auto least = [](const measure::CourseFrame& frame) { return frame.reached.least; };
    std::vector<viz::Curve> curves{curve_of(result, result.courses.without, "no quota", mean)};
    curves.back().reference = true;
    const bool with_least = result.policies.size() <= most_with_least;
    for (std::size_t p = 0; p < result.policies.size(); ++p) {
        const Frames& frames = result.courses.of_priority[p];
        const std::string name = in_words(result.policies[p]);
        curves.push_back(curve_of(result, frames, name, mean));
        curves.back().series = static_cast<int>(p);
        if (!with_least) continue;
        curves.push_back(curve_of(result, frames, name + ", least", least));
        curves.back().series = static_cast<int>(p) + 3;  // the same ink, dashed
    }
    return curves;
}

viz::Figure figure_of(const LevelFrames& result, const Options& options) {
    viz::Axes levels;
    levels.y.label = "level reached";
    levels.y.whole_numbers = true;
    viz::Axes pairs;
    pairs.x.label = "time [s]";
    pairs.y.label = "pairs that meet";
    const double end = static_cast<double>(result.courses.without.size()) * result.time_step;
    const auto count = [](const measure::CourseFrame& frame) { return frame.reached.pairs; };
    viz::Curve meeting = curve_of(result, result.courses.without, "", count);
    meeting.reference = true;
    viz::Figure figure;
    figure.title = title_of(result, options);
    figure.caption = "Mean over pairs that nothing proved apart, dashed the least; " +
                     viz::literal_text(result.scene) + ", " + std::to_string(result.bodies) +
                     " bodies; each frame is done in all ways from one state.";
    figure.columns = 1;
    figure.row_weights = {1.7, 1};
    figure.panels = {viz::plot_panel("", levels, level_curves(result)),
                     viz::plot_panel("", pairs, {meeting})};
    for (viz::Panel& panel : figure.panels) {
        panel.view.low = {0, 0};
        panel.view.high.x = end;
    }
    figure.scale_bar = false;
    return figure;
}

}  // namespace

void show_levels(const Options& options) {
    check_outputs(options, {});
    const LevelFrames result = measured_levels(options);
    show(
        options, [&] { return figure_of(result, options); },
        [&] { return json_of(result, options); }, [&] { return report_of(result, options); });
}

}  // namespace cli
