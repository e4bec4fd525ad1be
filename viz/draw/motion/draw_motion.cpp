#include "lodlab/viz/draw/motion/draw_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

// The marks of a detection, in the order in which they appear.
constexpr int nodes = 0;
constexpr int contacts = 1;
constexpr int normals = 2;
constexpr int impulses = 3;
constexpr int velocities = 4;
constexpr int stages = 5;
constexpr double stage_seconds = 0.45;  ///< from one kind of mark to the next
constexpr double fade_seconds = 0.25;
constexpr double hold_seconds = 0.9;   ///< all of them together
constexpr double vanish_share = 0.04;  ///< of the run's time in which they vanish again
constexpr double near_impact = 0.08;   ///< of the run's time that counts as near
constexpr double end_seconds = 1.0;
constexpr double return_seconds = 0.6;

struct FilmMoment {
    double time = 0;         ///< of the simulation [s]
    double pause_time = -1;  ///< seconds since this pause began, or none
};

template <int Dim>
struct ImpactFilm {
    std::vector<Run<Dim>> runs;
    ImpactMotion choice;
    double end = 0;
    View<Dim> view;
    std::vector<int> impacts;  ///< of each run: the instant of detection, or -1
    double metres_per_impulse = 1;
    double metres_per_speed = 1;

    [[nodiscard]] double impact_time(std::size_t run) const {
        return impacts[run] < 0 ? -1
                                : runs[run].instants[static_cast<std::size_t>(impacts[run])].time;
    }
};

template <int Dim>
ImpactFilm<Dim> film_of(const std::vector<Run<Dim>>& runs, const ImpactMotion& choice,
                        const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    for (const Run<Dim>& run : runs)
        if (run.instants.empty())
            throw lod::Error(lod::ErrorKind::input_refused,
                             "cannot film a collision: a run has no instants; simulate at least "
                             "one frame");
    const double end = end_time(runs);
    ImpactFilm<Dim> film{runs, choice, end, view_of<Dim>(runs, end, viewpoint), {}, 1, 1};
    double impulse = 0;
    double speed = 0;
    for (const Run<Dim>& run : runs) {
        film.impacts.push_back(first_impact(run));
        speed = std::max(speed, largest_speed(run));
        if (film.impacts.back() >= 0)
            impulse = std::max(impulse,
                               largest_impulse(run, static_cast<std::size_t>(film.impacts.back())));
    }
    const double longest = 0.2 * longer_side(film.view.box());
    if (impulse > 0) film.metres_per_impulse = longest / impulse;
    if (speed > 0) film.metres_per_speed = longest / speed;
    return film;
}

/// The video's frames: which moment of the simulation each shows.
template <int Dim>
std::vector<FilmMoment> moments_of(const ImpactFilm<Dim>& film) {
    std::set<double> pauses;
    for (std::size_t r = 0; r < film.runs.size(); ++r)
        if (film.impacts[r] >= 0) pauses.insert(film.impact_time(r));
    const double frame = 1 / film.choice.frames_per_second;
    const double usual = film.end / std::max(0.1, film.choice.seconds);  // simulated s a video s
    std::vector<FilmMoment> moments;
    double time = 0;
    auto pause = pauses.begin();
    while (time < film.end) {
        if (pause != pauses.end() && time >= *pause) {
            for (double t = 0; t < stages * stage_seconds + hold_seconds; t += frame)
                moments.push_back({*pause, t});
            ++pause;
        }
        moments.push_back({time, -1});
        bool near = false;
        for (const double at : pauses) near = near || std::abs(time - at) < near_impact * film.end;
        double next = time + frame * usual * (near ? film.choice.slow : 1.0);
        if (pause != pauses.end() && time < *pause && next > *pause) next = *pause;
        time = next;
    }
    moments.push_back({film.end, -1});
    return moments;
}

double stage_opacity(double pause_time, int stage) {
    return std::clamp((pause_time - stage * stage_seconds) / fade_seconds, 0.0, 1.0);
}

