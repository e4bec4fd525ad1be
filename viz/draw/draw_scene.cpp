#include "lodlab/viz/draw/draw_scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

constexpr std::size_t many_contacts = 12;   ///< smaller dots beyond
constexpr std::size_t most_contacts = 128;  ///< smallest dots beyond
constexpr std::size_t most_normals = 16;

template <int Dim>
std::vector<int> leaves_of(const lod::SphereTree<Dim>& tree) {
    std::vector<int> leaves;
    for (int node = 0; node < tree.size(); ++node)
        if (tree.is_leaf(node)) leaves.push_back(node);
    return leaves;
}

template <int Dim>
void add_outline(Panel& panel, const Actor<Dim>& actor, const Style& style) {
    if (actor.body.tree && actor.body.tree->is_half_space())
        return DrawTraits<Dim>::add_half_space(panel, style, actor.visual.outline, actor.body);
    if (DrawTraits<Dim>::shown(actor.visual.outline))
        return DrawTraits<Dim>::add_outline(panel, style, actor.visual.outline, actor.body);
    for (const int leaf : leaves_of(*actor.body.tree))
        DrawTraits<Dim>::add_ball(panel, style, carried_node(actor.body, leaf));
}

}  // namespace

template <int Dim>
Panel blank_panel(const View<Dim>& view) {
    return DrawTraits<Dim>::panel(view);
}

template <int Dim>
void add_body(Panel& panel, const Actor<Dim>& actor, int number, double opacity) {
    const Role role = actor.body.is_static() ? Role::wall : Role::body;
    add_body(panel, actor, {.role = role, .body = number, .opacity = opacity});
}

template <int Dim>
void add_body(Panel& panel, const Actor<Dim>& actor, const Style& style) {
    add_outline(panel, actor, style);
    DrawTraits<Dim>::add_shadow(panel, actor.body);
}

template <int Dim>
void add_ghost(Panel& panel, const Actor<Dim>& actor, int number, double opacity) {
    add_outline(panel, actor, {.role = Role::ghost, .body = number, .opacity = opacity});
}

template <int Dim>
void add_nodes(Panel& panel, const lod::Body<Dim>& body, std::span<const int> nodes,
               const Style& style) {
    if (body.tree->is_half_space()) return;  // its only node is all of it
    for (const int node : nodes) {
        Style own = style;
        own.level = body.tree->level_of(node);
        DrawTraits<Dim>::add_ball(panel, own, carried_node(body, node));
    }
}

template <int Dim>
void add_meeting_nodes(Panel& panel, const NumberedBody<Dim>& a, const NumberedBody<Dim>& b,
                       std::span<const lod::NodePair> pairs, double opacity) {
    std::set<int> meeting_a;
    std::set<int> meeting_b;
    std::set<int> true_a;
    std::set<int> true_b;
    for (const lod::NodePair& pair : pairs) {
        const bool leaves = a.body.tree->is_leaf(pair.a) && b.body.tree->is_leaf(pair.b);
        (leaves ? true_a : meeting_a).insert(pair.a);
        (leaves ? true_b : meeting_b).insert(pair.b);
    }
    const auto add = [&](const NumberedBody<Dim>& of, const std::set<int>& nodes, Role role) {
        add_nodes<Dim>(panel, of.body, std::vector<int>(nodes.begin(), nodes.end()),
                       Style{.role = role, .body = of.number, .opacity = opacity});
    };
    add(a, meeting_a, Role::meeting_node);
    add(b, meeting_b, Role::meeting_node);
    add(a, true_a, Role::true_collision);
    add(b, true_b, Role::true_collision);
}

template <int Dim>
void add_contact_points(Panel& panel, std::span<const lod::Contact<Dim>> contacts, double opacity) {
    const double size = contacts.size() > most_contacts   ? 0.35
                        : contacts.size() > many_contacts ? 0.6
                                                          : 1.0;
    for (const lod::Contact<Dim>& contact : contacts)
        panel.marks.push_back(Dot{{.role = Role::contact, .opacity = opacity},
                                  DrawTraits<Dim>::on(panel, contact.point),
                                  size,
                                  DrawTraits<Dim>::depth(panel, contact.point)});
}

template <int Dim>
void add_arrow(Panel& panel, const Style& style, const lod::Vector<Dim>& tail,
               const lod::Vector<Dim>& tip, const std::string& label) {
    panel.marks.push_back(
        Arrow{style, DrawTraits<Dim>::on(panel, tail), DrawTraits<Dim>::on(panel, tip), label,
              DrawTraits<Dim>::depth(panel, tail), DrawTraits<Dim>::depth(panel, tip)});
}

