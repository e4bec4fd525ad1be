#include "lodlab/viz/draw/motion/draw_crowd.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/viz/draw/draw_scene.hpp"
#include "lodlab/viz/draw/motion/draw_strip.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

constexpr double held_seconds = 1.5;  ///< the result is held
constexpr double most_film_seconds = 40;
constexpr double most_overrun_shown = 2.5;  ///< quotas
constexpr double target_size = 2;           ///< of the fixation point's outer dot
constexpr double bull_size = 0.8;

/// What does not change from frame to frame.
template <int Dim>
struct CrowdFilm {
    Run<Dim> run;
    CrowdChoice choice;
    View<Dim> view;
    int deepest = 0;     ///< level of any tree
    double highest = 0;  ///< of the bar, in the quota's unit

    [[nodiscard]] std::string frame_name(std::size_t instant) const {
        return std::to_string(choice.first_frame + static_cast<std::int64_t>(instant));
    }
};

template <int Dim>
int deepest_level(const Run<Dim>& run) {
    int deepest = 0;
    for (const lod::Body<Dim>& body : run.instants.front().bodies)
        if (!body.tree->is_half_space()) deepest = std::max(deepest, body.tree->levels() - 1);
    return deepest;
}

double amount_of(const Quota& quota) {
    return quota.milliseconds ? *quota.milliseconds
                              : static_cast<double>(quota.node_tests.value_or(0));
}

template <int Dim>
double highest_bar(const Run<Dim>& run, const Quota& quota) {
    const double amount = amount_of(quota);
    double highest = amount;
    for (const Instant<Dim>& instant : run.instants)
        if (const auto use = use_of(instant.record, quota))
            highest = std::max(highest, use->levels + use->response);
    highest = amount > 0 ? std::min(highest, most_overrun_shown * amount) : highest;
    return highest > 0 ? 1.06 * highest : 1;
}

template <int Dim>
CrowdFilm<Dim> crowd_film(const Run<Dim>& run, const CrowdChoice& choice,
                          const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    if (run.instants.empty())
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot draw a crowd: it has no instants; simulate at least one frame");
    CrowdFilm<Dim> film{run, choice, view_of<Dim>({run}, run.instants.back().time, viewpoint),
                        deepest_level(run), highest_bar(run, choice.quota)};
    if (film.choice.frames == 0)
        film.choice.frames = static_cast<std::int64_t>(run.instants.size());
    return film;
}

std::string amount_text(double amount, const Quota& quota) {
    if (!quota.milliseconds) return number_text(amount, 9);
    const double size = std::max(1e-6, *quota.milliseconds);
    const int decimals = std::clamp(3 - static_cast<int>(std::ceil(std::log10(size))), 0, 6);
    return fixed_text(amount, decimals);
}

std::string quota_text(const Quota& quota) {
    if (quota.milliseconds) return quantity_text(*quota.milliseconds, "ms");
    return number_text(static_cast<double>(*quota.node_tests), 9) + "\u00A0tests";
}

std::string level_text(const lod::LevelsReached& reached) {
    return reached.pairs == 0 ? "none" : fixed_text(reached.mean, 1);
}

/// What one frame shows.
template <int Dim>
std::string frame_finding(const CrowdFilm<Dim>& film, std::size_t instant) {
    const lod::FrameRecord<Dim>& record = film.run.instants[instant].record;
    const lod::LevelsReached reached = record.levels_reached();
    const std::string frame = "frame " + film.frame_name(instant);
    if (reached.pairs == 0) return "No two bodies meet in " + frame;
    const std::string level = " level " + level_text(reached);
    const auto use = use_of(record, film.choice.quota);
    if (!use) return "The pairs that meet in " + frame + " reach" + level + " in the mean";
    const bool timed = film.choice.quota.milliseconds.has_value();
    const std::string spent = number_text(use->levels + use->response, timed ? 3 : 9);
    const std::string begin = "Frame " + film.frame_name(instant) + " takes " + spent;
    if (use->overrun == 0)
        return begin + " of " + quota_text(film.choice.quota) + " and brings its pairs to" + level;
    return begin + (timed ? "\u00A0ms, " : "\u00A0tests, ") +
           number_text(use->overrun, timed ? 2 : 9) + " beyond its quota, and brings its pairs to" +
           level;
}

