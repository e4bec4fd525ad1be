#include "lessons/04_contact_and_impulse/lesson.hpp"

#include <algorithm>

#include "core/traversal.hpp"
#include "lod2d/generators.hpp"
#include "lod2d/overlap.hpp"

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

viz::Figure draw_instant(const Scene& scene, const std::vector<Body<2>>& bodies,
                         const lod::FrameRecord<2>& record) {
    viz::Actor gear = scene.gear;
    viz::Actor star = scene.star;
    gear.body = bodies[0];
    star.body = bodies[1];
    viz::Panel panel;
    panel.view = box(-2.2, -1.5, 3.6, 1.7);
    add_body(panel, gear, 0);
    add_body(panel, star, 1);
    double pushed = 0;
    for (std::size_t i = 0; i < record.impacts.size(); ++i) {
        if (record.impulses[i] <= 0) continue;
        const auto& [point, normal, depth] = record.impacts[i].contact;
        add_disc(panel, viz::carried_node(gear.body, record.node_pairs[i].a),
                 style(viz::Role::meeting_node, 0));
        add_disc(panel, viz::carried_node(star.body, record.node_pairs[i].b),
                 style(viz::Role::meeting_node, 1));
        add_dot(panel, viz::Role::contact, point);
        add_arrow(panel, viz::Role::impulse, point,
                  point + impulse_length * record.impulses[i] * normal,
                  shown(record.impulses[i], 2) + " N s");
        add_arrow(panel, viz::Role::impulse, point,
                  point - impulse_length * record.impulses[i] * normal);
        pushed += record.impulses[i];
    }
    viz::Figure figure =
        figure_of(std::move(panel), pushed > 0 ? "The impulse" : "A gear and a star",
                  "The gear and the star in flight.");
    figure.numbers = {{"energy", shown(lod::kinetic_energy<2>(bodies), 3) + " J"}};
    return figure;
}

void animate(Lesson& lesson, const Scene& start) {
    constexpr double back = 0.9;  // [s] before the contact
    constexpr double time_step = 1.0 / 120;
    constexpr int frames = 264;
    lod::FrameSettings settings;
    settings.time_step = time_step;
    settings.deepest_level = start.level;
    lod::FrameStorage<2> storage;
    std::vector<Body<2>> bodies{start.gear.body, start.star.body};
    for (Body<2>& body : bodies) {
        body.position -= back * body.velocity;
        body.orientation -= back * body.spin[0];
    }
    lesson.animation.title = "The gear and the star meet at level " + std::to_string(start.level) +
                             " of their trees and part";
    for (int i = 0; i < frames; ++i) {
        std::vector<Body<2>> now = bodies;
        lod::Budget budget = lod::Budget::unlimited();
        const lod::FrameRecord<2> record = lod::advance<2>(bodies, settings, budget, storage);
        const bool impact =
            record.energy_before > 0 && std::any_of(record.impulses.begin(), record.impulses.end(),
                                                    [](double j) { return j > 0; });
        if (i % 3 != 0 && !impact) continue;
        const auto draw = [=] { return draw_instant(start, now, record); };
        lesson.animation.shots.push_back({draw, impact ? 36 : 1});
    }
}

}  // namespace lessons::impact
