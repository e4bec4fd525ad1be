#include "lodlab/viz/draw/draw_traits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lodlab/core/exact/exact_shape.hpp"
#include "lodlab/lod2d/shape/distance.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"
#include "lodlab/viz/figure/camera.hpp"

namespace viz {
namespace {

constexpr double far_away = std::numeric_limits<double>::infinity();
constexpr double three_quarters = 0.4;  ///< how far the view turns from straight across [rad]
constexpr double usual_azimuth = 0.55;  ///< where nothing moves [rad]
/// Distance of a perspective eye from the middle, in diagonals of what is to be seen: a picture
/// lifelike at an arm's length.
constexpr double eye_distance = 2.2;
constexpr double ground_below = 0.06;  ///< shares of what is to be seen
constexpr double ground_reach = 0.95;
constexpr double level_floor = 0.999;  ///< upward part of the normal of what is a floor
constexpr int grid_lines = 10;
constexpr std::size_t most_casters = 12;

double round_length(double about) {
    const double power = std::pow(10.0, std::floor(std::log10(about)));
    for (const double step : {5.0, 2.0, 1.0})
        if (step * power <= about) return step * power;
    return power;
}

lod2d::BoundaryIndex world_boundary(const std::vector<Ring>& outline, const lod::Body<2>& body) {
    const lod::Matrix<2> R = lod::Space<2>::rotation(body.orientation);
    lod2d::Polygon polygon;
    for (const Ring& ring : outline) {
        lod2d::Ring points;
        for (const Point& p : ring)
            points.emplace_back(body.position + R * lod::Vector<2>(p.x, p.y));
        polygon.rings.push_back(std::move(points));
    }
    return lod2d::BoundaryIndex(polygon);
}

/// The azimuth from which a way lies across the picture, a little turned, its start on the left.
double azimuth_across(const lod::Vector<3>& along) {
    if (std::hypot(along.x(), along.z()) <= 1e-9 * along.norm()) return usual_azimuth;
    return std::atan2(-along.z(), along.x()) + three_quarters;
}

}  // namespace

Box FlatView::empty_box() {
    return {{far_away, far_away}, {-far_away, -far_away}};
}

void FlatView::take_in(const lod::Vector<2>& p, double reach) {
    box_.low = {std::min(box_.low.x, p.x() - reach), std::min(box_.low.y, p.y() - reach)};
    box_.high = {std::max(box_.high.x, p.x() + reach), std::max(box_.high.y, p.y() + reach)};
}

void FlatView::unite(const FlatView& other) {
    box_.low = {std::min(box_.low.x, other.box_.low.x), std::min(box_.low.y, other.box_.low.y)};
    box_.high = {std::max(box_.high.x, other.box_.high.x),
                 std::max(box_.high.y, other.box_.high.y)};
}

SpaceView::SpaceView(const Viewpoint& viewpoint, const lod::Vector<3>& along)
    : direction_(orbit(lod::Vector<3>::Zero(), 1,
                       viewpoint.azimuth ? *viewpoint.azimuth : azimuth_across(along),
                       viewpoint.elevation, viewpoint.perspective)),
      axes_(axes_of(direction_)),
      low_(lod::Vector<3>::Constant(far_away)),
      high_(lod::Vector<3>::Constant(-far_away)),
      lowest_(far_away) {}

void SpaceView::take_in(const lod::Vector<3>& p, double reach) {
    const lod::Vector<3> seen(p.dot(axes_.right), p.dot(axes_.up), p.dot(axes_.forward));
    low_ = low_.cwiseMin(seen - lod::Vector<3>::Constant(reach));
    high_ = high_.cwiseMax(seen + lod::Vector<3>::Constant(reach));
    lowest_ = std::min(lowest_, p.y() - reach);
}

void SpaceView::unite(const SpaceView& other) {
    low_ = low_.cwiseMin(other.low_);
    high_ = high_.cwiseMax(other.high_);
    lowest_ = std::min(lowest_, other.lowest_);
}

lod::Vector<3> SpaceView::place(const lod::Vector<3>& seen) const {
    return seen.x() * axes_.right + seen.y() * axes_.up + seen.z() * axes_.forward;
}

double SpaceView::size() const {
    return (high_ - low_).norm();
}

Camera SpaceView::camera() const {
    const lod::Vector<3> middle = place((low_ + high_) / 2);
    Camera camera = direction_;
    camera.target = point3(middle);
    camera.eye = point3(middle - eye_distance * size() * axes_.forward);
    return camera;
}

Box SpaceView::box() const {
    const Camera seen_by = camera();
    Box box{{far_away, far_away}, {-far_away, -far_away}};
    for (int corner = 0; corner < 8; ++corner) {
        const lod::Vector<3> seen((corner & 1 ? high_ : low_).x(), (corner & 2 ? high_ : low_).y(),
                                  (corner & 4 ? high_ : low_).z());
        const Point p = project(seen_by, place(seen));
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
}

Ground SpaceView::ground() const {
    const lod::Vector<3> middle = place((low_ + high_) / 2);
    Ground ground;
    ground.height = lowest_ - ground_below * size();
    ground.reach = ground_reach * size();
    ground.spacing = round_length(2 * ground.reach / grid_lines);
    ground.centre = {middle.x(), ground.height, middle.z()};
    return ground;
}

Panel DrawTraits<2>::panel(const View& view) {
    Panel panel;
    panel.view = view.box();
    return panel;
}

void DrawTraits<2>::add_outline(Panel& panel, const Style& style, const Outline& outline,
                                const lod::Body<2>& body) {
    const lod::Matrix<2> R = lod::Space<2>::rotation(body.orientation);
    Path path{style, outline};
    for (Ring& ring : path.rings)
        for (Point& p : ring) {
            const lod::Vector<2> world = body.position + R * lod::Vector<2>(p.x, p.y);
            p = {world.x(), world.y()};
        }
    panel.marks.push_back(std::move(path));
}

void DrawTraits<2>::add_half_space(Panel& panel, const Style& style, const Outline& outline,
                                   const lod::Body<2>& body) {
    add_outline(panel, style, outline, body);
}

void DrawTraits<2>::add_ball(Panel& panel, const Style& style, const lod::Sphere<2>& ball) {
    panel.marks.push_back(Disc{style, {ball.centre.x(), ball.centre.y()}, ball.radius});
}

std::vector<lod::Vector<2>> DrawTraits<2>::points_of(const Outline& outline) {
    std::vector<lod::Vector<2>> points;
    for (const Ring& ring : outline)
        for (const Point& p : ring) points.emplace_back(p.x, p.y);
    return points;
}

double DrawTraits<2>::gap(const Outline& a, const lod::Body<2>& body_a, const Outline& b,
                          const lod::Body<2>& body_b) {
    if (a.empty() || b.empty()) return -1;
    return lod2d::distance(world_boundary(a, body_a), world_boundary(b, body_b));
}

double DrawTraits<2>::between(double from, double to, double share) {
    return from + share * lod::wrapped_angle(to - from);
}

Panel DrawTraits<3>::panel(const View& view) {
    Panel panel;
    panel.view = view.box();
    panel.space = SpaceScene{view.camera(), {}, {}, view.ground()};
    return panel;
}

Point DrawTraits<3>::on(const Panel& panel, const lod::Vector<3>& v) {
    return project(panel.space->camera, v);
}

double DrawTraits<3>::depth(const Panel& panel, const lod::Vector<3>& v) {
    return depth_of(panel.space->camera, v);
}

double DrawTraits<3>::magnification(const Panel& panel, const lod::Vector<3>& v) {
    return viz::magnification(panel.space->camera, v);
}

void DrawTraits<3>::add_outline(Panel& panel, const Style& style, const Outline& outline,
                                const lod::Body<3>& body) {
    const lod::Matrix<3> R = lod::Space<3>::rotation(body.orientation);
    panel.space->facets.push_back({style,
                                   outline,
                                   point3(body.position),
                                   {point3(R.col(0)), point3(R.col(1)), point3(R.col(2))}});
}

void DrawTraits<3>::add_half_space(Panel& panel, const Style&, const Outline&,
                                   const lod::Body<3>& body) {
    const lod::Vector<3> normal =
        lod::Space<3>::rotation(body.orientation) * *body.tree->half_space;
    if (!panel.space->ground || normal.y() < level_floor) return;
    panel.space->ground->height = body.position.y();
    panel.space->ground->centre.y = body.position.y();
}

void DrawTraits<3>::add_ball(Panel& panel, const Style& style, const lod::Sphere<3>& ball) {
    panel.space->balls.push_back({style, point3(ball.centre), ball.radius});
}

void DrawTraits<3>::add_shadow(Panel& panel, const lod::Body<3>& body) {
    if (!panel.space->ground || !body.tree || body.tree->is_half_space()) return;
    int level = 0;
    while (level + 1 < body.tree->levels() &&
           body.tree->level_nodes(level + 1).size() <= most_casters)
        ++level;
    const lod::Matrix<3> R = lod::Space<3>::rotation(body.orientation);
    for (const int node : body.tree->level_nodes(level)) {
        const lod::Sphere<3> ball = body.tree->sphere(node);
        panel.space->ground->casters.push_back(
            {{}, point3(body.position + R * ball.centre), ball.radius});
    }
}

std::vector<lod::Vector<3>> DrawTraits<3>::points_of(const Outline& outline) {
    std::vector<lod::Vector<3>> points;
    if (!outline) return points;
    for (const Point3& p : outline->outermost) points.push_back(vector3(p));
    return points;
}

double DrawTraits<3>::gap(const Outline&, const lod::Body<3>& a, const Outline&,
                          const lod::Body<3>& b) {
    if (!a.exact || !b.exact) return -1;
    return lod::exactly_overlap<3>(a, b) ? 0 : lod::separation<3>(a, b).distance;
}

lod::Quaternion DrawTraits<3>::between(const lod::Quaternion& from, const lod::Quaternion& to,
                                       double share) {
    const double side = from.dot(to) < 0 ? -1 : 1;  // the shorter way round
    return lod::Quaternion::of_coeffs((1 - share) * from.coeffs() + share * side * to.coeffs())
        .normalized();
}

}  // namespace viz