template <int Dim>
void add_line(Panel& panel, const Style& style, std::span<const lod::Vector<Dim>> points,
              double start_opacity) {
    if (points.size() < 2) return;
    Polyline line{style, {}, start_opacity, {}};
    for (const lod::Vector<Dim>& p : points) {
        line.points.push_back(DrawTraits<Dim>::on(panel, p));
        line.depths.push_back(DrawTraits<Dim>::depth(panel, p));
    }
    panel.marks.push_back(std::move(line));
}

template <int Dim>
void add_normals(Panel& panel, std::span<const lod::Contact<Dim>> contacts, double length,
                 double opacity) {
    if (contacts.size() > most_normals) return;
    for (const lod::Contact<Dim>& contact : contacts)
        add_arrow<Dim>(panel, {.role = Role::normal, .opacity = opacity}, contact.point,
                       contact.point + length * contact.normal, {});
}

template <int Dim>
void add_velocity(Panel& panel, const NumberedBody<Dim>& numbered, double metres_per_speed,
                  double opacity, SpinWords spin) {
    const lod::Body<Dim>& body = numbered.body;
    const double speed = body.velocity.norm();
    if (speed == 0) return;
    std::string words = quantity_text(speed, "m/s", 2);
    const double turning = DrawTraits<Dim>::amount(body.spin);
    if (spin == SpinWords::shown && turning != 0)
        words.append("\n").append(quantity_text(turning, "rad/s", 2));
    add_arrow<Dim>(panel, {.role = Role::velocity, .body = numbered.number, .opacity = opacity},
                   body.position, body.position + metres_per_speed * body.velocity, words);
}

template <int Dim>
std::string shown_name(const std::vector<Visual<Dim>>& visuals, std::size_t number) {
    if (number >= visuals.size()) return {};
    const std::string& name = visuals[number].name;
    const auto same = std::count_if(visuals.begin(), visuals.end(),
                                    [&](const Visual<Dim>& visual) { return visual.name == name; });
    if (same == 1 || number >= 26) return name;
    return name + (name.empty() ? "" : " ") + static_cast<char>('A' + number);
}

template <int Dim>
void add_names(Panel& panel, const Actor<Dim>& a, const Actor<Dim>& b, Beside beside) {
    const std::vector<Visual<Dim>> visuals{a.visual, b.visual};
    if (beside == Beside::roots) {
        for (const int number : {0, 1}) {
            const lod::Sphere<Dim> root = carried_node((number == 0 ? a : b).body, 0);
            panel.marks.push_back(
                Label{{.role = Role::body, .body = number},
                      DrawTraits<Dim>::on(panel, root.centre),
                      literal_text(shown_name(visuals, static_cast<std::size_t>(number))),
                      root.radius * DrawTraits<Dim>::magnification(panel, root.centre)});
        }
        return;
    }
    add_name(panel, a, shown_name(visuals, 0), 0, DrawTraits<Dim>::on(panel, b.body.position));
    add_name(panel, b, shown_name(visuals, 1), 1, DrawTraits<Dim>::on(panel, a.body.position));
}

template <int Dim>
void add_name(Panel& panel, const Actor<Dim>& actor, const std::string& name, int number,
              Point away_from) {
    // The outline's point that lies furthest out on the side away from the other body.
    const auto on_panel = [&](const lod::Vector<Dim>& v) {
        const Point p = DrawTraits<Dim>::on(panel, v);
        return lod::Vector<2>(p.x, p.y);
    };
    const lod::Body<Dim>& body = actor.body;
    const lod::Vector<2> centre = on_panel(body.position);
    lod::Vector<2> outward = centre - lod::Vector<2>(away_from.x, away_from.y);
    outward = outward.norm() > 0 ? lod::Vector<2>(outward.normalized()) : lod::Vector<2>(0, 1);
    const lod::Matrix<Dim> R = lod::Space<Dim>::rotation(body.orientation);
    Point furthest = point_of(centre);
    double most = 0;
    for (const lod::Vector<Dim>& local : DrawTraits<Dim>::points_of(actor.visual.outline)) {
        const lod::Vector<2> p = on_panel(body.position + R * local);
        const double along = outward.dot(p - centre);
        if (along <= most) continue;
        most = along;
        furthest = point_of(p);
    }
    panel.marks.push_back(
        Label{{.role = Role::body, .body = number}, furthest, literal_text(name), 0});
}