/// What the whole run shows.
template <int Dim>
std::string run_finding(const CrowdFilm<Dim>& film) {
    const Quota& quota = film.choice.quota;
    std::size_t kept = 0;
    std::size_t cut = 0;
    double pairs = 0;
    double levels = 0;
    for (const Instant<Dim>& instant : film.run.instants) {
        const lod::LevelsReached reached = instant.record.levels_reached();
        pairs += static_cast<double>(reached.pairs);
        levels += static_cast<double>(reached.pairs) * reached.mean;
        const auto use = use_of(instant.record, quota);
        kept += use && use->overrun == 0 ? 1 : 0;
        cut += instant.record.interrupted() ? 1 : 0;
    }
    const std::string of = " of " + std::to_string(film.run.instants.size());
    const std::string level = pairs > 0 ? fixed_text(levels / pairs, 1) : "none";
    if (quota.milliseconds)
        return quota_text(quota) + " is kept in " + std::to_string(kept) + of +
               " frames, with pairs that meet at level " + level;
    if (quota.node_tests)
        return quota_text(quota) + " cut " + std::to_string(cut) + of +
               " frames, with pairs that meet at level " + level;
    return "Pairs that meet reach level " + level + " in the mean";
}

template <int Dim>
void add_fixation(Panel& panel, const std::array<double, 3>& fixation) {
    lod::Vector<Dim> point;
    for (int axis = 0; axis < Dim; ++axis) point[axis] = fixation[static_cast<std::size_t>(axis)];
    const Point at = DrawTraits<Dim>::on(panel, point);
    const Style style{.role = Role::contact};
    for (const double size : {target_size, bull_size}) panel.marks.push_back(Dot{style, at, size});
}

template <int Dim>
Panel crowd_panel(const CrowdFilm<Dim>& film, const Instant<Dim>& instant) {
    const std::vector<int> levels = body_levels<Dim>(instant.record, instant.bodies.size());
    Panel panel = blank_panel<Dim>(film.view);
    for (std::size_t b = 0; b < instant.bodies.size(); ++b) {
        const Actor<Dim> actor{visual_at(film.run, b), instant.bodies[b]};
        const int number = static_cast<int>(b);
        if (instant.bodies[b].is_static())
            add_body<Dim>(panel, actor, number);
        else
            add_body<Dim>(panel, actor,
                          Style{.role = Role::reached, .body = number, .level = levels[b]});
    }
    if (film.choice.fixation) add_fixation<Dim>(panel, *film.choice.fixation);
    return panel;
}

/// Of how many bodies each level is the least.
template <int Dim>
Panel level_list(const CrowdFilm<Dim>& film, const Instant<Dim>& instant) {
    const int last = std::min(film.deepest, deepest_ink);
    std::vector<int> counts(static_cast<std::size_t>(last) + 2);
    const std::vector<int> levels = body_levels<Dim>(instant.record, instant.bodies.size());
    for (std::size_t b = 0; b < levels.size(); ++b)
        if (!instant.bodies[b].is_static())
            ++counts[static_cast<std::size_t>(std::min(levels[b], last) + 1)];
    Panel panel;
    panel.title = "Bodies by level reached";
    for (int level = -1; level <= last; ++level) {
        std::string words = level < 0 ? "none" : "level " + std::to_string(level);
        if (level == last && film.deepest > last) words += " and deeper";
        panel.entries.push_back({{.role = Role::reached, .level = level},
                                 words,
                                 std::to_string(counts[static_cast<std::size_t>(level + 1)])});
    }
    return panel;
}

struct BarPart {
    Style style;
    const char* words;
    double amount;
};

