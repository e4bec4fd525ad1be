#include "lodlab/viz/draw/motion/draw_strip.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

constexpr double longest_arrow = 0.22;  ///< of the view's longer side

/// The net impulse of one body pair.
template <int Dim>
struct PairImpulse {
    int a = 0;
    int b = 0;
    lod::Vector<Dim> at = lod::Vector<Dim>::Zero();
    lod::Vector<Dim> push = lod::Vector<Dim>::Zero();  ///< on B [N s]
};

template <int Dim>
std::vector<PairImpulse<Dim>> pair_impulses(const lod::FrameRecord<Dim>& record) {
    std::vector<PairImpulse<Dim>> pairs;
    for (const lod::PairRecord& pair : record.pairs) {
        PairImpulse<Dim> net{pair.bodies.a, pair.bodies.b};
        double total = 0;
        for (std::int32_t i = 0; i < pair.contact_count; ++i) {
            const auto contact = static_cast<std::size_t>(pair.first_contact + i);
            const double j = record.impulses[contact];
            net.push += j * record.impacts[contact].contact.normal;
            net.at += j * record.impacts[contact].contact.point;
            total += j;
        }
        if (total <= 0) continue;
        net.at /= total;
        pairs.push_back(net);
    }
    return pairs;
}

template <int Dim>
struct Scales {
    double end;  ///< time of the last column [s]
    View<Dim> view;
    double metres_per_impulse = 1;
    double metres_per_speed = 1;
};

template <int Dim>
Scales<Dim> scales_of(const std::vector<Run<Dim>>& runs,
                      const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    const double end = end_time(runs);
    Scales<Dim> scales{end, view_of<Dim>(runs, end, viewpoint)};
    double impulse = 0;
    double speed = 0;
    for (const Run<Dim>& run : runs) {
        speed = std::max(speed, largest_speed(run));
        const int impact = first_impact(run);
        if (impact >= 0)
            impulse = std::max(impulse, largest_impulse(run, static_cast<std::size_t>(impact)));
    }
    const double longest = longest_arrow * longer_side(scales.view.box());
    if (impulse > 0) scales.metres_per_impulse = longest / impulse;
    if (speed > 0) scales.metres_per_speed = longest / speed;
    return scales;
}

std::string time_words(double time) {
    return "*t* = " + quantity_text(time, "s", 3);
}

template <int Dim>
void add_bodies(Panel& panel, const Run<Dim>& run, std::size_t instant, double opacity = 1) {
    const auto count = static_cast<int>(run.instants[instant].bodies.size());
    for (int i = 0; i < count; ++i) add_body(panel, actor_of(run, instant, i), i, opacity);
}

template <int Dim>
void add_velocities(Panel& panel, const Run<Dim>& run, std::size_t instant, double scale) {
    const auto& bodies = run.instants[instant].bodies;
    const SpinWords spin = bodies.size() <= 3 ? SpinWords::shown : SpinWords::left_out;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (!bodies[i].is_static())
            add_velocity<Dim>(panel, {bodies[i], static_cast<int>(i)}, scale, 1, spin);
}