/// How strongly each kind of mark of a run's detection shows at a moment.
template <int Dim>
std::array<double, stages> opacities(const ImpactFilm<Dim>& film, std::size_t run,
                                     const FilmMoment& moment) {
    std::array<double, stages> shown{};
    const double impact = film.impact_time(run);
    if (impact < 0 || moment.time < impact) return shown;
    const bool pausing = moment.pause_time >= 0 && moment.time == impact;
    const double since = moment.time - impact;
    const double gone = std::max(1e-9, vanish_share * film.end);
    for (int stage = 0; stage < stages; ++stage)
        shown[static_cast<std::size_t>(stage)] = pausing ? stage_opacity(moment.pause_time, stage)
                                                         : std::clamp(1 - since / gone, 0.0, 1.0);
    return shown;
}

template <int Dim>
void add_bodies(Panel& panel, const Run<Dim>& run, const std::vector<lod::Body<Dim>>& bodies,
                double opacity) {
    for (std::size_t b = 0; b < bodies.size(); ++b)
        add_body<Dim>(panel, {visual_at(run, b), bodies[b]}, static_cast<int>(b), opacity);
}

template <int Dim>
void add_detection(Panel& panel, const ImpactFilm<Dim>& film, std::size_t r,
                   const std::array<double, stages>& shown) {
    const Run<Dim>& run = film.runs[r];
    const auto instant = static_cast<std::size_t>(film.impacts[r]);
    const lod::FrameRecord<Dim>& record = run.instants[instant].record;
    const auto& bodies = run.instants[instant].bodies;
    if (shown[nodes] > 0) {
        for (const lod::PairRecord& pair : record.pairs) {
            const auto meeting = nodes_of(record, pair);
            add_meeting_nodes<Dim>(panel,
                                   {bodies[static_cast<std::size_t>(pair.bodies.a)], pair.bodies.a},
                                   {bodies[static_cast<std::size_t>(pair.bodies.b)], pair.bodies.b},
                                   meeting, shown[nodes]);
        }
    }
    const auto touching = contacts_of(record);
    if (shown[normals] > 0)
        add_normals<Dim>(panel, touching, 0.05 * longer_side(panel.view), shown[normals]);
    if (shown[contacts] > 0) add_contact_points<Dim>(panel, touching, shown[contacts]);
    if (shown[impulses] > 0)
        add_impulses(panel, run, instant, film.metres_per_impulse, shown[impulses]);
}

template <int Dim>
Panel run_panel(const ImpactFilm<Dim>& film, std::size_t r, const FilmMoment& moment,
                double opacity) {
    const Run<Dim>& run = film.runs[r];
    const std::vector<lod::Body<Dim>> bodies = bodies_at(run, moment.time);
    const auto shown = opacities(film, r, moment);
    Panel panel = blank_panel<Dim>(film.view);
    panel.title = run.name;
    const double impact = film.impact_time(r);
    if (impact >= 0 && moment.time >= impact)
        panel.title += ": repelled at *t* = " + fixed_text(impact, 2) + " s";
    const double past = std::min(moment.time, run.instants.back().time);
    const auto until = static_cast<std::size_t>(past / run.time_step + 1e-9);
    if (opacity == 1 && impact >= 0 && moment.time > impact)
        add_past(panel, run, std::min(until, run.instants.size() - 1), {.most_ghosts = 4});
    add_trails(panel, run, bodies, {.from = 0, .until = moment.time, .opacity = opacity});
    const double clear =
        (1 - DrawTraits<Dim>::see_through) * shown[nodes];  // to see the nodes within
    add_bodies(panel, run, bodies, opacity * (1 - clear));
    if (film.impacts[r] < 0) return panel;
    add_detection(panel, film, r, shown);
    if (shown[velocities] > 0) {
        const auto after =
            std::min(static_cast<std::size_t>(film.impacts[r]) + 1, run.instants.size() - 1);
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            lod::Body<Dim> body = bodies[b];
            body.velocity = run.instants[after].bodies[b].velocity;
            if (!body.is_static())
                add_velocity<Dim>(panel, {body, static_cast<int>(b)}, film.metres_per_speed,
                                  shown[velocities]);
        }
    }
    return panel;
}

