#include "viz/draw_strip.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "viz/number_text.hpp"

namespace viz {
namespace {

constexpr double longest_arrow = 0.22;  ///< of the view's longer side

/// The net impulse of one body pair.
struct PairImpulse {
    int a = 0;
    int b = 0;
    lod::Vector<2> at = lod::Vector<2>::Zero();
    lod::Vector<2> push = lod::Vector<2>::Zero();  ///< on B [N s]
};

std::vector<PairImpulse> pair_impulses(const lod::FrameRecord<2>& record) {
    std::vector<PairImpulse> pairs;
    for (const lod::PairRecord& pair : record.pairs) {
        PairImpulse net{pair.bodies.a, pair.bodies.b, {0, 0}, {0, 0}};
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

struct Scales {
    double end = 0;  ///< time of the last column [s]
    Box view;
    double metres_per_impulse = 1;
    double metres_per_speed = 1;
};

Scales scales_of(const std::vector<Run>& runs) {
    Scales scales{end_time(runs), bounds(runs.front().looks, runs.front().instants[0].bodies)};
    double impulse = 0;
    double speed = 0;
    for (const Run& run : runs) {
        scales.view = united(scales.view, bounds(run, instant_at(run, scales.end)));
        speed = std::max(speed, largest_speed(run));
        const int impact = first_impact(run);
        if (impact >= 0)
            impulse = std::max(impulse, largest_impulse(run, static_cast<std::size_t>(impact)));
    }
    const double longest = longest_arrow * longer_side(scales.view);
    if (impulse > 0) scales.metres_per_impulse = longest / impulse;
    if (speed > 0) scales.metres_per_speed = longest / speed;
    return scales;
}

std::string time_words(double time) {
    return "*t* = " + quantity_text(time, "s", 3);
}

void add_bodies(Marks& marks, const Run& run, std::size_t instant) {
    const auto count = static_cast<int>(run.instants[instant].bodies.size());
    for (int i = 0; i < count; ++i) add_body(marks, actor_of(run, instant, i), i);
}

void add_velocities(Marks& marks, const Run& run, std::size_t instant, double scale) {
    const auto& bodies = run.instants[instant].bodies;
    const SpinWords spin = bodies.size() <= 3 ? SpinWords::shown : SpinWords::left_out;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (!bodies[i].is_static())
            add_velocity(marks, bodies[i], static_cast<int>(i), scale, 1, spin);
}

Panel start_panel(const Run& run, const Scales& scales, bool with_names) {
    Panel panel;
    panel.view = scales.view;
    panel.title = time_words(run.instants.front().time);
    add_bodies(panel.marks, run, 0);
    add_velocities(panel.marks, run, 0, scales.metres_per_speed);
    const auto& bodies = run.instants.front().bodies;
    if (!with_names || bodies.size() > 3) return panel;
    const Box all = bounds(run.looks, bodies);
    const Point middle{(all.low.x + all.high.x) / 2, (all.low.y + all.high.y) / 2};
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (!bodies[i].is_static())
            add_name(panel.marks, actor_of(run, 0, static_cast<int>(i)), shown_name(run.looks, i),
                     static_cast<int>(i), middle);
    return panel;
}

std::string gap_words(const Run& run, std::size_t instant) {
    const auto& record = run.instants[instant].record;
    double least = -1;
    for (const PairImpulse& pair : pair_impulses(record)) {
        const double between = gap(actor_of(run, instant, pair.a), actor_of(run, instant, pair.b));
        if (between >= 0 && (least < 0 || between < least)) least = between;
    }
    if (least < 0) return {};
    return least > 0 ? ", gap " + length_text(least) : ", the shapes overlap";
}

Panel detection_panel(const Run& run, const Scales& scales) {
    Panel panel;
    panel.view = scales.view;
    const int impact = first_impact(run);
    if (impact < 0) {
        panel.title = "no collision";
        add_bodies(panel.marks, run, run.instants.size() / 2);
        return panel;
    }
    const auto instant = static_cast<std::size_t>(impact);
    const lod::FrameRecord<2>& record = run.instants[instant].record;
    panel.title = time_words(run.instants[instant].time) + gap_words(run, instant);
    add_past(panel.marks, run, instant, {.most_ghosts = 0});
    add_bodies(panel.marks, run, instant);
    for (const lod::PairRecord& pair : record.pairs) {
        const auto first = record.node_pairs.begin() + pair.first_contact;
        const std::vector<lod::NodePair> nodes(first, first + pair.contact_count);
        const auto& bodies = run.instants[instant].bodies;
        add_meeting_nodes(panel.marks, bodies[static_cast<std::size_t>(pair.bodies.a)],
                          bodies[static_cast<std::size_t>(pair.bodies.b)], pair.bodies.a,
                          pair.bodies.b, nodes);
    }
    add_impulses(panel.marks, run, instant, scales.metres_per_impulse);
    add_contact_points(panel.marks, contacts_of(record));
    return panel;
}

Panel end_panel(const Run& run, const Scales& scales) {
    Panel panel;
    panel.view = scales.view;
    const std::size_t last = instant_at(run, scales.end);
    panel.title = time_words(run.instants[last].time);
    add_past(panel.marks, run, last);
    add_bodies(panel.marks, run, last);
    add_velocities(panel.marks, run, last, scales.metres_per_speed);
    return panel;
}

std::string motion_words(const Run& run, std::size_t instant) {
    std::string words;
    const auto& bodies = run.instants[instant].bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].is_static()) continue;
        words += (words.empty() ? "" : ", ") + shown_name(run.looks, i) + " at " +
                 quantity_text(bodies[i].velocity.norm(), "m/s") + " spinning at " +
                 quantity_text(bodies[i].spin[0], "rad/s");
    }
    return words;
}

std::string alt_of(const Run& run, double end) {
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

void refuse_empty(const std::vector<Run>& runs) {
    bool empty = runs.empty();
    for (const Run& run : runs) empty = empty || run.instants.empty();
    if (empty)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot draw strips: a run has no instants; simulate at least one frame");
}

}  // namespace

/// As long after the latest detection as that came after the start, where the runs go on so long.
double end_time(const std::vector<Run>& runs) {
    double end = 0;
    double latest = 0;
    for (const Run& run : runs) {
        end = std::max(end, run.instants.back().time);
        const int impact = first_impact(run);
        if (impact >= 0)
            latest = std::max(latest, run.instants[static_cast<std::size_t>(impact)].time);
    }
    return latest > 0 ? std::min(end, 2 * latest) : end;
}

Box bounds(const Run& run, std::size_t until) {
    Box box = bounds(run.looks, run.instants.front().bodies);
    for (std::size_t i = 1; i <= until; ++i)
        box = united(box, bounds(run.looks, run.instants[i].bodies));
    return box;
}

std::size_t instant_at(const Run& run, double time) {
    const double at = std::round(time / run.time_step);
    return static_cast<std::size_t>(
        std::clamp(at, 0.0, static_cast<double>(run.instants.size() - 1)));
}

void add_past(Marks& marks, const Run& run, std::size_t until, const PastChoice& choice) {
    const auto& present = run.instants[until].bodies;
    for (std::size_t b = 0; b < present.size(); ++b) {
        if (present[b].is_static()) continue;
        const int number = static_cast<int>(b);
        Polyline path{
            {.role = Role::trajectory, .body = number, .opacity = choice.trajectory_opacity},
            {},
            0.15,
            {}};
        double length = 0;
        for (std::size_t i = 0; i <= until; ++i) {
            const lod::Vector<2> at = run.instants[i].bodies[b].position;
            if (i > 0) length += (at - run.instants[i - 1].bodies[b].position).norm();
            path.points.push_back(point_of(at));
        }
        // Ghosts that lie closer than half their size would only blur each other.
        const double size = longer_side(bounds({actor_of(run, until, number).look}, {present[b]}));
        const auto ghosts = static_cast<std::size_t>(
            std::clamp(length / (0.5 * size), 0.0, static_cast<double>(choice.most_ghosts)));
        for (std::size_t g = 0; g < ghosts; ++g)
            add_ghost(marks, actor_of(run, until * g / ghosts, number), number,
                      0.25 + 0.45 * static_cast<double>(g) / static_cast<double>(ghosts));
        if (path.points.size() > 1) marks.push_back(std::move(path));
    }
}

void add_impulses(Marks& marks, const Run& run, std::size_t instant, double metres_per_impulse,
                  double opacity) {
    for (const PairImpulse& pair : pair_impulses(run.instants[instant].record))
        marks.push_back(Arrow{{.role = Role::impulse, .opacity = opacity},
                              point_of(pair.at),
                              point_of(pair.at + metres_per_impulse * pair.push),
                              "*j* = " + quantity_text(pair.push.norm(), "N s", 2)});
}

double largest_impulse(const Run& run, std::size_t instant) {
    double largest = 0;
    for (const PairImpulse& pair : pair_impulses(run.instants[instant].record))
        largest = std::max(largest, pair.push.norm());
    return largest;
}

double largest_speed(const Run& run) {
    double largest = 0;
    for (const Instant& instant : run.instants)
        for (const lod::Body<2>& body : instant.bodies)
            largest = std::max(largest, body.velocity.norm());
    return largest;
}

Figure strips(const std::vector<Run>& runs, const StripWords& words) {
    refuse_empty(runs);
    const Scales scales = scales_of(runs);
    Figure figure;
    figure.title = words.title;
    figure.caption = words.caption;
    figure.alt = plain_text(words.title) +
                 ". One row a run: the start, the moment of detection, "
                 "and the end.";
    figure.columns = 3;
    figure.column_titles = {"Start", "Detection", "After"};
    for (const Run& run : runs) {
        figure.row_titles.push_back(run.name);
        figure.panels.push_back(start_panel(run, scales, figure.panels.empty()));
        figure.panels.push_back(detection_panel(run, scales));
        figure.panels.push_back(end_panel(run, scales));
        figure.alt += alt_of(run, scales.end);
    }
    return figure;
}

}  // namespace viz