/// From the bar's foot to its top; what is over last, beyond the quota.
std::vector<BarPart> parts_of(const QuotaUse& use, const Quota& quota) {
    const auto share = [](int part) { return Style{.role = Role::share, .body = part}; };
    std::vector<BarPart> parts{{share(0), "levels", std::min(use.levels, use.quota)}};
    if (quota.milliseconds)
        parts.push_back(
            {share(1), "response", std::min(use.response, std::max(0.0, use.quota - use.levels))});
    parts.push_back({share(2), "reserve left", use.reserve});
    parts.push_back({share(3), "unused", use.unused});
    parts.push_back({{.role = Role::excess}, "overrun", use.overrun});
    return parts;
}

Panel quota_list(const QuotaUse& use, const Quota& quota) {
    Panel panel;
    panel.title = "Quota of " + quota_text(quota);
    for (const BarPart& part : parts_of(use, quota))
        panel.entries.push_back({part.style, part.words, amount_text(part.amount, quota)});
    return panel;
}

Panel quota_bar(const QuotaUse& use, const Quota& quota, double highest) {
    Panel panel;
    panel.axes.emplace();
    panel.axes->x.hidden = true;
    panel.axes->y.label = quota.milliseconds ? "ms" : "tests";
    panel.view = {{0, 0}, {1, highest}};
    double from = 0;
    for (const BarPart& part : parts_of(use, quota)) {
        const double to = std::min(from + part.amount, highest);
        if (to > from)
            panel.marks.push_back(
                Path{part.style, {{{0.1, from}, {0.9, from}, {0.9, to}, {0.1, to}}}});
        from = std::max(from, to);
    }
    panel.marks.push_back(Polyline{{.role = Role::note}, {{0, use.quota}, {1, use.quota}}, 1, {}});
    return panel;
}

template <int Dim>
std::vector<Quantity> numbers_of(const CrowdFilm<Dim>& film, std::size_t instant) {
    const lod::FrameRecord<Dim>& record = film.run.instants[instant].record;
    const lod::LevelsReached reached = record.levels_reached();
    std::vector<Quantity> numbers{
        {"frame", film.frame_name(instant) + " of " + std::to_string(film.choice.frames)}};
    const auto use = use_of(record, film.choice.quota);
    if (use && film.choice.quota.milliseconds)
        numbers.push_back(
            {"frame time",
             amount_text(use->levels + use->response, film.choice.quota) + "\u00A0ms"});
    else
        numbers.push_back({"node tests", number_text(static_cast<double>(record.tests), 9)});
    numbers.push_back({"pairs that meet", std::to_string(reached.pairs)});
    numbers.push_back({"mean level", level_text(reached)});
    return numbers;
}

/// The scene at the left, the lists beside it, the bar along the right edge.
void lay_out(Figure& figure, std::size_t levels) {
    constexpr double list_share = 0.56;
    constexpr double bar_share = 0.23;
    const bool bar = figure.panels.size() > 2;
    figure.columns = bar ? 3 : 2;
    figure.column_weights = {1.9, list_share};
    figure.panels[0].cell = Cell{0, 0, bar ? 2 : 1, 1};
    figure.panels[1].cell = Cell{0, 1};
    if (!bar) return;
    figure.column_weights.push_back(bar_share);
    figure.row_weights = {static_cast<double>(levels) + 1.5, 6.5};
    figure.panels[2].cell = Cell{1, 1};
    figure.panels[3].cell = Cell{0, 2, 2, 1};
}

