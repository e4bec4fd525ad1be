#include "lodlab/viz/draw/draw_projection.hpp"

#include <map>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/lod2d/source/paths/clean.hpp"
#include "lodlab/viz/draw/draw_contacts.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

using Vector2 = lod::Vector<2>;
using Vector3 = lod::Vector<3>;

/// Closed lines through the silhouette's edges, each with the surface that is seen on its left.
std::vector<lod2d::Ring> silhouette(const Surface& surface, const std::vector<Vector2>& points) {
    std::vector<char> front;
    for (const auto& [a, b, c] : surface.triangles) {
        const Vector2 ab = points[lod::at(b)] - points[lod::at(a)];
        const Vector2 ac = points[lod::at(c)] - points[lod::at(a)];
        front.push_back(ab.x() * ac.y() - ab.y() * ac.x() > 0);
    }
    std::multimap<int, int> ways;  // from vertex to vertex, as the triangle in front passes them
    for (const Surface::Edge& edge : surface.edges) {
        const bool left = front[lod::at(edge.left)] != 0;
        const bool right = edge.right >= 0 && front[lod::at(edge.right)] != 0;
        if (left == right) continue;
        const std::array<int, 3>& seen = surface.triangles[lod::at(left ? edge.left : edge.right)];
        const bool forward = (seen[0] == edge.from && seen[1] == edge.to) ||
                             (seen[1] == edge.from && seen[2] == edge.to) ||
                             (seen[2] == edge.from && seen[0] == edge.to);
        ways.emplace(forward ? edge.from : edge.to, forward ? edge.to : edge.from);
    }
    std::vector<lod2d::Ring> rings;
    while (!ways.empty()) {
        lod2d::Ring& ring = rings.emplace_back();
        const int start = ways.begin()->first;
        int at = start;
        do {
            const auto way = ways.find(at);
            if (way == ways.end()) break;  // an open surface: its border ends here
            ring.push_back(points[lod::at(at)]);
            at = way->second;
            ways.erase(way);
        } while (at != start);
    }
    return rings;
}

void add_bodies(Panel& panel, FlatView& view, const Actor<3>& actor, const ProjectionPlane& plane,
                int number) {
    const Role role = actor.body.is_static() ? Role::wall : Role::body;
    const Style style{.role = role, .body = number};
    if (!actor.visual.outline) return;
    Path path{style, projected_outline(*actor.visual.outline, actor.body, plane)};
    for (const Ring& ring : path.rings)
        for (const Point& p : ring) view.take_in({p.x, p.y}, 0);
    panel.marks.push_back(std::move(path));
}

/// The panel of a body's tree in the plane: circles in the order of their depth play no part.
void add_circles(Panel& panel, FlatView& view, const Panel& in_space,
                 const ProjectionPlane& plane) {
    for (const Ball& ball : in_space.space->balls) {
        const Vector2 centre = plane(vector3(ball.centre));
        view.take_in(centre, ball.radius);
        panel.marks.push_back(Disc{ball.style, point_of(centre), ball.radius});
    }
}

std::vector<lod::Contact<2>> projected(const std::vector<lod::Contact<3>>& contacts,
                                       const ProjectionPlane& plane) {
    std::vector<lod::Contact<2>> flat;
    for (const lod::Contact<3>& contact : contacts)
        flat.push_back({plane(contact.point), plane(contact.normal), contact.depth});
    return flat;
}

}  // namespace

ProjectionPlane projection_plane(const std::vector<lod::Contact<3>>& contacts) {
    if (contacts.empty())
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot project the collision: no nodes of the two bodies intersect at "
                         "this level; choose a coarser level or an earlier instant");
    Vector3 sum = Vector3::Zero();
    for (const lod::Contact<3>& contact : contacts) sum += contact.normal;
    ProjectionPlane plane;
    plane.along = sum.norm() > 1e-9 ? Vector3(sum.normalized()) : contacts.front().normal;
    const Vector3 upright = Vector3::UnitY() - plane.along.y() * plane.along;
    const Vector3 aside = Vector3::UnitZ() - plane.along.z() * plane.along;
    plane.up = upright.norm() > 1e-6 ? upright.normalized() : aside.normalized();
    return plane;
}

std::vector<Ring> projected_outline(const Surface& surface, const lod::Body<3>& body,
                                    const ProjectionPlane& plane) {
    const lod::Matrix<3> R = lod::Space<3>::rotation(body.orientation);
    std::vector<Vector2> points;
    points.reserve(surface.vertices.size());
    for (const Point3& v : surface.vertices)
        points.push_back(plane(body.position + R * vector3(v)));
    const lod2d::Polygon polygon = lod2d::clean("a silhouette", {silhouette(surface, points)});
    std::vector<Ring> rings;
    for (const lod2d::Ring& ring : polygon.rings) {
        rings.emplace_back();
        for (const Vector2& p : ring) rings.back().push_back(point_of(p));
    }
    return rings;
}

Figure projected_collision(const Actor<3>& a, const Actor<3>& b, const lod::FrameRecord<3>& record,
                           const lod::PairRecord& pair) {
    std::vector<lod::Contact<3>> contacts;
    for (std::int32_t c = 0; c < pair.contact_count; ++c)
        contacts.push_back(
            record.impacts[static_cast<std::size_t>(pair.first_contact + c)].contact);
    const ProjectionPlane plane = projection_plane(contacts);
    const std::string name_a = shown_name<3>({a.visual, b.visual}, 0);
    const std::string name_b = shown_name<3>({a.visual, b.visual}, 1);
    Panel in_space = blank_panel<3>(SpaceView());
    add_meeting_nodes<3>(in_space, {a.body, 0}, {b.body, 1}, record.nodes_of(pair.nodes));

    Panel panel;
    FlatView view;
    add_bodies(panel, view, a, plane, 0);
    add_bodies(panel, view, b, plane, 1);
    add_circles(panel, view, in_space, plane);
    panel.view = view.box();
    const std::vector<lod::Contact<2>> flat = projected(contacts, plane);
    add_normals<2>(panel, flat, 0.12 * longer_side(panel.view));
    add_contact_points<2>(panel, flat);
    for (const int number : {0, 1}) {
        const lod::Body<3>& body = number == 0 ? a.body : b.body;
        panel.marks.push_back(Label{{.role = Role::body, .body = number},
                                    point_of(plane(body.position)),
                                    literal_text(number == 0 ? name_a : name_b),
                                    0});
    }
    Figure figure;
    figure.title = "Seen square to the normal, meeting spheres are circles";
    figure.caption =
        "The collision in space, projected along an axis square to its mean normal: normals lie in "
        "the picture. Circles that overlap here may pass each other in depth.";
    const auto count = static_cast<long long>(contacts.size());
    figure.numbers = {{"level", std::to_string(pair.level)},
                      {"contacts", number_text(static_cast<double>(count), 9)}};
    figure.alt = name_a + " and " + name_b + " at level " + std::to_string(pair.level) +
                 ", projected along an axis square to the mean contact normal: " +
                 count_text(static_cast<long long>(in_space.space->balls.size()), "circle") +
                 " stand for the spheres that intersect, with " + count_text(count, "contact") +
                 ".";
    figure.panels.push_back(std::move(panel));
    return figure;
}

}  // namespace viz
