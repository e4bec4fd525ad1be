#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/choices.hpp"
#include "cli/arguments/misused.hpp"
#include "cli/commands/crowd.hpp"
#include "cli/stage/staging.hpp"
#include "cli/terminal/dimension.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "lodlab/measure/crowd/course.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/threads/thread_clock.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"
#include "lodlab/viz/draw/scene_view.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t fewest_frames = 2;  // the first one allocates, and is left out

/// Times of the frames of one run.
struct Times {
    measure::Spread milliseconds;
    double longest = 0;
    double level = 0;            ///< mean over the pairs that meet
    std::vector<double> beyond;  ///< times of the frames that took more than the quota [ms]
};

/// One number of bodies.
struct Size {
    int bodies = 0;
    std::int64_t frames = 0;  ///< measured
    Times without;
    std::vector<Times> under;  ///< the quota, policy by policy
};

struct FrameTimes {
    std::string crowd;
    int dim = 2;
    std::vector<lod::Priority> policies;
    std::vector<Size> sizes;
};

/// "100,1000"
std::vector<int> numbers_in(const std::string& text) {
    std::vector<int> numbers;
    for (const std::string& part : scenes::parted(text, ',')) {
        int number = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
        if (error != std::errc() || end != part.data() + part.size() || number < 1)
            misused("--bodies must be whole numbers from 1 on, as in 100,1000, not " + text);
        if (!numbers.empty() && number <= numbers.back())
            misused("--bodies must grow, as in 100,1000, not " + text);
        numbers.push_back(number);
    }
    return numbers;
}

/// The crowd that the scene names, without a number.
std::string crowd_of(const Options& options) {
    std::vector<std::string_view> names;
    for (const scenes::Crowd& crowd : scenes::crowds()) names.emplace_back(crowd.name);
    if (std::find(names.begin(), names.end(), options.scene) == names.end())
        misused("--bodies says how many: the scene must be the name of a crowd, " +
                scenes::listed(names) + ", not " + options.scene);
    return options.scene;
}

Options with_bodies(const Options& options, int bodies) {
    Options one = options;
    one.scene = crowd_of(options) + ":" + std::to_string(bodies);
    return one;
}

/// Whether a frame spent more than the quota, in the quota's unit.
bool is_beyond(const measure::CourseFrame& frame, const Options& options) {
    if (options.milliseconds) return frame.milliseconds > *options.milliseconds;
    return frame.tests > *options.budget;
}

Times times_of(const std::vector<measure::CourseFrame>& frames, const Options& options) {
    Times times;
    std::vector<double> all;
    double pairs = 0;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        const measure::CourseFrame& frame = frames[i];
        all.push_back(frame.milliseconds);
        times.longest = std::max(times.longest, frame.milliseconds);
        times.level += frame.reached.mean * static_cast<double>(frame.reached.pairs);
        pairs += static_cast<double>(frame.reached.pairs);
        if (is_beyond(frame, options)) times.beyond.push_back(frame.milliseconds);
    }
    times.level /= std::max(1.0, pairs);
    times.milliseconds = measure::spread(std::move(all));
    return times;
}

template <int Dim>
Size measured_size(const scenes::Scene& scene, const Options& options, const FrameTimes& result,
                   const std::function<void(double)>& progress) {
    const scenes::Setup<Dim> setup = stage<Dim>(scene, options);
    const scenes::ThreadClock clock;
    measure::CoursePlan<Dim> plan;
    plan.bodies = setup.bodies;
    plan.settings = scenes::frame_settings(scene, {});
    plan.frames = scene.frames();
    plan.clock = &clock;
    double runs = 0;
    plan.progress = [&](double share) {
        progress((runs + share) / (1 + static_cast<double>(result.policies.size())));
    };
    Size size;
    size.bodies = static_cast<int>(moving_in(scene));
    size.frames = plan.frames - 1;
    size.without = times_of(measure::course_of(plan), options);
    const scenes::Limits limits{{}, options.budget, options.milliseconds};
    plan.budget = [&] { return scenes::budget_of(limits, &clock); };
    for (const lod::Priority policy : result.policies) {
        runs += 1;
        plan.settings.priority = policy;
        size.under.push_back(times_of(measure::course_of(plan), options));
    }
    return size;
}

FrameTimes measured_times(const Options& options) {
    const std::vector<int> numbers = numbers_in(options.bodies);
    FrameTimes result;
    result.crowd = crowd_of(options);
    ProgressBar bar("Timing frames");
    for (const int number : numbers) {
        const Options one = with_bodies(options, number);
        const scenes::Scene scene = scene_of(one);
        if (scene.frames() < static_cast<std::int64_t>(fewest_frames))
            misused("--duration is one frame, which is not measured; give it two or more");
        result.dim = scene.dim;
        result.policies = policies_of(options, scene);
        const auto progress = [&](double share) {
            bar.show((static_cast<double>(result.sizes.size()) + share) /
                     static_cast<double>(numbers.size()));
        };
        in_dimension(scene.dim, [&](auto dim) {
            result.sizes.push_back(measured_size<dim()>(scene, options, result, progress));
        });
    }
    return result;
}

Json json_of(const Times& times) {
    return {{"milliseconds", cli::json_of(times.milliseconds)},
            {"longest", times.longest},
            {"level", times.level},
            {"beyond", times.beyond}};
}

