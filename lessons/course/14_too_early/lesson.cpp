#include "lessons/course/14_too_early/lesson.hpp"

#include <cmath>

#include "lodlab/core/exact/level_impact.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/viz/draw/motion/draw_backtracking.hpp"

namespace lessons {
namespace early {
namespace {

using lod::Body;
using lod::Sphere;
using Vec = lod::Vector<2>;

constexpr int level = 1;
constexpr double time_step = 1.0 / 120;  // [s]
constexpr lod::ImpactSettings ahead{.horizon = 2};

lod::TimeOfImpact<2> touch_of(const Meeting& stars) {
    return lod::level_impact(stars.a.body, stars.b.body, level, ahead);
}

/// Two stars that pass each other, their large circles of level 1 towards each other.
Meeting passing_stars() {
    constexpr double degree = lod::full_turn / 360;
    Meeting stars = meeting_of("star:5", "star:5", 4);
    stars.a.visual.name = "A";
    stars.b.visual.name = "B";
    stars.a.body.position = Vec(-1.5, 0);
    stars.a.body.orientation = -108 * degree;
    stars.a.body.velocity = Vec(1.5, 0);
    stars.b.body.orientation = 72 * degree;
    stars.b.body.velocity = Vec(-1.5, 0);
    double height = 1.2;  // then lower, until circles of the level meet
    do stars.b.body.position = Vec(1.5, height -= 0.01);
    while (touch_of(stars).outcome != lod::ImpactOutcome::touching);
    stars.b.body.position.y() -= 0.06;
    return stars;
}

/// The three moments of the paper's figure 5, their gaps in the text's unit.
void give_panels(Lesson& lesson, const Meeting& stars) {
    viz::Figure story = viz::inappropriate_backtracking<2>(
        stars.a, stars.b, {.level = level, .time_step = time_step, .horizon = ahead.horizon});
    for (const auto& [panel, gap] : {std::pair{1u, "gap"}, {2u, "least gap"}})
        for (viz::Mark& mark : story.panels[panel].marks)
            if (auto* label = std::get_if<viz::Label>(&mark);
                label && label->text.starts_with("gap"))
                label->text = lesson.numbers[gap].text;
    story.panels[0].title.clear();  // its time is asked for
    story.panels[1].view = box(-0.6, 0.03, 0.65, 0.92);
    for (const auto& [name, panel] : {std::pair{"found", 0u}, {"rewound", 1u}, {"nearest", 2u}})
        give(lesson, name, viz::Panel(story.panels[panel]));
}

/// When two circles of level 1 touch that meet first, from where they start.
void give_first_touch(Lesson& lesson, const Meeting& stars, double touch) {
    const auto at = [&](const Body<2>& body, double time) {
        return lod::moved_freely(body, time, ahead.longest_turn);
    };
    const double found = time_step * std::ceil(touch / time_step);
    const Body<2> a = at(stars.a.body, found);
    const Body<2> b = at(stars.b.body, found);
    const std::vector<lod::NodePair> pairs = lod::traverse_levels<2>(a, b, level).back().pairs;
    const lod::NodePair pair = pairs.front();
    give(lesson, "found pairs", words(pairs_text(pairs.size()), static_cast<double>(pairs.size())));
    const Sphere<2> of_a = viz::carried_node(stars.a.body, pair.a);
    const Sphere<2> of_b = viz::carried_node(stars.b.body, pair.b);
    const Vec way = of_b.centre - of_a.centre;
    const double reach = of_a.radius + of_b.radius;
    const double speed = (stars.a.body.velocity - stars.b.body.velocity).norm();
    give(lesson, "across", number(way.x(), 3, "m"));
    give(lesson, "up", number(way.y(), 3, "m"));
    give(lesson, "reach", number(reach, 3, "m"));
    give(lesson, "speed", number(speed, 0, "m/s"));
    const double left = std::sqrt(reach * reach - way.y() * way.y());
    give(lesson, "left", number(left, 3, "m"));
    give(lesson, "touch by hand", number((way.x() - left) / speed, 3, "s"));
}

void give_stars(Lesson& lesson) {
    const Meeting stars = passing_stars();
    const auto touch = touch_of(stars);
    constexpr int looks = 2000;
    const auto nearest = lod::nearest_approach(stars.a.body, stars.b.body, ahead, looks);
    give_first_touch(lesson, stars, touch.time);
    give(lesson, "touch", number(touch.time, 3, "s"));
    give(lesson, "gap", number(100 * lod::separation(touch.a, touch.b).distance, 1, "cm"));
    give(lesson, "least gap", number(100 * nearest.gap.distance, 1, "cm"));
    give_panels(lesson, stars);
}

/// How far before the true touch each level's circles touch.
void give_levels(Lesson& lesson, const Meeting& meeting, double touch) {
    viz::Curve curve;
    curve.dots = true;
    for (int k = 0; k <= 4; ++k) {
        const double early =
            touch - lod::level_impact(meeting.a.body, meeting.b.body, k, ahead).time;
        give(lesson, "early " + std::to_string(k), number(1000 * early, 1, "ms"));
        curve.points.push_back({static_cast<double>(k), 1000 * early});
    }
    const viz::Axes axes{{"level", viz::Scale::linear, {0, 1, 2, 3, 4}, true},
                         {"too early [ms]", viz::Scale::linear, {}, false}};
    give(lesson, "frame", number(1000.0 / 60, 0, "ms"));
    give(lesson, "levels", viz::plot_panel("", axes, {curve}));
}

void give_exact(Lesson& lesson) {
    const Meeting meeting = L_and_U();
    // listing: exact
    const lod::TimeOfImpact<2> impact = lod::time_of_impact(meeting.a.body, meeting.b.body, ahead);
    // end of listing
    give_levels(lesson, meeting, impact.time);
    const Body<2>& a = meeting.a.body;
    const double gap = lod::separation(a, meeting.b.body).distance;
    double arm = 0;
    for (const lod2d::Point& corner : meeting.shape_a.polygon.rings[0])
        arm = std::max(arm, corner.norm());
    const double closing = (a.velocity - meeting.b.body.velocity).norm();
    const double fastest = closing + std::abs(a.spin[0]) * arm;
    give(lesson, "start gap", number(gap, 3, "m"));
    give(lesson, "closing", number(closing, 0, "m/s"));
    give(lesson, "L spin", number(a.spin[0], 0, "rad/s"));
    give(lesson, "arm", number(arm, 3, "m"));
    give(lesson, "fastest", number(fastest, 3, "m/s"));
    give(lesson, "safe", number(gap / fastest, 3, "s"));
    give(lesson, "impact", number(impact.time, 3, "s"));
    give(lesson, "rounds", count(impact.rounds));
    give(lesson, "last distance", tiny(impact.distance, "m"));
    viz::Panel start;
    start.view = box(-1.75, -0.95, 1.75, 1.25);
    viz::add_body(start, meeting.a, 0);
    viz::add_body(start, meeting.b, 1);
    add_gap(start, a, meeting.b.body, "distance");
    give(lesson, "start", std::move(start));
    viz::Panel touched;
    touched.view = box(-0.86, -0.72, 0.94, 0.92);
    viz::add_body(touched, meeting.at(0, impact.a), 0);
    viz::add_body(touched, meeting.at(1, impact.b), 1);
    for (const lod::Contact<2>& contact : impact.contacts) {
        add_dot(touched, viz::Role::contact, contact.point);
        add_arrow(touched, viz::Role::normal, contact.point, contact.point + 0.3 * contact.normal,
                  "*n*");
    }
    give(lesson, "touched", std::move(touched));
}

/// The stars on their way past each other, asked at level 1.
live::Scene play(const Meeting& stars) {
    live::Scene scene = to_play_with({stars.a, stars.b}, box(-2.25, -0.85, 2.25, 1.6));
    scene.settings.time_step = time_step;
    scene.settings.deepest_level = level;
    scene.settings.contact_model = lod::ContactModel::centre_line;  // by circles alone
    return scene;
}

}  // namespace
}  // namespace early

void make_too_early(Lesson& lesson) {
    early::give_stars(lesson);
    early::give_exact(lesson);
    early::give_crowd(lesson);
    give(lesson, early::play(early::passing_stars()));
}

}  // namespace lessons