/// The middle of all that the first instant shows, on the panel.
template <int Dim>
Point middle_of(const Run<Dim>& run, const Panel& panel) {
    Box box{{1e300, 1e300}, {-1e300, -1e300}};
    for (std::size_t b = 0; b < run.instants.front().bodies.size(); ++b) {
        const Actor<Dim> actor = actor_of(run, 0, static_cast<int>(b));
        const lod::Matrix<Dim> R = lod::Space<Dim>::rotation(actor.body.orientation);
        for (const lod::Vector<Dim>& p : DrawTraits<Dim>::points_of(actor.visual.outline)) {
            const Point at = DrawTraits<Dim>::on(panel, actor.body.position + R * p);
            box = united(box, {at, at});
        }
    }
    return {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
}

template <int Dim>
Panel start_panel(const Run<Dim>& run, const Scales<Dim>& scales, bool with_names) {
    Panel panel = blank_panel<Dim>(scales.view);
    panel.title = time_words(run.instants.front().time);
    add_bodies(panel, run, 0);
    add_velocities(panel, run, 0, scales.metres_per_speed);
    const auto& bodies = run.instants.front().bodies;
    if (!with_names || bodies.size() > 3) return panel;
    const Point middle = middle_of(run, panel);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (!bodies[i].is_static())
            add_name(panel, actor_of(run, 0, static_cast<int>(i)), shown_name(run.visuals, i),
                     static_cast<int>(i), middle);
    return panel;
}

template <int Dim>
std::string gap_words(const Run<Dim>& run, std::size_t instant) {
    const auto& record = run.instants[instant].record;
    double least = -1;
    for (const PairImpulse<Dim>& pair : pair_impulses(record)) {
        const double between = gap(actor_of(run, instant, pair.a), actor_of(run, instant, pair.b));
        if (between >= 0 && (least < 0 || between < least)) least = between;
    }
    if (least < 0) return {};
    return least > 0 ? ", gap " + length_text(least) : ", the shapes overlap";
}

template <int Dim>
Panel detection_panel(const Run<Dim>& run, const Scales<Dim>& scales) {
    Panel panel = blank_panel<Dim>(scales.view);
    const int impact = first_impact(run);
    if (impact < 0) {
        panel.title = "no collision";
        add_bodies(panel, run, run.instants.size() / 2);
        return panel;
    }
    const auto instant = static_cast<std::size_t>(impact);
    const lod::FrameRecord<Dim>& record = run.instants[instant].record;
    panel.title = time_words(run.instants[instant].time) + gap_words(run, instant);
    add_past(panel, run, instant, {.most_ghosts = 0});
    add_bodies(panel, run, instant, DrawTraits<Dim>::see_through);
    for (const lod::PairRecord& pair : record.pairs) {
        const auto nodes = nodes_of(record, pair);
        const auto& bodies = run.instants[instant].bodies;
        add_meeting_nodes<Dim>(
            panel, {bodies[static_cast<std::size_t>(pair.bodies.a)], pair.bodies.a},
            {bodies[static_cast<std::size_t>(pair.bodies.b)], pair.bodies.b}, nodes);
    }
    add_impulses(panel, run, instant, scales.metres_per_impulse);
    add_contact_points<Dim>(panel, contacts_of(record));
    return panel;
}

template <int Dim>
Panel end_panel(const Run<Dim>& run, const Scales<Dim>& scales) {
    Panel panel = blank_panel<Dim>(scales.view);
    const std::size_t last = instant_at(run, scales.end);
    panel.title = time_words(run.instants[last].time);
    add_past(panel, run, last);
    add_bodies(panel, run, last);
    add_velocities(panel, run, last, scales.metres_per_speed);
    return panel;
}

template <int Dim>
std::string motion_words(const Run<Dim>& run, std::size_t instant) {
    std::string words;
    const auto& bodies = run.instants[instant].bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].is_static()) continue;
        words += (words.empty() ? "" : ", ") + shown_name(run.visuals, i) + " at " +
                 quantity_text(bodies[i].velocity.norm(), "m/s") + " spinning at " +
                 quantity_text(DrawTraits<Dim>::amount(bodies[i].spin), "rad/s");
    }
    return words;
}

template <int Dim>
std::string alt_of(const Run<Dim>& run, double end) {
    std::string alt = " " + run.name + ": ";
    const int impact = first_impact(run);
    if (impact < 0) return alt + "no collision.";
    const auto instant = static_cast<std::size_t>(impact);
    const auto& record = run.instants[instant].record;
    alt += "detected at " + quantity_text(run.instants[instant].time, "s") + " with " +
           count_text(static_cast<long long>(record.impacts.size()), "contact") +
           gap_words(run, instant);
    return alt + "; at the end " + motion_words(run, instant_at(run, end)) + ".";
}

template <int Dim>
void refuse_empty(const std::vector<Run<Dim>>& runs) {
    bool empty = runs.empty();
    for (const Run<Dim>& run : runs) empty = empty || run.instants.empty();
    if (empty)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot draw strips: a run has no instants; simulate at least one frame");
}

}  // namespace

/// As long after the latest detection as that came after the start, where the runs go on so long.
template <int Dim>
double end_time(const std::vector<Run<Dim>>& runs) {
    double end = 0;
    double latest = 0;
    for (const Run<Dim>& run : runs) {
        end = std::max(end, run.instants.back().time);
        const int impact = first_impact(run);
        if (impact >= 0)
            latest = std::max(latest, run.instants[static_cast<std::size_t>(impact)].time);
    }
    return latest > 0 ? std::min(end, 2 * latest) : end;
}

template <int Dim>
View<Dim> view_of(const std::vector<Run<Dim>>& runs, double until,
                  const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    View<Dim> view(viewpoint, way_of(runs.front()));
    for (const Run<Dim>& run : runs) take_in<Dim>(view, run, instant_at(run, until));
    return view;
}

template <int Dim>
std::size_t instant_at(const Run<Dim>& run, double time) {
    const double at = std::round(time / run.time_step);
    return static_cast<std::size_t>(
        std::clamp(at, 0.0, static_cast<double>(run.instants.size() - 1)));
}

