#include "lodlab/viz/draw/draw_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/draw/draw_tree.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

using Vector2 = lod::Vector<2>;

constexpr std::size_t legible_contacts = 128;

/// The levels of a montage, without those whose contacts would run into each other.
std::vector<int> legible_levels(const std::vector<lod::Front>& fronts) {
    std::vector<int> levels = montage_levels(static_cast<int>(fronts.size()));
    while (levels.size() > 2 &&
           fronts[static_cast<std::size_t>(levels.back())].pairs.size() > legible_contacts)
        levels.pop_back();
    return levels;
}

/// Shows both outlines and the nodes of all contacts shown.
template <int Dim>
View<Dim> view_of_contacts(const Actor<Dim>& a, const Actor<Dim>& b,
                           const std::vector<lod::Front>& fronts, const std::vector<int>& levels,
                           const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    View<Dim> view(viewpoint, way_between(a.body, b.body));
    take_in<Dim>(view, a);
    take_in<Dim>(view, b);
    for (const int level : levels) {
        for (const lod::NodePair& pair : fronts[static_cast<std::size_t>(level)].pairs) {
            take_in<Dim>(view, carried_node(a.body, pair.a));
            take_in<Dim>(view, carried_node(b.body, pair.b));
        }
    }
    return view;
}

template <int Dim>
Panel level_panel(const Actor<Dim>& a, const Actor<Dim>& b, const lod::Front& front,
                  lod::PointModel model, const View<Dim>& view) {
    const std::vector<lod::Contact<Dim>> contacts =
        lod::contacts_of_front<Dim>(a.body, b.body, front, {lod::ContactModel::centre_line, model});
    Panel panel = blank_panel<Dim>(view);
    panel.title = "Level " + std::to_string(front.level) + ": " +
                  count_text(static_cast<long long>(contacts.size()), "contact");
    add_body(panel, a, 0, DrawTraits<Dim>::see_through);
    add_body(panel, b, 1, DrawTraits<Dim>::see_through);
    add_meeting_nodes<Dim>(panel, {a.body, 0}, {b.body, 1}, front.pairs, 0.6);
    add_normals<Dim>(panel, contacts, 0.14 * longer_side(panel.view));
    add_contact_points<Dim>(panel, contacts);
    return panel;
}

Vector2 crosswise(const Vector2& v) {
    return {-v.y(), v.x()};
}

/// The two balls, the line of their centres and the names of what lies on it.
void add_balls(Marks& marks, const lod::Sphere<2>& a, const lod::Sphere<2>& b, const Vector2& n) {
    const auto ball = [&](const lod::Sphere<2>& of, int number) {
        marks.push_back(
            Disc{{.role = Role::level_node, .body = number}, point_of(of.centre), of.radius});
    };
    ball(a, 0);
    ball(b, 1);
    marks.push_back(
        Polyline{{.role = Role::construction}, {point_of(a.centre), point_of(b.centre)}, 1, {}});
    const auto radius = [&](const lod::Sphere<2>& of, const Vector2& way, int number,
                            const char* name) {
        const Vector2 rim = of.centre + of.radius * way;
        marks.push_back(Polyline{
            {.role = Role::velocity, .body = number}, {point_of(of.centre), point_of(rim)}, 1, {}});
        marks.push_back(Label{{.role = Role::velocity, .body = number},
                              point_of(of.centre + 0.55 * of.radius * way),
                              name,
                              0});
    };
    const Vector2 up = crosswise(n);
    radius(a, (up - 0.45 * n).normalized(), 0, "*R_A*");
    radius(b, (up + 0.45 * n).normalized(), 1, "*R_B*");
    const auto centre = [&](const lod::Sphere<2>& of, int number, const char* name) {
        marks.push_back(Dot{{.role = Role::velocity, .body = number}, point_of(of.centre), 0.8});
        marks.push_back(
            Label{{.role = Role::velocity, .body = number}, point_of(of.centre), name, 0});
    };
    centre(a, 0, "*o_A*");
    centre(b, 1, "*o_B*");
}

/// The chord through both rims and the point where it cuts the centre line.
void add_plane(Marks& marks, const lod::Sphere<2>& a, const lod::Sphere<2>& b, const Vector2& plane,
               const Vector2& n) {
    const double along = (plane - a.centre).dot(n);
    const double half = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
    const double shown = half + 0.12 * std::min(a.radius, b.radius);
    const Vector2 across = crosswise(n);
    marks.push_back(Polyline{{.role = Role::reference},
                             {point_of(plane + shown * across), point_of(plane - shown * across)},
                             1,
                             "plane of intersection"});
    marks.push_back(Dot{{.role = Role::reference}, point_of(plane), 0.8});
}

}  // namespace

