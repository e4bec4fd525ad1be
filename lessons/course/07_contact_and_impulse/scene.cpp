#include "lessons/course/07_contact_and_impulse/lesson.hpp"

#include <algorithm>

#include "lessons/engine/meeting.hpp"
#include "lodlab/core/tree/traversal.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"
#include "lodlab/viz/draw/motion/draw_motion.hpp"

namespace lessons::impact {

using lod::Body;
using lod::Sphere;
using Vec = lod::Vector<2>;

Scene make_scene() {
    constexpr int depth = 4;
    constexpr int level = 2;
    const lod2d::Shape gear = scaled(lod2d::generate("gear:9"), 2);
    const lod2d::Shape star = scaled(lod2d::generate("star:5"), 1.3);
    Scene scene;
    scene.level = level;
    scene.gear = actor("gear", gear, tree_of(gear, depth));
    scene.star = actor("star", star, tree_of(star, depth));
    scene.gear.body.velocity = Vec(0.6, 0.1);
    scene.gear.body.spin[0] = 0.5;
    scene.star.body.velocity = Vec(-0.7, -0.2);
    scene.star.body.spin[0] = -1.2;
    scene.star.body.orientation = 0.5;
    double distance = 3;  // then nearer, until a single pair of nodes of the level overlaps well
    std::vector<lod::Front> fronts;
    do {
        distance -= 0.01;
        scene.star.body.position = distance * Vec(0.96, 0.28);
        fronts = lod::traverse_levels<2>(scene.gear.body, scene.star.body, level);
    } while (fronts.back().pairs.empty());
    scene.star.body.position = (distance - 0.06) * Vec(0.96, 0.28);
    fronts = lod::traverse_levels<2>(scene.gear.body, scene.star.body, level);
    for (const lod::NodePair& pair : fronts.back().pairs) {
        const Sphere<2> a = viz::carried_node(scene.gear.body, pair.a);
        const Sphere<2> b = viz::carried_node(scene.star.body, pair.b);
        const auto contact = lod::model_contact<2>(a, b);
        if (!contact || contact->depth < scene.contact.depth) continue;
        scene.contact = *contact;
        scene.node_a = a;
        scene.node_b = b;
    }
    scene.gap =
        lod2d::distance(outline_of(gear, scene.gear.body), outline_of(star, scene.star.body));
    scene.view = box(-1.05, -1.1, 2.25, 1.1);
    return scene;
}

constexpr double time_step = 1.0 / 120;  // [s]
constexpr double before = 0.9;           // the contact [s]

live::Scene play(const Scene& start) {
    live::Scene scene = to_play_with({earlier(start.gear, before), earlier(start.star, before)},
                                     viz::grown(start.view, 0.25));
    scene.settings = down_to(start.level, lod::ContactModel::centre_line, time_step);
    return scene;
}

void animate(Lesson& lesson, const Scene& start) {
    constexpr double seconds = 2.2;
    const viz::Run<2> run = run_of({earlier(start.gear, before), earlier(start.star, before)},
                                   down_to(start.level, lod::ContactModel::hull, time_step),
                                   seconds, video_words(lesson, "run"));
    viz::ImpactMotion motion;
    motion.seconds = 3;
    motion.title = video_words(lesson, "title");
    lesson.animation = viz::impact_motion<2>({run}, motion);
}

}  // namespace lessons::impact
