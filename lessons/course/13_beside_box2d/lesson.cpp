#include "lessons/course/13_beside_box2d/lesson.hpp"

#include <array>

#include "lodlab/viz/draw/motion/draw_comparison.hpp"

namespace lessons {
namespace box2d {

using lod::Body;
using Collision = measure::Collision<2>;
using Vec = lod::Vector<2>;

constexpr double short_step = 1.0 / 960;    // [s]
constexpr double picture_step = 1.0 / 120;  // [s]
constexpr double usual_scale = 16;          // units of Box2D a metre
constexpr double skin = 0.01;               // of a polygon, in units of Box2D
constexpr double velocity_length = 0.4;     // metres of arrow for a metre a second

Meeting offset_boxes() {
    Meeting meeting = meeting_of("box:1,1", "box:1,1", 2);
    meeting.a.body.position = Vec(-1, 0);
    meeting.a.body.velocity = Vec(2, 0);
    meeting.b.body.position = Vec(1, 0.4);
    return meeting;
}

lod2d::Box2dImpact impact_by_box2d(const Meeting& meeting, double time_step,
                                   double units_per_metre) {
    // listing: box2d
    lod2d::Box2dSettings settings;
    settings.time_step = time_step;
    settings.units_per_metre = units_per_metre;
    const std::array<const lod2d::Shape*, 2> shapes{&meeting.shape_a, &meeting.shape_b};
    return lod2d::run_to_impact(meeting.bodies(), shapes, settings);
    // end of listing
}

namespace {

/// A run by Box2D for pictures: where the bodies are, frame by frame.
viz::Run<2> seen_by_box2d(const Meeting& meeting, double seconds) {
    lod2d::Box2dSettings settings;
    settings.time_step = short_step;
    const std::array<const lod2d::Shape*, 2> shapes{&meeting.shape_a, &meeting.shape_b};
    const auto frames = static_cast<std::int64_t>(seconds / picture_step + 0.5);
    const lod2d::Box2dRun run =
        lod2d::run_box2d(meeting.bodies(), shapes, frames, picture_step, settings);
    viz::Run<2> result;
    result.name = "Box2D";
    result.visuals = {meeting.a.visual, meeting.b.visual};
    result.time_step = picture_step;
    for (const auto& bodies : run.frames) viz::add_instant(result, bodies, {});
    return result;
}

viz::Run<2> seen_by_lodlab(const Meeting& meeting, double seconds) {
    return run_of(meeting, to_the_true_shapes(picture_step), seconds, "lodlab");
}

void give_boxes(Lesson& lesson) {
    constexpr double seconds = 1.2;
    const Meeting boxes = offset_boxes();
    const Collision exact = exact_collision_of(boxes, seconds);
    const lod2d::Box2dImpact impact = impact_by_box2d(boxes, short_step, usual_scale);
    const double j = measure::impulse_of(exact).norm();
    const double j_box2d =
        (impact.after[1].velocity - impact.before[1].velocity).norm() / boxes.b.body.inverse_mass;
    const double lever = (boxes.b.body.position - boxes.a.body.position).y() / 2;
    const double turning = lever * lever * boxes.a.body.inverse_inertia(0, 0);
    give(lesson, "offset", number(2 * lever, 1, "m"));
    give(lesson, "lever", number(lever, 1, "m"));
    give(lesson, "I", number(boxes.a.body.inertia(0, 0), 4, "kg m²"));
    give(lesson, "turning", number(turning, 2));
    give(lesson, "K",
         number(boxes.a.body.inverse_mass + boxes.b.body.inverse_mass + 2 * turning, 2, "1/kg"));
    give(lesson, "j", number(j, 4, "N s"));
    give(lesson, "j box2d", number(j_box2d, 4, "N s"));
    give(lesson, "j difference", tiny(std::abs(j_box2d - j), "N s"));
    give(lesson, "spin", number(std::abs(exact.after[1].spin[0]), 4, "rad/s"));

    viz::Panel before;
    before.view = box(-1.7, -0.8, 1.7, 1.2);
    viz::add_body(before, boxes.a, 0);
    viz::add_body(before, boxes.b, 1);
    const Vec x = boxes.a.body.position;
    add_arrow(before, viz::Role::velocity, x, x + velocity_length * boxes.a.body.velocity, "*v*_a");
    add_label(before, viz::Role::body, x - Vec(0, 0.6), "A");
    add_label(before, viz::Role::body, boxes.b.body.position - Vec(0, 0.6), "B", 1);
    give(lesson, "boxes", std::move(before));
    const viz::Run<2> ours = seen_by_lodlab(boxes, seconds);
    const viz::Run<2> theirs = seen_by_box2d(boxes, seconds);
    give(lesson, "same", over({ours}, theirs, seconds, box(-0.7, -0.9, 2.85, 1.4)));
}

/// Both bodies where Box2D pushes them, so near that the skins can be seen.
viz::Panel skins(const Meeting& boxes, const lod2d::Box2dImpact& impact) {
    const double face = impact.before[0].position.x() + 0.5;
    const double other = impact.before[1].position.x() - 0.5;
    viz::Panel panel;
    panel.view = box(face - 0.008, 0.17, other + 0.008, 0.198);
    viz::add_body(panel, boxes.at(0, impact.before[0]), 0);
    viz::add_body(panel, boxes.at(1, impact.before[1]), 1);
    for (const auto& [index, from, to] :
         {std::tuple{0, face, face + skin}, {1, other - skin, other}}) {
        panel.marks.push_back(viz::Path{style(viz::Role::band, index),
                                        {{{from, 0}, {to, 0}, {to, 0.4}, {from, 0.4}}}});
        add_label(panel, viz::Role::body, Vec((from + to) / 2, 0.19 - 0.004 * index),
                  index == 0 ? "skin of A" : "skin of B", index);
        add_label(panel, viz::Role::body, Vec(index == 0 ? face - 0.004 : other + 0.004, 0.188),
                  index == 0 ? "A" : "B", index);
    }
    add_line(panel, viz::Role::reference, Vec(face, 0.175), Vec(other, 0.175));
    add_label(panel, viz::Role::reference, Vec(face + skin, 0.175), "gap");
    return panel;
}

void give_skin(Lesson& lesson) {
    const Meeting boxes = offset_boxes();
    const auto gap_at = [&](double scale) {
        const lod2d::Box2dImpact impact = impact_by_box2d(boxes, short_step, scale);
        return lod::separation(impact.before[0], impact.before[1]).distance;
    };
    give(lesson, "skin", number(100 * skin, 1, "cm"));
    give(lesson, "both skins", number(200 * skin, 1, "cm"));
    give(lesson, "gap", number(100 * gap_at(1), 1, "cm"));
    give(lesson, "scale", count(static_cast<int>(usual_scale)));
    give(lesson, "way", number(100 * boxes.a.body.velocity.x() / 60, 1, "cm"));
    give(lesson, "short way", number(100 * boxes.a.body.velocity.x() * short_step, 1, "cm"));
    give(lesson, "small gap", number(100 * gap_at(usual_scale), 2, "cm"));
    give(lesson, "skins", skins(boxes, impact_by_box2d(boxes, short_step, 1)));
}

/// An L and a U, as in the strips of one collision at every level.
void give_shapes(Lesson& lesson) {
    constexpr double seconds = 0.9;
    const Meeting meeting = L_and_U();
    const Collision exact = exact_collision_of(meeting, seconds);
    const auto error = [&](const Collision& seen, int decimals) {
        return number(100 * measure::impact_error(exact, seen).impulse, decimals, "%");
    };
    const lod2d::Box2dImpact impact = impact_by_box2d(meeting, short_step, usual_scale);
    Collision by_box2d = exact;
    by_box2d.after = {impact.after[0], impact.after[1]};
    by_box2d.before = {impact.before[0], impact.before[1]};
    give(lesson, "error box2d", error(by_box2d, 3));
    const auto leaves = [](double step) { return down_to(4, lod::ContactModel::hull, step); };
    const auto level_1 = [](double step) {
        return down_to(1, lod::ContactModel::centre_line, step);
    };
    give(lesson, "error leaves", error(collision_of(meeting, leaves(short_step), seconds), 3));
    give(lesson, "error level 1", error(collision_of(meeting, level_1(short_step), seconds), 1));
    const viz::Run<2> ours = run_of(meeting, leaves(picture_step), seconds, "lodlab, leaves");
    const viz::Run<2> coarse = run_of(meeting, level_1(picture_step), seconds, "lodlab, level 1");
    const viz::Run<2> theirs = seen_by_box2d(meeting, seconds);
    viz::Figure figure = over({coarse, ours}, theirs, seconds, box(-1.45, -0.75, 1.4, 1.0));
    figure.columns = 1;
    give(lesson, "shapes", std::move(figure));
    viz::ComparisonMotion motion;
    motion.seconds = 5;
    motion.words.title = video_words(lesson, "title");
    motion.words.caption = "";
    lesson.animation = viz::comparison_motion<2>({coarse, ours}, theirs, motion);
}

}  // namespace
}  // namespace box2d

void make_beside_box2d(Lesson& lesson) {
    box2d::give_boxes(lesson);
    box2d::give_skin(lesson);
    box2d::give_steps(lesson);
    box2d::give_row(lesson);
    box2d::give_shapes(lesson);
    box2d::give_paths(lesson);
}

}  // namespace lessons
