#include "lodlab/viz/draw/motion/draw_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

constexpr int few_bodies = 3;        ///< that move: names and ghosts have room
constexpr double still_seconds = 1;  ///< of the last picture

template <int Dim>
using Bodies = std::vector<lod::Body<Dim>>;

template <int Dim>
int moving(const Bodies<Dim>& bodies) {
    return static_cast<int>(std::count_if(bodies.begin(), bodies.end(),
                                          [](const auto& body) { return !body.is_static(); }));
}

template <int Dim>
void add_bodies(Panel& panel, const Run<Dim>& run, const Bodies<Dim>& bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b)
        add_body<Dim>(panel, {visual_at(run, b), bodies[b]}, static_cast<int>(b));
}

template <int Dim>
void add_reference_outlines(Panel& panel, const Run<Dim>& reference, const Bodies<Dim>& bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Visual<Dim> visual = visual_at(reference, b);
        if (bodies[b].is_static() || !DrawTraits<Dim>::shown(visual.outline)) continue;
        DrawTraits<Dim>::add_outline(panel, {.role = Role::reference, .body = static_cast<int>(b)},
                                     visual.outline, bodies[b]);
    }
}

template <int Dim>
void add_reference_ways(Panel& panel, const Run<Dim>& reference, std::size_t until) {
    for (std::size_t b = 0; b < reference.instants[until].bodies.size(); ++b) {
        if (reference.instants[until].bodies[b].is_static()) continue;
        std::vector<lod::Vector<Dim>> way;
        for (std::size_t i = 0; i <= until; ++i)
            way.push_back(reference.instants[i].bodies[b].position);
        add_line<Dim>(panel, {.role = Role::reference, .body = static_cast<int>(b)}, way, 1);
    }
}

template <int Dim>
void refuse_empty(const std::vector<Run<Dim>>& runs, const Run<Dim>& reference) {
    bool empty = runs.empty() || reference.instants.empty();
    for (const Run<Dim>& run : runs) empty = empty || run.instants.empty();
    if (empty)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot compare: a run has no instants; simulate at least one frame");
}

template <int Dim>
std::vector<Run<Dim>> with(std::vector<Run<Dim>> runs, const Run<Dim>& reference) {
    runs.push_back(reference);
    return runs;
}

/// The name of the reference beside the outline of its first moving body.
template <int Dim>
void name_reference(Panel& panel, const Run<Dim>& reference, const Bodies<Dim>& bodies,
                    const Bodies<Dim>& others) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].is_static()) continue;
        Panel named;
        named.view = panel.view;
        named.space = panel.space;
        add_name<Dim>(named, {visual_at(reference, b), bodies[b]}, reference.name,
                      static_cast<int>(b), DrawTraits<Dim>::on(panel, others[b].position));
        for (Mark& mark : named.marks) {
            if (auto* label = std::get_if<Label>(&mark)) label->style.role = Role::reference;
            panel.marks.push_back(std::move(mark));
        }
        return;
    }
}

template <int Dim>
Panel comparison_panel(const Run<Dim>& run, const Run<Dim>& reference, double until,
                       const View<Dim>& view) {
    Panel panel = blank_panel<Dim>(view);
    panel.title = run.name;
    const std::size_t last = instant_at(run, until);
    const std::size_t last_of_reference = instant_at(reference, until);
    const Bodies<Dim>& bodies = run.instants[last].bodies;
    const Bodies<Dim>& reference_bodies = reference.instants[last_of_reference].bodies;
    const bool few = moving<Dim>(bodies) <= few_bodies;
    add_reference_ways(panel, reference, last_of_reference);
    add_past(panel, run, last, {.most_ghosts = few ? 3 : 0});
    add_bodies(panel, run, bodies);
    add_reference_outlines(panel, reference, reference_bodies);
    if (few) name_reference<Dim>(panel, reference, reference_bodies, bodies);
    return panel;
}

template <int Dim>
std::string alt_of(const Run<Dim>& run, const Run<Dim>& reference, double until) {
    const Bodies<Dim>& seen = run.instants[instant_at(run, until)].bodies;
    const Bodies<Dim>& right = reference.instants[instant_at(reference, until)].bodies;
    double furthest = 0;
    for (std::size_t b = 0; b < seen.size(); ++b)
        furthest = std::max(furthest, (seen[b].position - right[b].position).norm());
    std::string words = " ";
    words.append(plain_text(run.name)).append(": no body more than ");
    words.append(length_text(furthest)).append(" from where ");
    return words.append(plain_text(reference.name)).append(" has it.");
}