template <int Dim>
void add_past(Panel& panel, const Run<Dim>& run, std::size_t until, const PastChoice& choice) {
    const auto& present = run.instants[until].bodies;
    for (std::size_t b = 0; b < present.size(); ++b) {
        if (present[b].is_static()) continue;
        const int number = static_cast<int>(b);
        std::vector<lod::Vector<Dim>> path;
        double length = 0;
        for (std::size_t i = 0; i <= until; ++i) {
            const lod::Vector<Dim> at = run.instants[i].bodies[b].position;
            if (i > 0) length += (at - run.instants[i - 1].bodies[b].position).norm();
            path.push_back(at);
        }
        // Ghosts that lie closer than half their size would only blur each other.
        View<Dim> alone;
        take_in<Dim>(alone, actor_of(run, until, number));
        const double size = longer_side(alone.box());
        const auto ghosts = static_cast<std::size_t>(
            std::clamp(length / (0.5 * size), 0.0, static_cast<double>(choice.most_ghosts)));
        for (std::size_t g = 0; g < ghosts; ++g)
            add_ghost(panel, actor_of(run, until * g / ghosts, number), number,
                      0.25 + 0.45 * static_cast<double>(g) / static_cast<double>(ghosts));
        add_line<Dim>(
            panel, {.role = Role::trajectory, .body = number, .opacity = choice.trajectory_opacity},
            path, 0.15);
    }
}

template <int Dim>
void add_impulses(Panel& panel, const Run<Dim>& run, std::size_t instant, double metres_per_impulse,
                  double opacity) {
    for (const PairImpulse<Dim>& pair : pair_impulses(run.instants[instant].record))
        add_arrow<Dim>(panel, {.role = Role::impulse, .opacity = opacity}, pair.at,
                       pair.at + metres_per_impulse * pair.push,
                       "*j* = " + quantity_text(pair.push.norm(), "N s", 2));
}

template <int Dim>
double largest_impulse(const Run<Dim>& run, std::size_t instant) {
    double largest = 0;
    for (const PairImpulse<Dim>& pair : pair_impulses(run.instants[instant].record))
        largest = std::max(largest, pair.push.norm());
    return largest;
}

template <int Dim>
double largest_speed(const Run<Dim>& run) {
    double largest = 0;
    for (const Instant<Dim>& instant : run.instants)
        for (const lod::Body<Dim>& body : instant.bodies)
            largest = std::max(largest, body.velocity.norm());
    return largest;
}

template <int Dim>
Figure strips(const std::vector<Run<Dim>>& runs, const StripWords& words,
              const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    refuse_empty(runs);
    const Scales<Dim> scales = scales_of<Dim>(runs, viewpoint);
    Figure figure;
    figure.title = words.title;
    figure.caption = words.caption;
    if (figure.caption.empty())
        figure.caption = std::string("Bold ") + DrawTraits<Dim>::ball_word +
                         "s: nodes that intersect. Green: the impulse. Pale outlines: the past.";
    figure.alt = plain_text(words.title) +
                 ". One row a run: the start, the moment of detection, "
                 "and the end.";
    figure.columns = 3;
    figure.column_titles = {"Start", "Detection", "After"};
    for (const Run<Dim>& run : runs) {
        figure.row_titles.push_back(run.name);
        figure.panels.push_back(start_panel(run, scales, figure.panels.empty()));
        figure.panels.push_back(detection_panel(run, scales));
        figure.panels.push_back(end_panel(run, scales));
        figure.alt += alt_of(run, scales.end);
    }
    return figure;
}

template Figure strips<2>(const std::vector<Run<2>>&, const StripWords&,
                          const DrawTraits<2>::Viewpoint&);
template Figure strips<3>(const std::vector<Run<3>>&, const StripWords&,
                          const DrawTraits<3>::Viewpoint&);
template View<2> view_of<2>(const std::vector<Run<2>>&, double, const DrawTraits<2>::Viewpoint&);
template View<3> view_of<3>(const std::vector<Run<3>>&, double, const DrawTraits<3>::Viewpoint&);
template double end_time<2>(const std::vector<Run<2>>&);
template double end_time<3>(const std::vector<Run<3>>&);
template std::size_t instant_at<2>(const Run<2>&, double);
template std::size_t instant_at<3>(const Run<3>&, double);
template void add_past<2>(Panel&, const Run<2>&, std::size_t, const PastChoice&);
template void add_past<3>(Panel&, const Run<3>&, std::size_t, const PastChoice&);
template void add_impulses<2>(Panel&, const Run<2>&, std::size_t, double, double);
template void add_impulses<3>(Panel&, const Run<3>&, std::size_t, double, double);
template double largest_impulse<2>(const Run<2>&, std::size_t);
template double largest_impulse<3>(const Run<3>&, std::size_t);
template double largest_speed<2>(const Run<2>&);
template double largest_speed<3>(const Run<3>&);

}  // namespace viz