Json json_of(const FrameTimes& result, const Options& options) {
    Json sizes = Json::array();
    for (const Size& size : result.sizes) {
        Json policies = Json::array();
        for (std::size_t p = 0; p < result.policies.size(); ++p) {
            Json one = {{"policy", lod::name_of(result.policies[p])}};
            one.update(json_of(size.under[p]));
            policies.push_back(std::move(one));
        }
        Json without = json_of(size.without);
        without.erase("beyond");
        sizes.push_back({{"bodies", size.bodies},
                         {"frames", size.frames},
                         {"without", std::move(without)},
                         {"policies", std::move(policies)}});
    }
    return {{"crowd", result.crowd},
            {"dim", result.dim},
            {"quota", quota_json(options)},
            {"clock", "processor time of the thread"},
            {"sizes", std::move(sizes)}};
}

std::string row_of(const std::string& name, const Times& times) {
    return "  " + name + std::string(name.size() < 24 ? 24 - name.size() : 1, ' ') +
           right(readable(times.milliseconds.median, 3), 9) +
           right(readable(times.milliseconds.p10, 3), 9) +
           right(readable(times.milliseconds.p90, 3), 9) + right(readable(times.longest, 3), 9) +
           right(readable(times.level, 3), 8);
}

std::string report_of(const FrameTimes& result, const Options& options) {
    std::string text = result.crowd + ": processor time of a frame [ms], measured\n";
    for (const Size& size : result.sizes) {
        text += std::to_string(size.bodies) + " bodies, " + std::to_string(size.frames) +
                " frames    median     10 %     90 %  longest   level   beyond the quota\n";
        text += row_of("no quota", size.without) + "\n";
        for (std::size_t p = 0; p < result.policies.size(); ++p)
            text +=
                row_of(quota_words(options) + ", " + in_words(result.policies[p]), size.under[p]) +
                right(std::to_string(size.under[p].beyond.size()), 8) + " frames\n";
    }
    return text;
}

std::string title_of(const FrameTimes& result, const Options& options) {
    const Size& last = result.sizes.back();
    return "With " + quota_words(options) + " nine frames of ten of " +
           std::to_string(last.bodies) + " bodies take at most " +
           readable(last.under.front().milliseconds.p90, 2) + " ms, without " +
           readable(last.without.milliseconds.p90, 2) + " ms";
}

/// A curve over the numbers of bodies, `of(size)` its times.
template <class Of>
viz::Curve curve_of(const FrameTimes& result, const std::string& name, int series, const Of& of) {
    viz::Curve curve;
    curve.name = name;
    curve.series = series;
    curve.dots = true;
    for (const Size& size : result.sizes) {
        const measure::Spread& spread = of(size).milliseconds;
        curve.points.push_back({static_cast<double>(size.bodies), spread.median});
        curve.low.push_back(spread.p10);
        curve.high.push_back(spread.p90);
    }
    return curve;
}

/// The frames beyond the quota, one by one.
void add_beyond(const FrameTimes& result, viz::Panel& panel) {
    for (const Size& size : result.sizes)
        for (const Times& times : size.under)
            for (const double milliseconds : times.beyond)
                panel.marks.push_back(viz::Dot{{.role = viz::Role::excess},
                                               {static_cast<double>(size.bodies), milliseconds},
                                               0.35});
}

/// The quota as a line, where there are two numbers of bodies to draw it between.
void add_quota(const FrameTimes& result, const Options& options, std::vector<viz::Curve>& curves) {
    if (!options.milliseconds || result.sizes.size() < 2) return;
    viz::Curve quota;
    quota.reference = true;
    for (const Size* size : {&result.sizes.front(), &result.sizes.back()})
        quota.points.push_back({static_cast<double>(size->bodies), *options.milliseconds});
    curves.push_back(std::move(quota));
}

/// Without the quota, and with it, by one scale.
viz::Figure figure_of(const FrameTimes& result, const Options& options) {
    const bool one = result.policies.size() == 1;
    std::vector<viz::Curve> without{
        curve_of(result, "", 1, [](const Size& size) -> const Times& { return size.without; })};
    std::vector<viz::Curve> under;
    for (std::size_t p = 0; p < result.policies.size(); ++p)
        under.push_back(curve_of(result, one ? "" : in_words(result.policies[p]),
                                 p == 0 ? 0 : static_cast<int>(p) + 1,
                                 [p](const Size& size) -> const Times& { return size.under[p]; }));
    for (std::vector<viz::Curve>* curves : {&without, &under}) add_quota(result, options, *curves);
    viz::Axes axes;
    axes.x.label = "bodies";
    axes.x.scale = viz::Scale::logarithmic;
    axes.y.label = "processor time of a frame [ms]";
    axes.y.scale = viz::Scale::logarithmic;
    viz::Figure figure;
    figure.title = title_of(result, options);
    figure.caption = "Measured: " + std::to_string(result.sizes.front().frames) + " frames of " +
                     viz::literal_text(result.crowd) +
                     " each, by the thread's own clock; median, 10 to 90 %; dashed the quota, red "
                     "the frames beyond it.";
    figure.panels = {viz::plot_panel("Without a quota", axes, without),
                     viz::plot_panel("With " + quota_words(options) +
                                         (one ? ", " + in_words(result.policies[0]) : ""),
                                     axes, under)};
    add_beyond(result, figure.panels[1]);
    viz::Box all = viz::united(figure.panels[0].view, figure.panels[1].view);
    for (const Size& size : result.sizes)
        for (const Times& times : size.under)
            all.high.y = std::max(all.high.y, 1.2 * times.longest);
    for (viz::Panel& panel : figure.panels) panel.view = all;
    figure.scale_bar = false;
    return figure;
}

}  // namespace

void show_times(const Options& options) {
    check_outputs(with_bodies(options, numbers_in(options.bodies).front()), {});
    const FrameTimes result = measured_times(options);
    show(
        options, [&] { return figure_of(result, options); },
        [&] { return json_of(result, options); }, [&] { return report_of(result, options); });
}

}  // namespace cli