/// What does not change from frame to frame.
template <int Dim>
struct ComparedRuns {
    std::vector<Run<Dim>> runs;
    Run<Dim> reference;
    ComparisonMotion choice;
    View<Dim> view;
    double end;
};

template <int Dim>
Figure film_frame(const ComparedRuns<Dim>& film, double time) {
    Figure figure;
    figure.title = film.choice.words.title;
    figure.caption = film.choice.words.caption;
    figure.numbers = {{"time", fixed_text(time, 2) + "\u00A0s"}};
    figure.columns = film.runs.size() == 3 ? 2 : 0;
    const Bodies<Dim> right = bodies_at(film.reference, time);
    const double from = std::max(0.0, time - film.choice.trail);
    for (const Run<Dim>& run : film.runs) {
        Panel& panel = figure.panels.emplace_back(blank_panel<Dim>(film.view));
        panel.title = run.name;
        const Bodies<Dim> bodies = bodies_at(run, time);
        add_trails(panel, run, bodies, {.from = from, .until = time});
        add_bodies(panel, run, bodies);
        add_reference_outlines(panel, film.reference, right);
    }
    Panel& panel = figure.panels.emplace_back(blank_panel<Dim>(film.view));
    panel.title = film.reference.name;
    add_trails(panel, film.reference, right, {.from = from, .until = time});
    add_bodies(panel, film.reference, right);
    return figure;
}

}  // namespace

template <int Dim>
Figure comparison(const std::vector<Run<Dim>>& runs, const Run<Dim>& reference, double until,
                  const ComparisonWords& words,
                  const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    refuse_empty(runs, reference);
    const View<Dim> view = view_of<Dim>(with(runs, reference), until, viewpoint);
    Figure figure;
    figure.title = words.title;
    figure.caption = words.caption;
    figure.numbers = {{"time", quantity_text(until, "s")}};
    figure.alt = plain_text(words.title) + ". A panel a run, after " + quantity_text(until, "s") +
                 ", the reference dashed.";
    for (const Run<Dim>& run : runs) {
        figure.panels.push_back(comparison_panel<Dim>(run, reference, until, view));
        figure.alt += alt_of(run, reference, until);
    }
    return figure;
}

template <int Dim>
Animation comparison_motion(const std::vector<Run<Dim>>& runs, const Run<Dim>& reference,
                            const ComparisonMotion& choice,
                            const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    refuse_empty(runs, reference);
    const std::vector<Run<Dim>> all = with(runs, reference);
    double end = 0;
    for (const Run<Dim>& run : all) end = std::max(end, run.instants.back().time);
    const auto film = std::make_shared<const ComparedRuns<Dim>>(
        ComparedRuns<Dim>{runs, reference, choice, view_of<Dim>(all, end, viewpoint), end});
    Animation animation;
    animation.frames_per_second = choice.frames_per_second;
    animation.title = choice.words.title;
    const int frames = std::max(2, static_cast<int>(choice.seconds * choice.frames_per_second));
    for (int i = 0; i < frames; ++i) {
        const double time = end * i / (frames - 1);
        animation.shots.push_back({[film, time] { return film_frame(*film, time); }, 1});
    }
    animation.shots.back().frames =
        static_cast<int>(std::lround(still_seconds * choice.frames_per_second));
    return animation;
}

#define VIZ_INSTANTIATE(Dim)                                                                    \
    template Figure comparison<Dim>(const std::vector<Run<Dim>>&, const Run<Dim>&, double,      \
                                    const ComparisonWords&, const DrawTraits<Dim>::Viewpoint&); \
    template Animation comparison_motion<Dim>(const std::vector<Run<Dim>>&, const Run<Dim>&,    \
                                              const ComparisonMotion&,                          \
                                              const DrawTraits<Dim>::Viewpoint&);
VIZ_INSTANTIATE(2)
VIZ_INSTANTIATE(3)
#undef VIZ_INSTANTIATE

}  // namespace viz
