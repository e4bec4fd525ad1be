#include "viz/draw_scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "viz/number_text.hpp"

namespace viz {
namespace {

constexpr std::size_t many_contacts = 12;
constexpr std::size_t most_normals = 16;

std::vector<int> leaves_of(const lod::SphereTree<2>& tree) {
    std::vector<int> leaves;
    for (int node = 0; node < tree.size(); ++node)
        if (tree.is_leaf(node)) leaves.push_back(node);
    return leaves;
}

void add_outline(Marks& marks, const Actor& actor, const Style& style) {
    if (!actor.look.rings.empty()) {
        marks.push_back(Path{style, carried(actor.body, actor.look.rings)});
        return;
    }
    for (const int leaf : leaves_of(*actor.body.tree)) {
        const lod::Sphere<2> ball = carried_node(actor.body, leaf);
        marks.push_back(Disc{style, point_of(ball.centre), ball.radius});
    }
}

}  // namespace

void add_body(Marks& marks, const Actor& actor, int number, double opacity) {
    const Role role = actor.body.is_static() ? Role::wall : Role::body;
    add_outline(marks, actor, {.role = role, .body = number, .opacity = opacity});
}

void add_ghost(Marks& marks, const Actor& actor, int number, double opacity) {
    add_outline(marks, actor, {.role = Role::ghost, .body = number, .opacity = opacity});
}

void add_nodes(Marks& marks, const lod::Body<2>& body, std::span<const int> nodes, Role role,
               int number, double opacity) {
    for (const int node : nodes) {
        const lod::Sphere<2> ball = carried_node(body, node);
        marks.push_back(Disc{
            {.role = role, .body = number, .level = body.tree->level_of(node), .opacity = opacity},
            point_of(ball.centre),
            ball.radius});
    }
}

void add_meeting_nodes(Marks& marks, const lod::Body<2>& a, const lod::Body<2>& b, int number_a,
                       int number_b, std::span<const lod::NodePair> pairs, double opacity) {
    std::set<int> meeting_a;
    std::set<int> meeting_b;
    std::set<int> true_a;
    std::set<int> true_b;
    for (const lod::NodePair& pair : pairs) {
        const bool leaves = a.tree->is_leaf(pair.a) && b.tree->is_leaf(pair.b);
        (leaves ? true_a : meeting_a).insert(pair.a);
        (leaves ? true_b : meeting_b).insert(pair.b);
    }
    const auto add = [&](const lod::Body<2>& body, const std::set<int>& nodes, Role role,
                         int number) {
        add_nodes(marks, body, std::vector<int>(nodes.begin(), nodes.end()), role, number, opacity);
    };
    add(a, meeting_a, Role::meeting_node, number_a);
    add(b, meeting_b, Role::meeting_node, number_b);
    add(a, true_a, Role::true_collision, number_a);
    add(b, true_b, Role::true_collision, number_b);
}

void add_contact_points(Marks& marks, std::span<const lod::Contact<2>> contacts, double opacity) {
    const double size = contacts.size() > many_contacts ? 0.6 : 1.0;
    for (const lod::Contact<2>& contact : contacts)
        marks.push_back(
            Dot{{.role = Role::contact, .opacity = opacity}, point_of(contact.point), size});
}

void add_normals(Marks& marks, std::span<const lod::Contact<2>> contacts, double length,
                 double opacity) {
    if (contacts.size() > most_normals) return;
    for (const lod::Contact<2>& contact : contacts)
        marks.push_back(Arrow{{.role = Role::normal, .opacity = opacity},
                              point_of(contact.point),
                              point_of(contact.point + length * contact.normal),
                              {}});
}

void add_velocity(Marks& marks, const lod::Body<2>& body, int number, double metres_per_speed,
                  double opacity, SpinWords spin) {
    const double speed = body.velocity.norm();
    if (speed == 0) return;
    std::string words = quantity_text(speed, "m/s", 2);
    if (spin == SpinWords::shown && body.spin[0] != 0)
        words.append("\n").append(quantity_text(body.spin[0], "rad/s", 2));
    marks.push_back(Arrow{{.role = Role::velocity, .body = number, .opacity = opacity},
                          point_of(body.position),
                          point_of(body.position + metres_per_speed * body.velocity),
                          words});
}

std::string shown_name(const std::vector<Look>& looks, std::size_t number) {
    if (number >= looks.size()) return {};
    const std::string& name = looks[number].name;
    const auto same = std::count_if(looks.begin(), looks.end(),
                                    [&](const Look& look) { return look.name == name; });
    if (same == 1 || number >= 26) return name;
    return name + (name.empty() ? "" : " ") + static_cast<char>('A' + number);
}

void add_names(Marks& marks, const Actor& a, const Actor& b, Beside beside) {
    if (beside == Beside::roots) {
        for (const int number : {0, 1}) {
            const lod::Sphere<2> root = carried_node((number == 0 ? a : b).body, 0);
            marks.push_back(
                Label{{.role = Role::body, .body = number},
                      point_of(root.centre),
                      literal_text(shown_name({a.look, b.look}, static_cast<std::size_t>(number))),
                      root.radius});
        }
        return;
    }
    add_name(marks, a, shown_name({a.look, b.look}, 0), 0, point_of(b.body.position));
    add_name(marks, b, shown_name({a.look, b.look}, 1), 1, point_of(a.body.position));
}

void add_name(Marks& marks, const Actor& actor, const std::string& name, int number,
              Point away_from) {
    // The outline's point that lies furthest out on the side away from the other body.
    const lod::Vector<2> centre = actor.body.position;
    lod::Vector<2> outward = centre - lod::Vector<2>(away_from.x, away_from.y);
    outward = outward.norm() > 0 ? lod::Vector<2>(outward.normalized()) : lod::Vector<2>(0, 1);
    Point furthest = point_of(centre);
    double most = 0;
    for (const Ring& ring : carried(actor.body, actor.look.rings)) {
        for (const Point& p : ring) {
            const double along = outward.dot(lod::Vector<2>(p.x, p.y) - centre);
            if (along <= most) continue;
            most = along;
            furthest = p;
        }
    }
    marks.push_back(Label{{.role = Role::body, .body = number}, furthest, literal_text(name), 0});
}

Actor actor_of(const Run& run, std::size_t instant, int number) {
    const auto i = static_cast<std::size_t>(number);
    return {i < run.looks.size() ? run.looks[i] : Look{}, run.instants[instant].bodies[i]};
}

std::vector<lod::Contact<2>> contacts_of(const lod::FrameRecord<2>& record) {
    std::vector<lod::Contact<2>> contacts;
    for (const lod::Impact<2>& impact : record.impacts) contacts.push_back(impact.contact);
    return contacts;
}

const char* verdict_words(lod::Verdict verdict) {
    switch (verdict) {
        case lod::Verdict::apart:
            return "not colliding";
        case lod::Verdict::possible:
            return "possible collision";
        case lod::Verdict::true_collision:
            return "true collision";
    }
    return "";
}

double longer_side(const Box& box) {
    return std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

}  // namespace viz
