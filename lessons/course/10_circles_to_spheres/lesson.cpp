#include "lessons/course/10_circles_to_spheres/lesson.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/random.hpp"
#include "lodlab/core/tree/traversal.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"

namespace lessons {
namespace spheres {
namespace {

using lod::Sphere;
using Flat = lod::Vector<2>;

// listing: lifted
/// The same ball, in space: its third coordinate is zero.
Sphere<3> lifted(const Sphere<2>& flat) {
    return {Vec(flat.centre.x(), flat.centre.y(), 0), flat.radius};
}

lod::SphereTree<3> lifted(const lod::SphereTree<2>& flat) {
    std::vector<lod::TreeNode<3>> nodes;
    for (int node = 0; node < flat.size(); ++node) {
        const auto i = static_cast<std::size_t>(node);
        lod::TreeNode<3>& copy = nodes.emplace_back();
        copy.sphere = lifted(flat.sphere(node));
        for (int child = 0; child < flat.child_count[i]; ++child)
            copy.children.push_back(flat.first_child[i] + child);
    }
    return lod::lay_out<3>(nodes);
}
// end of listing

// listing: same verdict
/// How often plane and space disagree on the same two balls.
int count_disagreements(int trials) {
    lod::Random random(1);
    int disagreements = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Sphere<2> a{Flat(random.next(-1, 1), random.next(-1, 1)), random.next(0.1, 1)};
        const Sphere<2> b{Flat(random.next(-1, 1), random.next(-1, 1)), random.next(0.1, 1)};
        if (lod::overlap(a, b) != lod::overlap(lifted(a), lifted(b))) ++disagreements;
    }
    return disagreements;
}
// end of listing

/// Two balls with their centre line, seen as the panel's dimension sees them.
template <int Dim>
viz::Panel draw_pair(const Sphere<Dim>& a, const Sphere<Dim>& b, const std::string& title) {
    viz::View<Dim> view;
    viz::take_in<Dim>(view, a);
    viz::take_in<Dim>(view, b);
    viz::Panel panel = viz::blank_panel<Dim>(view);
    panel.title = title;
    const viz::Role role = lod::overlap(a, b) ? viz::Role::meeting_node : viz::Role::level_node;
    add_ball<Dim>(panel, a, style(role, 0));
    add_ball<Dim>(panel, b, style(role, 1));
    add_centres<Dim>(panel, a, b);
    return panel;
}

void give_ball(Lesson& lesson) {
    const Sphere<2> flat_a{Flat(0, 0), 1};
    const Sphere<2> flat_b{Flat(1.2, 0.5), 0.65};
    Sphere<3> b = lifted(flat_b);
    b.centre.z() = -1.2;
    give(lesson, "flat d", number((flat_b.centre - flat_a.centre).norm(), 3, "m"));
    give(lesson, "d", number(b.centre.norm(), 3, "m"));
    give(lesson, "reach", number(flat_a.radius + flat_b.radius, 3, "m"));
    viz::Figure figure;
    figure.panels = {draw_pair(flat_a, flat_b, "in the plane: they meet"),
                     draw_pair(lifted(flat_a), b, "in space: apart")};
    figure.columns = 2;
    give(lesson, "sphere", std::move(figure));
}

/// A ring and an L in the plane, and the same circles in space.
struct FlatPair {
    viz::Actor<2> a;
    viz::Actor<2> b;
    viz::Actor<3> lifted_a;
    viz::Actor<3> lifted_b;
    std::vector<lod::Front> fronts;
    std::vector<lod::Front> lifted_fronts;
};

viz::Actor<3> lifted(const viz::Actor<2>& flat) {
    viz::Actor<3> actor;
    actor.visual.name = flat.visual.name;
    actor.body.inverse_mass = flat.body.inverse_mass;
    actor.body.position = Vec(flat.body.position.x(), flat.body.position.y(), 0);
    const Vec turn(0, 0, flat.body.orientation);
    actor.body.orientation = lod::Space<3>::turned(lod::Space<3>::unturned(), turn);
    actor.body.tree = std::make_shared<const lod::SphereTree<3>>(lifted(*flat.body.tree));
    return actor;
}

FlatPair make_flat_pair() {
    constexpr int depth = 3;
    const lod2d::Shape ring = lod2d::generate("ring");
    const lod2d::Shape l = lod2d::generate("L");
    FlatPair pair;
    pair.a = actor("ring", ring, tree_of(ring, depth));
    pair.b = actor("L", l, tree_of(l, depth));
    pair.b.body.position = Flat(0.74, 0.12);
    pair.b.body.orientation = 0.7;
    pair.lifted_a = lifted(pair.a);
    pair.lifted_b = lifted(pair.b);
    // listing: both
    pair.fronts = lod::traverse_levels<2>(pair.a.body, pair.b.body);
    pair.lifted_fronts = lod::traverse_levels<3>(pair.lifted_a.body, pair.lifted_b.body);
    // end of listing
    return pair;
}

/// Levels at which the two lists of node pairs, or the counts of tests, differ.
int count_differing_fronts(const FlatPair& pair) {
    int differing = 0;
    for (std::size_t k = 0; k < std::max(pair.fronts.size(), pair.lifted_fronts.size()); ++k)
        if (k >= pair.fronts.size() || k >= pair.lifted_fronts.size() ||
            pair.fronts[k].pairs != pair.lifted_fronts[k].pairs ||
            pair.fronts[k].tests != pair.lifted_fronts[k].tests)
            ++differing;
    return differing;
}

/// The largest distance between the contact points that plane and space find [m].
double contact_difference(const FlatPair& pair) {
    double most = 0;
    for (const lod::NodePair& nodes : pair.fronts.back().pairs) {
        const auto flat = lod::model_contact<2>(viz::carried_node(pair.a.body, nodes.a),
                                                viz::carried_node(pair.b.body, nodes.b));
        const auto space = lod::model_contact<3>(viz::carried_node(pair.lifted_a.body, nodes.a),
                                                 viz::carried_node(pair.lifted_b.body, nodes.b));
        const Vec expected(flat->point.x(), flat->point.y(), 0);
        most = std::max(most, (space->point - expected).norm());
    }
    return most;
}

/// The circles or spheres that the tests of level 2 touched; bold are those that met.
template <int Dim>
viz::Panel draw_front(const lod::Body<Dim>& a, const lod::Body<Dim>& b,
                      const std::vector<lod::Front>& fronts, const std::string& title) {
    constexpr int level = 2;
    viz::View<Dim> view;
    viz::take_in<Dim>(view, viz::carried_node(a, 0));
    viz::take_in<Dim>(view, viz::carried_node(b, 0));
    viz::Panel panel = viz::blank_panel<Dim>(view);
    panel.title = title;
    const viz::TestedNodes tested = viz::tested_nodes<Dim>(a, b, fronts, level);
    viz::add_nodes<Dim>(panel, a, tested.a, viz::Role::node, 0);
    viz::add_nodes<Dim>(panel, b, tested.b, viz::Role::node, 1);
    viz::add_meeting_nodes<Dim>(panel, {a, 0}, {b, 1}, fronts[level].pairs);
    return panel;
}

void give_same_code(Lesson& lesson) {
    constexpr int trials = 10000;
    const FlatPair pair = make_flat_pair();
    give(lesson, "trials", count(trials));
    give(lesson, "disagreements", count(count_disagreements(trials)));
    give(lesson, "levels", count(pair.fronts.size()));
    give(lesson, "flat tests", count(pair.fronts.back().tests));
    give(lesson, "lifted tests", count(pair.lifted_fronts.back().tests));
    give(lesson, "flat pairs", count(pair.fronts.back().pairs.size()));
    give(lesson, "differing fronts", count(count_differing_fronts(pair)));
    give(lesson, "contact difference", tiny(contact_difference(pair), "m"));
    viz::Figure figure;
    figure.panels = {draw_front<2>(pair.a.body, pair.b.body, pair.fronts, "circles of level 2"),
                     draw_front<3>(pair.lifted_a.body, pair.lifted_b.body, pair.lifted_fronts,
                                   "spheres of level 2")};
    figure.columns = 2;
    figure.numbers = {{"tests", lesson.numbers["flat tests"].text + " and " +
                                    lesson.numbers["lifted tests"].text}};
    give(lesson, "same code", std::move(figure));
}

/// Radii 2 and 1, centres 2 apart, as in the lesson on contact.
void give_meeting_circle(Lesson& lesson) {
    constexpr int corners = 96;
    // listing: meeting circle
    const Sphere<3> a{Vec(0, 0, 0), 2};
    const Sphere<3> b{Vec(2, 0, 0), 1};
    const auto plane = lod::model_contact<3>(a, b, lod::PointModel::plane_of_intersection);
    const double to_plane = (plane->point - a.centre).norm();
    const double radius = std::sqrt(a.radius * a.radius - to_plane * to_plane);
    // end of listing
    const auto ratio = lod::model_contact<3>(a, b, lod::PointModel::radius_ratio);
    std::vector<Vec> circle;
    double off = 0;  // how far a point of the circle is from either sphere
    for (int i = 0; i <= corners; ++i) {
        const lod::SineCosine turn = lod::sine_cosine(2 * 3.14159265358979 * i / corners);
        circle.push_back(plane->point + radius * Vec(0, turn.cosine, turn.sine));
        off = std::max({off, std::abs((circle.back() - a.centre).norm() - a.radius),
                        std::abs((circle.back() - b.centre).norm() - b.radius)});
    }
    viz::View<3> view(viz::Viewpoint{.azimuth = 0.45, .elevation = 0.3});
    viz::take_in<3>(view, a);
    viz::take_in<3>(view, b);
    viz::Panel panel = viz::blank_panel<3>(view);
    add_ball<3>(panel, a, style(viz::Role::meeting_node, 0));
    add_ball<3>(panel, b, style(viz::Role::meeting_node, 1));
    viz::add_line<3>(panel, style(viz::Role::contact), circle, 1);
    add_centres<3>(panel, a, b);
    add_line<3>(panel, viz::Role::construction, plane->point, circle[corners / 8]);
    add_dot<3>(panel, viz::Role::contact, plane->point);
    add_label<3>(panel, viz::Role::note, plane->point, "plane");
    add_dot<3>(panel, viz::Role::contact, ratio->point);
    add_label<3>(panel, viz::Role::note, ratio->point, "ratio");
    give(lesson, "to plane", number(to_plane, 4, "m"));
    give(lesson, "to ratio", number((ratio->point - a.centre).norm(), 4, "m"));
    give(lesson, "circle radius", number(radius, 4, "m"));
    give(lesson, "off circle", tiny(off, "m"));
    give(lesson, "meeting circle", std::move(panel), {{"circle's radius", "circle radius"}});
}

}  // namespace
}  // namespace spheres

void make_circles_to_spheres(Lesson& lesson) {
    const spheres::Ring ring = spheres::make_ring();
    spheres::give_ball(lesson);
    spheres::give_same_code(lesson);
    spheres::give_fit(lesson, ring);
    spheres::give_meeting_circle(lesson);
    spheres::give_links(lesson, ring);
}

}  // namespace lessons