template <int Dim>
Figure frame_figure(const ImpactFilm<Dim>& film, const FilmMoment& moment, double opacity = 1) {
    Figure figure;
    figure.title = film.choice.title;
    figure.caption = film.choice.caption;
    figure.numbers = {{"time", fixed_text(moment.time, 2) + "\u00A0s"}};
    for (std::size_t r = 0; r < film.runs.size(); ++r)
        figure.panels.push_back(run_panel(film, r, moment, opacity));
    if (film.runs.size() == 1 && film.runs[0].name.empty()) figure.panels[0].title.clear();
    return figure;
}

/// The end fades into the beginning, so that a loop has no seam.
template <int Dim>
Figure returning_figure(const ImpactFilm<Dim>& film, double share) {
    Figure figure = frame_figure<Dim>(film, {film.end, -1}, std::max(0.0, 1 - 2 * share));
    if (share >= 0.5) figure = frame_figure<Dim>(film, {0, -1}, 2 * share - 1);
    return figure;
}

}  // namespace

template <int Dim>
std::vector<lod::Body<Dim>> bodies_at(const Run<Dim>& run, double time) {
    const auto last = run.instants.size() - 1;
    const double at = std::max(0.0, time / run.time_step);
    const auto before = std::min(static_cast<std::size_t>(at + 1e-9), last);
    std::vector<lod::Body<Dim>> bodies = run.instants[before].bodies;
    if (before == last) return bodies;
    const double share = std::max(0.0, at - static_cast<double>(before));
    const std::vector<lod::Body<Dim>>& next = run.instants[before + 1].bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        bodies[b].position += share * (next[b].position - bodies[b].position);
        bodies[b].orientation =
            DrawTraits<Dim>::between(bodies[b].orientation, next[b].orientation, share);
    }
    return bodies;
}

template <int Dim>
void add_trails(Panel& panel, const Run<Dim>& run, const std::vector<lod::Body<Dim>>& bodies,
                const Trail& trail) {
    const auto first =
        static_cast<std::size_t>(std::max(0.0, std::ceil(trail.from / run.time_step - 1e-9)));
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].is_static()) continue;
        std::vector<lod::Vector<Dim>> path;
        for (std::size_t i = first; i < run.instants.size() && run.instants[i].time <= trail.until;
             ++i)
            path.push_back(run.instants[i].bodies[b].position);
        path.push_back(bodies[b].position);
        add_line<Dim>(
            panel,
            {.role = Role::trajectory, .body = static_cast<int>(b), .opacity = trail.opacity}, path,
            0);
    }
}

template <int Dim>
Animation impact_motion(const std::vector<Run<Dim>>& runs, const ImpactMotion& choice,
                        const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    if (runs.empty())
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot film a collision: there are no runs; simulate at least one");
    const auto film =
        std::make_shared<const ImpactFilm<Dim>>(film_of<Dim>(runs, choice, viewpoint));
    Animation animation;
    animation.frames_per_second = choice.frames_per_second;
    animation.title = choice.title;
    for (const FilmMoment& moment : moments_of(*film))
        animation.shots.push_back({[film, moment] { return frame_figure(*film, moment); }, 1});
    const auto frames_of = [&](double seconds) {
        return std::max(1, static_cast<int>(std::lround(seconds * choice.frames_per_second)));
    };
    animation.shots.back().frames = frames_of(end_seconds);
    const int returning = frames_of(return_seconds);
    for (int i = 1; i <= returning; ++i) {
        const double share = static_cast<double>(i) / (returning + 1);
        animation.shots.push_back({[film, share] { return returning_figure(*film, share); }, 1});
    }
    return animation;
}

template std::vector<lod::Body<2>> bodies_at<2>(const Run<2>&, double);
template std::vector<lod::Body<3>> bodies_at<3>(const Run<3>&, double);
template void add_trails<2>(Panel&, const Run<2>&, const std::vector<lod::Body<2>>&, const Trail&);
template void add_trails<3>(Panel&, const Run<3>&, const std::vector<lod::Body<3>>&, const Trail&);
template Animation impact_motion<2>(const std::vector<Run<2>>&, const ImpactMotion&,
                                    const DrawTraits<2>::Viewpoint&);
template Animation impact_motion<3>(const std::vector<Run<3>>&, const ImpactMotion&,
                                    const DrawTraits<3>::Viewpoint&);

}  // namespace viz