template <int Dim>
Figure crowd_frame(const CrowdFilm<Dim>& film, std::size_t instant, const std::string& title) {
    const Instant<Dim>& shown = film.run.instants[instant];
    const CrowdChoice& choice = film.choice;
    Figure figure;
    figure.title = title;
    figure.numbers = numbers_of(film, instant);
    figure.panels.push_back(crowd_panel(film, shown));
    figure.panels.push_back(level_list(film, shown));
    const auto use = use_of(shown.record, choice.quota);
    if (use) {
        figure.panels.push_back(quota_list(*use, choice.quota));
        figure.panels.push_back(quota_bar(*use, choice.quota, film.highest));
    }
    figure.caption = choice.caption;
    if (figure.caption.empty()) {
        figure.caption = "A body's level is the least of its pairs that nothing proved apart.";
        if (choice.fixation) figure.caption += " The ring: where the observer looks.";
    }
    figure.alt = plain_text(frame_finding(film, instant)) + ". Bodies by level reached:";
    for (const Entry& entry : figure.panels[1].entries)
        figure.alt += " " + entry.words + " " + entry.value + ";";
    if (use)
        for (const Entry& entry : figure.panels[2].entries)
            figure.alt += " " + entry.words + " " + entry.value + ";";
    figure.alt.back() = '.';
    lay_out(figure, figure.panels[1].entries.size());
    return figure;
}

}  // namespace

template <int Dim>
std::vector<int> body_levels(const lod::FrameRecord<Dim>& record, std::size_t bodies) {
    std::vector<int> levels(bodies, -1);
    for (const lod::PairRecord& pair : record.pairs) {
        if (pair.verdict == lod::Verdict::apart) continue;
        for (const std::int32_t body : {pair.bodies.a, pair.bodies.b}) {
            int& level = levels[lod::at(body)];
            level = level < 0 ? pair.level : std::min(level, pair.level);
        }
    }
    return levels;
}

template <int Dim>
std::size_t fullest_instant(const Run<Dim>& run) {
    std::size_t fullest = 0;
    std::size_t most = 0;
    for (std::size_t i = 0; i < run.instants.size(); ++i) {
        const std::size_t pairs = run.instants[i].record.levels_reached().pairs;
        if (pairs <= most) continue;
        most = pairs;
        fullest = i;
    }
    return fullest;
}

template <int Dim>
Figure crowd_picture(const Run<Dim>& run, std::size_t instant, const CrowdChoice& choice,
                     const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    const CrowdFilm<Dim> film = crowd_film<Dim>(run, choice, viewpoint);
    if (instant >= run.instants.size())
        throw lod::Error(lod::ErrorKind::input_refused, "cannot draw a crowd: it has " +
                                                            std::to_string(run.instants.size()) +
                                                            " instants; name one of them, from 0");
    return crowd_frame(film, instant,
                       choice.title.empty() ? frame_finding(film, instant) : choice.title);
}

template <int Dim>
Animation crowd_motion(const Run<Dim>& run, const CrowdChoice& choice,
                       const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    const auto film =
        std::make_shared<const CrowdFilm<Dim>>(crowd_film<Dim>(run, choice, viewpoint));
    const std::string title = choice.title.empty() ? run_finding(*film) : choice.title;
    Animation animation;
    animation.frames_per_second = choice.frames_per_second;
    animation.title = plain_text(title);
    const double most = most_film_seconds * choice.frames_per_second;
    const auto every =
        static_cast<std::size_t>(std::ceil(static_cast<double>(run.instants.size()) / most));
    const std::size_t last = run.instants.size() - 1;
    for (std::size_t i = 0; i < last; i += every)
        animation.shots.push_back({[film, i, title] { return crowd_frame(*film, i, title); }, 1});
    animation.shots.push_back(
        {[film, last, title] { return crowd_frame(*film, last, title); },
         std::max(1, static_cast<int>(std::lround(held_seconds * choice.frames_per_second)))});
    return animation;
}

#define VIZ_INSTANTIATE(Dim)                                                          \
    template std::vector<int> body_levels(const lod::FrameRecord<Dim>&, std::size_t); \
    template std::size_t fullest_instant(const Run<Dim>&);                            \
    template Figure crowd_picture(const Run<Dim>&, std::size_t, const CrowdChoice&,   \
                                  const DrawTraits<Dim>::Viewpoint&);                 \
    template Animation crowd_motion(const Run<Dim>&, const CrowdChoice&,              \
                                    const DrawTraits<Dim>::Viewpoint&);
VIZ_INSTANTIATE(2)
VIZ_INSTANTIATE(3)
#undef VIZ_INSTANTIATE

}  // namespace viz