template <int Dim>
Figure contacts_by_level(const Actor<Dim>& a, const Actor<Dim>& b,
                         const std::vector<lod::Front>& fronts, const ContactsChoice& choice,
                         const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    const lod::PointModel model = choice.model;
    const std::vector<int> levels = choice.levels.empty() ? legible_levels(fronts) : choice.levels;
    const View<Dim> view = view_of_contacts(a, b, fronts, levels, viewpoint);
    const std::string name_a = shown_name<Dim>({a.visual, b.visual}, 0);
    const std::string name_b = shown_name<Dim>({a.visual, b.visual}, 1);
    Figure figure;
    figure.title = "One touch of two faces becomes ever more sphere contacts";
    figure.caption =
        "Each intersecting pair of nodes gives one contact: its point and its normal, "
        "from " +
        literal_text(name_a) + " towards " + literal_text(name_b) + ".";
    figure.alt = "The contact of " + name_a + " and " + name_b + ", level by level.";
    std::size_t most = 0;
    for (const int level : levels) {
        const lod::Front& front = fronts[static_cast<std::size_t>(level)];
        figure.panels.push_back(level_panel<Dim>(a, b, front, model, view));
        if (figure.panels.size() == 1)
            add_names(figure.panels[0], a, b, level == 0 ? Beside::roots : Beside::outlines);
        figure.alt += " " + figure.panels.back().title + ".";
        most = std::max(most, lod::contacts_of_front<Dim>(a.body, b.body, front,
                                                          {lod::ContactModel::centre_line, model})
                                  .size());
    }
    figure.numbers = {
        {"node tests",
         number_text(static_cast<double>(fronts[static_cast<std::size_t>(levels.back())].tests),
                     9)},
        {"most contacts", number_text(static_cast<double>(most), 9)}};
    return figure;
}

Figure contact_construction(const lod::Sphere<2>& a, const lod::Sphere<2>& b) {
    const double d = (b.centre - a.centre).norm();
    const auto ratio = lod::model_contact<2>(a, b, lod::PointModel::radius_ratio);
    const auto plane = lod::model_contact<2>(a, b, lod::PointModel::plane_of_intersection);
    if (!ratio || !plane || d == 0)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot draw a contact's construction: the two nodes are apart or share "
                         "their centre; move them");
    const Vector2 n = ratio->normal;
    Figure figure;
    figure.title = "Where do two nodes touch?";
    figure.numbers = {{"distance *d*", length_text(d)},
                      {"*c* by the radii", length_text((ratio->point - a.centre).dot(n))},
                      {"*c* on the plane", length_text((plane->point - a.centre).dot(n))}};
    figure.caption =
        "The point *c* divides the centre line by the radii (equation 5); the plane of "
        "intersection cuts it elsewhere. Both are measured from *o_A*.";
    figure.alt = "Two overlapping circles of radius " + length_text(a.radius) + " and " +
                 length_text(b.radius) + ", centres " + length_text(d) +
                 " apart. The contact point divides the line between the centres by the radii, " +
                 figure.numbers[1].value +
                 " from the first centre; the plane of intersection cuts "
                 "it at " +
                 figure.numbers[2].value +
                 ". The normal points from the first centre to the second.";
    FlatView both;
    take_in<2>(both, a);
    take_in<2>(both, b);
    Panel panel;
    panel.view = both.box();
    add_balls(panel.marks, a, b, n);
    panel.marks.push_back(Arrow{{.role = Role::normal},
                                point_of(ratio->point),
                                point_of(ratio->point + 0.3 * std::min(a.radius, b.radius) * n),
                                "*n*"});
    add_plane(panel.marks, a, b, plane->point, n);
    panel.marks.push_back(Dot{{.role = Role::contact}, point_of(ratio->point), 1.2});
    panel.marks.push_back(Label{{.role = Role::contact}, point_of(ratio->point), "*c*", 0});
    figure.panels.push_back(std::move(panel));
    return figure;
}

template Figure contacts_by_level<2>(const Actor<2>&, const Actor<2>&,
                                     const std::vector<lod::Front>&, const ContactsChoice&,
                                     const DrawTraits<2>::Viewpoint&);
template Figure contacts_by_level<3>(const Actor<3>&, const Actor<3>&,
                                     const std::vector<lod::Front>&, const ContactsChoice&,
                                     const DrawTraits<3>::Viewpoint&);

}  // namespace viz
