#include "lodlab/viz/figure/camera.hpp"

#include <algorithm>
#include <numbers>

#include "lodlab/core/math/polygon.hpp"
#include "lodlab/core/math/trigonometry.hpp"

namespace viz {
namespace {

using Vector3 = lod::Vector<3>;

constexpr double least_ahead = 1e-3;  ///< of the target's distance, for points behind the eye

}  // namespace

CameraAxes axes_of(const Camera& camera) {
    CameraAxes axes;
    axes.forward = (vector3(camera.target) - vector3(camera.eye)).normalized();
    axes.right = axes.forward.cross(vector3(camera.up)).normalized();
    axes.up = axes.right.cross(axes.forward);
    return axes;
}

Camera orbit(const Vector3& target, double distance, double azimuth, double elevation,
             bool perspective) {
    const lod::SineCosine around = lod::sine_cosine(azimuth);
    const lod::SineCosine above = lod::sine_cosine(elevation);
    const Vector3 away(above.cosine * around.sine, above.sine, above.cosine * around.cosine);
    return {point3(target + distance * away), point3(target), {0, 1, 0}, perspective};
}

double magnification(const Camera& camera, const Vector3& point) {
    if (!camera.perspective) return 1;
    const double distance = (vector3(camera.target) - vector3(camera.eye)).norm();
    return distance / std::max(least_ahead * distance, depth_of(camera, point));
}

Point project(const Camera& camera, const Vector3& point) {
    const CameraAxes axes = axes_of(camera);
    const Vector3 from_target = point - vector3(camera.target);
    const double size = magnification(camera, point);
    return {size * from_target.dot(axes.right), size * from_target.dot(axes.up)};
}

double depth_of(const Camera& camera, const Vector3& point) {
    return (point - vector3(camera.eye)).dot(axes_of(camera).forward);
}

std::vector<Ring> outlines_of(const SpaceScene& scene) {
    std::vector<Ring> outlines;
    for (const Facets& facets : scene.facets) {
        if (facets.style.role == Role::ghost) continue;
        std::vector<Point> points;
        for (const Point3& p : facets.surface->outermost) {
            const Vector3 world = vector3(facets.origin) + p.x * vector3(facets.axes[0]) +
                                  p.y * vector3(facets.axes[1]) + p.z * vector3(facets.axes[2]);
            points.push_back(project(scene.camera, world));
        }
        if (points.size() > 2) outlines.push_back(lod::convex_hull(std::move(points), vector2));
    }
    for (const Ball& ball : scene.balls) {
        if (ball.style.role != Role::meeting_node && ball.style.role != Role::true_collision)
            continue;
        const Vector3 centre = vector3(ball.centre);
        const Point at = project(scene.camera, centre);
        const double radius = ball.radius * magnification(scene.camera, centre);
        constexpr int sides = 24;
        Ring& rim = outlines.emplace_back();
        for (int i = 0; i < sides; ++i) {
            const lod::SineCosine way = lod::sine_cosine(2 * std::numbers::pi * i / sides);
            rim.push_back({at.x + radius * way.cosine, at.y + radius * way.sine});
        }
    }
    return outlines;
}

}  // namespace viz
