#include <algorithm>

#include "lessons/course/05_possible_and_true/lesson.hpp"

namespace lessons::alarms {

// listing: count_alarms
Counts count_alarms(Bodies bodies, int placements) {
    lod::Random random(7);
    Counts counts;
    counts.false_alarms.resize(bodies.letter_out.size());
    for (int i = 0; i < placements; ++i) {
        drop(bodies, random);
        const std::vector<lod::Front> levels = bodies.traverse();
        const double gap = bodies.closest().distance;
        ++(gap == 0 ? counts.touching : counts.apart);
        bool was_alarm = true;
        for (std::size_t level = 0; level < counts.false_alarms.size(); ++level) {
            const bool alarm = !levels[std::min(level, levels.size() - 1)].pairs.empty();
            counts.misses += gap == 0 && was_alarm && !alarm ? 1 : 0;
            counts.false_alarms[level] += gap > 0 && alarm ? 1 : 0;
            counts.over_reach += alarm && gap > bodies.reach(level) ? 1 : 0;
            counts.risen += alarm && !was_alarm ? 1 : 0;
            was_alarm = alarm;
        }
        if (gap == 0 || levels.back().verdict != lod::Verdict::true_collision) continue;
        ++counts.false_collisions;
        counts.widest = std::max(counts.widest, gap);
    }
    return counts;
}
// end of listing

namespace {

/// The share of false alarms, level by level.
viz::Panel alarm_plot(const Counts& counts) {
    viz::Polyline curve = lessons::curve(1, "false alarms");
    for (std::size_t level = 0; level < counts.false_alarms.size(); ++level)
        curve.points.push_back(
            {static_cast<double>(level), 100.0 * counts.false_alarms[level] / counts.apart});
    viz::Panel panel;
    constexpr double room = 1.1;  // above the curve
    panel.view = box(0, 0, static_cast<double>(curve.points.size() - 1), room * curve.points[0].y);
    panel.axes = viz::Axes{{"level", viz::Scale::linear, {}, true},
                           {"of those apart [%]", viz::Scale::linear, {}, false}};
    for (const viz::Point& p : curve.points)
        panel.marks.push_back(viz::Dot{style(viz::Role::curve, 1), p});
    panel.marks.push_back(std::move(curve));
    return panel;
}

/// Where the star was dropped: those that touch, and those that do not.
viz::Panel drops(const Bodies& bodies, int shown) {
    viz::Panel panel;
    panel.view = box(-2.6, -2.4, 2.6, 2.4);
    Bodies moved = bodies;
    lod::Random random(7);
    for (int i = 0; i < shown; ++i) {
        drop(moved, random);
        const bool touches = moved.closest().distance == 0;
        add_body(panel, moved.star, style(touches ? viz::Role::body : viz::Role::reference, 1));
    }
    add_body(panel, bodies.letter, 0);
    return panel;
}

}  // namespace

void give_counts(Lesson& lesson, const Bodies& bodies, const Bodies& deeper) {
    constexpr int placements = 2000;
    constexpr int shown = 15;
    const Counts counts = count_alarms(bodies, placements);
    const Counts deep = count_alarms(deeper, placements);
    give(lesson, "placements", count(placements));
    give(lesson, "drawn", count(shown));
    give(lesson, "touching", count(counts.touching));
    give(lesson, "apart", count(counts.apart));
    give(lesson, "misses", count(counts.misses));
    give(lesson, "over reach", count(counts.over_reach));
    give(lesson, "risen", count(counts.risen));
    give(lesson, "false collisions", count(counts.false_collisions));
    give(lesson, "widest", number(counts.widest, 4, "m"));
    for (std::size_t level = 0; level < counts.false_alarms.size(); ++level)
        give(lesson, "alarms " + std::to_string(level), count(counts.false_alarms[level]));
    give(lesson, "deep misses", count(deep.misses));
    give(lesson, "deep false collisions", count(deep.false_collisions));
    give(lesson, "deep are", words(deep.false_collisions == 1 ? "is" : "are"));
    give(lesson, "deep widest", number(deep.widest, 4, "m"));
    give(lesson, "drops", drops(bodies, shown));
    give(lesson, "alarm curve", alarm_plot(counts));
}

}  // namespace lessons::alarms
