#include "lessons/course/09_graceful_degradation/lesson.hpp"

#include "lodlab/lod2d/builder/tree_report.hpp"
#include "lodlab/viz/draw/motion/draw_motion.hpp"

namespace lessons {
namespace degradation {
namespace {

using Collision = measure::Collision<2>;
using Vec = lod::Vector<2>;

constexpr double time_step = 1.0 / 480;   // [s]
constexpr double seconds = 1.1;           // of a run
constexpr double velocity_length = 0.45;  // metres of arrow for a metre a second
constexpr double impulse_length = 0.55;   // metres of arrow for a newton second

/// An L and a U that meet once, as every level answers it.
struct Scene {
    Meeting meeting = L_and_U();
    std::vector<Collision> levels;
    Collision exact;
    viz::Box near = box(-0.86, -0.72, 0.94, 0.92);  ///< where they meet
};

lod::FrameSettings at_level(int level) {
    return down_to(level, lod::ContactModel::centre_line, time_step);
}

Scene make_scene() {
    Scene scene;
    for (int level = 0; level <= depth; ++level)
        scene.levels.push_back(collision_of(scene.meeting, at_level(level), seconds));
    scene.exact = exact_collision_of(scene.meeting, seconds);
    return scene;
}

Number centimetres(double length) {
    return number(100 * length, 1, "cm");
}

void give_start(Lesson& lesson, const Scene& scene) {
    viz::Panel panel;
    panel.view = box(-1.75, -0.95, 1.75, 1.25);
    for (int index : {0, 1}) {
        const viz::Actor<2>& one = index == 0 ? scene.meeting.a : scene.meeting.b;
        viz::add_body(panel, one, index);
        const Vec x = one.body.position;
        add_arrow(panel, viz::Role::velocity, x, x + velocity_length * one.body.velocity,
                  index == 0 ? "*v*_a" : "*v*_b", index);
        add_label(panel, viz::Role::body, x + Vec(0, -0.62), index == 0 ? "A" : "B", index);
    }
    give(lesson, "start", std::move(panel));
    give(lesson, "closing speed",
         number((scene.meeting.a.body.velocity - scene.meeting.b.body.velocity).norm(), 0, "m/s"));
    give(lesson, "frames", number(1 / time_step, 0));
}

void give_instants(Lesson& lesson, const Scene& scene) {
    std::vector<viz::Panel> panels;
    for (int level = 0; level <= depth; ++level) {
        const Collision& collision = scene.levels[lod::at(level)];
        const std::string name = std::to_string(level);
        give(lesson, "time " + name, number(collision.time, 3, "s"));
        if (level == depth) continue;
        give(lesson, "gap " + name, centimetres(collision.gap));
        panels.push_back(found_at(scene.meeting, collision, level, scene.near));
        if (collision.gap > 0) add_gap(panels.back(), collision.before[0], collision.before[1], "");
        panels.back().title = "Level " + name + ": " + lesson.numbers["gap " + name].text;
    }
    give(lesson, "time exact", number(scene.exact.time, 3, "s"));
    const auto& [a, b] = scene.levels[0].before;
    const viz::Box roots = box_round({viz::carried_node(a, 0), viz::carried_node(b, 0)});
    viz::Panel coarsest = found_at(scene.meeting, scene.levels[0], 0, viz::grown(roots, 0.02));
    add_gap(coarsest, a, b, "gap");
    give(lesson, "coarsest", std::move(coarsest));
    give(lesson, "gaps", figure_of(std::move(panels), 2));
}

/// How far the circles of level 1 reach out of each shape.
void give_bound(Lesson& lesson, const Scene& scene) {
    const auto protrusion = [](const lod2d::Shape& shape, const viz::Actor<2>& actor) {
        return lod2d::report_tree(shape, *actor.body.tree).levels[1].worst_protrusion;
    };
    const double of_a = protrusion(scene.meeting.shape_a, scene.meeting.a);
    const double of_b = protrusion(scene.meeting.shape_b, scene.meeting.b);
    give(lesson, "e_a", centimetres(of_a));
    give(lesson, "e_b", centimetres(of_b));
    give(lesson, "bound", centimetres(of_a + of_b));
}

/// The impulse on B, and by how much a level's differs from it.
void give_error(Lesson& lesson, const Scene& scene) {
    constexpr std::size_t level = 2;
    // listing: error
    const Vec J = measure::impulse_of(scene.exact);
    const Vec J_level = measure::impulse_of(scene.levels[level]);
    const double error = (J_level - J).norm() / J.norm();
    // end of listing
    give(lesson, "m_b", number(1 / scene.meeting.b.body.inverse_mass, 3, "kg"));
    const auto in_words = [](const Vec& v, const char* unit) {
        return words(with_unit(vector_text<2>(v), unit), v.x());
    };
    give(lesson, "v_b", in_words(scene.meeting.b.body.velocity, "m/s"));
    give(lesson, "v_b level", in_words(scene.levels[level].after[1].velocity, "m/s"));
    give(lesson, "J level", in_words(J_level, "N s"));
    give(lesson, "J exact", in_words(J, "N s"));
    give(lesson, "J size", number(J.norm(), 3, "N s"));
    give(lesson, "J level size", number(J_level.norm(), 3, "N s"));
    give(lesson, "J difference", number((J_level - J).norm(), 3, "N s"));
    give(lesson, "error by hand", number(error, 3));
    give(lesson, "no push", number(Vec(-J).norm() / J.norm(), 0));
    const Collision& seen = scene.levels[level];
    viz::Panel panel = found_at(scene.meeting, seen, level, scene.near);
    const Vec from = (lod::separation(seen.before[0], seen.before[1]).on_a +
                      lod::separation(seen.before[0], seen.before[1]).on_b) /
                     2;
    add_arrow(panel, viz::Role::impulse, from, from + impulse_length * J_level, "*J*_2");
    add_arrow(panel, viz::Role::reference, from, from + impulse_length * J, "*J*");
    give(lesson, "arrows", std::move(panel));
}

void give_ways(Lesson& lesson, const Scene& scene) {
    const viz::Run<2> exact =
        run_of(scene.meeting, to_the_true_shapes(time_step), seconds, "exact");
    std::vector<viz::Run<2>> runs;
    viz::Curve curve{.name = "", .points = {}, .low = {}, .high = {}, .dots = true};
    for (int level = 0; level <= depth; ++level) {
        const double error =
            measure::impact_error(scene.exact, scene.levels[lod::at(level)]).impulse;
        give(lesson, "error " + std::to_string(level), number(error, 3));
        curve.points.push_back({static_cast<double>(level), error});
        if (level < depth)
            runs.push_back(
                run_of(scene.meeting, at_level(level), seconds, "Level " + std::to_string(level)));
    }
    viz::Figure figure = over(runs, exact, seconds, box(-1.82, -0.98, 1.72, 1.14));
    give(lesson, "ways", std::move(figure));
    const viz::Axes axes{{"level", viz::Scale::linear, {0, 1, 2, 3, 4}, true},
                         {"error of the impulse", viz::Scale::linear, {}, false}};
    give(lesson, "one curve", viz::plot_panel("", axes, {curve}));
    viz::ImpactMotion motion;
    motion.seconds = 4;
    motion.title = video_words(lesson, "title");
    lesson.animation = viz::impact_motion<2>({runs[1], runs[2], runs[3]}, motion);
}

/// The collision of the lesson, from its start; as level 1 answers it.
live::Scene play(const Scene& scene) {
    live::Scene play =
        to_play_with({scene.meeting.a, scene.meeting.b}, box(-1.9, -1.15, 1.9, 1.35));
    play.settings = at_level(1);
    return play;
}

}  // namespace
}  // namespace degradation

void make_graceful_degradation(Lesson& lesson) {
    const degradation::Scene scene = degradation::make_scene();
    degradation::give_start(lesson, scene);
    degradation::give_instants(lesson, scene);
    degradation::give_bound(lesson, scene);
    degradation::give_error(lesson, scene);
    degradation::give_ways(lesson, scene);
    degradation::give_curves(lesson);
    give(lesson, degradation::play(scene));
}

}  // namespace lessons