template <int Dim>
Actor<Dim> actor_of(const Run<Dim>& run, std::size_t instant, int number) {
    const auto i = static_cast<std::size_t>(number);
    return {visual_at(run, i), run.instants[instant].bodies[i]};
}

template <int Dim>
double gap(const Actor<Dim>& a, const Actor<Dim>& b) {
    return DrawTraits<Dim>::gap(a.visual.outline, a.body, b.visual.outline, b.body);
}

template <int Dim>
std::vector<lod::Contact<Dim>> contacts_of(const lod::FrameRecord<Dim>& record) {
    std::vector<lod::Contact<Dim>> contacts;
    for (const lod::Impact<Dim>& impact : record.impacts) contacts.push_back(impact.contact);
    return contacts;
}

template <int Dim>
std::span<const lod::NodePair> nodes_of(const lod::FrameRecord<Dim>& record,
                                        const lod::PairRecord& pair) {
    return record.nodes_of(pair.nodes);
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

template Panel blank_panel<2>(const View<2>&);
template Panel blank_panel<3>(const View<3>&);
template void add_body<2>(Panel&, const Actor<2>&, int, double);
template void add_body<3>(Panel&, const Actor<3>&, int, double);
template void add_body<2>(Panel&, const Actor<2>&, const Style&);
template void add_body<3>(Panel&, const Actor<3>&, const Style&);
template void add_ghost<2>(Panel&, const Actor<2>&, int, double);
template void add_ghost<3>(Panel&, const Actor<3>&, int, double);
template void add_nodes<2>(Panel&, const lod::Body<2>&, std::span<const int>, const Style&);
template void add_nodes<3>(Panel&, const lod::Body<3>&, std::span<const int>, const Style&);
template void add_meeting_nodes<2>(Panel&, const NumberedBody<2>&, const NumberedBody<2>&,
                                   std::span<const lod::NodePair>, double);
template void add_meeting_nodes<3>(Panel&, const NumberedBody<3>&, const NumberedBody<3>&,
                                   std::span<const lod::NodePair>, double);
template void add_contact_points<2>(Panel&, std::span<const lod::Contact<2>>, double);
template void add_contact_points<3>(Panel&, std::span<const lod::Contact<3>>, double);
template void add_normals<2>(Panel&, std::span<const lod::Contact<2>>, double, double);
template void add_normals<3>(Panel&, std::span<const lod::Contact<3>>, double, double);
template void add_arrow<2>(Panel&, const Style&, const lod::Vector<2>&, const lod::Vector<2>&,
                           const std::string&);
template void add_arrow<3>(Panel&, const Style&, const lod::Vector<3>&, const lod::Vector<3>&,
                           const std::string&);
template void add_line<2>(Panel&, const Style&, std::span<const lod::Vector<2>>, double);
template void add_line<3>(Panel&, const Style&, std::span<const lod::Vector<3>>, double);
template void add_velocity<2>(Panel&, const NumberedBody<2>&, double, double, SpinWords);
template void add_velocity<3>(Panel&, const NumberedBody<3>&, double, double, SpinWords);
template std::string shown_name<2>(const std::vector<Visual<2>>&, std::size_t);
template std::string shown_name<3>(const std::vector<Visual<3>>&, std::size_t);
template void add_name<2>(Panel&, const Actor<2>&, const std::string&, int, Point);
template void add_name<3>(Panel&, const Actor<3>&, const std::string&, int, Point);
template void add_names<2>(Panel&, const Actor<2>&, const Actor<2>&, Beside);
template void add_names<3>(Panel&, const Actor<3>&, const Actor<3>&, Beside);
template Actor<2> actor_of<2>(const Run<2>&, std::size_t, int);
template Actor<3> actor_of<3>(const Run<3>&, std::size_t, int);
template double gap<2>(const Actor<2>&, const Actor<2>&);
template double gap<3>(const Actor<3>&, const Actor<3>&);
template std::vector<lod::Contact<2>> contacts_of<2>(const lod::FrameRecord<2>&);
template std::vector<lod::Contact<3>> contacts_of<3>(const lod::FrameRecord<3>&);
template std::span<const lod::NodePair> nodes_of<2>(const lod::FrameRecord<2>&,
                                                    const lod::PairRecord&);
template std::span<const lod::NodePair> nodes_of<3>(const lod::FrameRecord<3>&,
                                                    const lod::PairRecord&);

}  // namespace viz
