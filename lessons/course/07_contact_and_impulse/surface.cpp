#include <cmath>
#include <set>
#include <utility>

#include "lessons/course/07_contact_and_impulse/lesson.hpp"
#include "lessons/engine/meeting.hpp"

namespace lessons::impact {
namespace {

using Vec = lod::Vector<2>;

/// The contacts of two boxes that meet face to face, as a model has them: a picture, and how far
/// their normals are off in the mean [degrees].
struct Faces {
    viz::Panel panel;
    double off = 0;
    std::size_t contacts = 0;
};

Faces faces_by(const Meeting& boxes, lod::ContactModel model, int level) {
    constexpr double time_step = 1.0 / 120;
    const double degree = std::acos(-1.0) / 180;
    lod::FrameStorage<2> storage;
    lod::Budget budget = lod::Budget::unlimited();
    const std::vector<lod::Body<2>> bodies = boxes.bodies();
    const auto& record = lod::detect<2>(bodies, down_to(level, model, time_step), budget, storage);
    Faces faces;
    faces.panel.view = box(0.19, -0.25, 0.79, 0.65);
    add_body(faces.panel, boxes.a, 0);
    add_body(faces.panel, boxes.b, 1);
    std::set<std::pair<std::size_t, int>> nodes;
    for (const lod::NodePair& pair : record.node_pairs) {
        nodes.insert({0, pair.a});
        nodes.insert({1, pair.b});
    }
    for (const auto& [body, node] : nodes)
        add_ball(faces.panel, viz::carried_node(bodies[body], node), style(viz::Role::node));
    constexpr std::size_t most_arrows = 24;
    faces.contacts = record.impacts.size();
    const std::size_t each = (faces.contacts + most_arrows - 1) / most_arrows;
    for (std::size_t i = 0; i < faces.contacts; ++i) {
        const auto& [point, normal, depth] = record.impacts[i].contact;
        faces.off += std::atan2(std::abs(normal.y()), normal.x()) / degree;
        if (i % each != 0) continue;
        add_dot(faces.panel, viz::Role::contact, point);
        add_arrow(faces.panel, viz::Role::normal, point, point + 0.13 * normal);
    }
    faces.off /= static_cast<double>(faces.contacts);
    return faces;
}

}  // namespace

void give_surface(Lesson& lesson) {
    constexpr int drawn = 3;
    Meeting boxes = meeting_of("box", "box", 5);
    boxes.b.body.position = Vec(0.999, 0.4);
    std::vector<viz::Panel> panels;
    for (const auto& [model, name] : {std::pair{lod::ContactModel::centre_line, "centre line"},
                                      {lod::ContactModel::node_normal, "node normal"},
                                      {lod::ContactModel::hull, "hull"}})
        for (const int level : {drawn, 4, 5}) {
            Faces faces = faces_by(boxes, model, level);
            const std::string which = std::string(name) + " " + std::to_string(level);
            give(lesson, which, number(faces.off, 1, "°"));
            if (model != lod::ContactModel::node_normal)
                give(lesson, which + " contacts", count(faces.contacts));
            faces.panel.title = std::string(name) + ", level " + std::to_string(level);
            if (level == (model == lod::ContactModel::centre_line ? drawn : 5))
                panels.push_back(std::move(faces.panel));
        }
    give(lesson, "lines", figure_of(std::vector<viz::Panel>{panels[0]}, 1));
    give(lesson, "surfaces", figure_of(std::vector<viz::Panel>{panels[1], panels[2]}, 2));
}

}  // namespace lessons::impact
