#include "lodlab/viz/space.hpp"

#include <algorithm>
#include <numbers>
#include <set>

#include "lodlab/core/trigonometry.hpp"

namespace viz {
namespace {

using Vector3 = lod::Vector<3>;

constexpr double smooth_cosine = 0.766;  ///< 40 degrees: faces that turn more meet in a sharp edge
constexpr double least_ahead = 1e-3;     ///< of the target's distance, for points behind the eye
constexpr int extreme_directions = 7;    ///< steps along each side of a cube of directions

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

std::vector<Vector3> face_normals(const lod3d::Mesh& mesh) {
    std::vector<Vector3> normals;
    normals.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vector3 a = mesh.corner(t, 0);
        normals.push_back((mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a));
    }
    return normals;  // twice the area long: large faces weigh more
}

/// For each corner the mean normal of the faces round its vertex that turn little against its own.
void find_normals(const lod3d::Mesh& mesh, const std::vector<Vector3>& faces, Surface& surface) {
    std::vector<std::vector<int>> round(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int corner : mesh.triangles[t])
            round[index(corner)].push_back(static_cast<int>(t));
    surface.normals.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const double own = faces[t].norm();
        for (std::size_t k = 0; k < 3; ++k) {
            Vector3 sum = Vector3::Zero();
            for (const int other : round[index(mesh.triangles[t][k])]) {
                const Vector3& normal = faces[index(other)];
                if (normal.dot(faces[t]) >= smooth_cosine * own * normal.norm()) sum += normal;
            }
            const double length = sum.norm();
            surface.normals[t][k] = point3(length > 0 ? Vector3(sum / length) : Vector3::UnitY());
        }
    }
}

void find_edges(const lod3d::Mesh& mesh, const std::vector<Vector3>& faces, Surface& surface) {
    std::vector<Surface::Edge> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] =
                std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
            sides.push_back({low, high, static_cast<int>(t), -1, true});
        }
    std::sort(sides.begin(), sides.end(), [](const Surface::Edge& a, const Surface::Edge& b) {
        return std::tie(a.from, a.to, a.left) < std::tie(b.from, b.to, b.left);
    });
    for (Surface::Edge side : sides) {
        if (!surface.edges.empty() && surface.edges.back().right < 0 &&
            surface.edges.back().from == side.from && surface.edges.back().to == side.to) {
            Surface::Edge& edge = surface.edges.back();
            edge.right = side.left;
            const Vector3& a = faces[index(edge.left)];
            const Vector3& b = faces[index(edge.right)];
            edge.sharp = a.dot(b) < smooth_cosine * a.norm() * b.norm();
        } else {
            surface.edges.push_back(side);
        }
    }
}

/// The vertices that lie furthest out in directions all over a cube.
void find_outermost(const lod3d::Mesh& mesh, Surface& surface) {
    std::set<std::size_t> found;
    constexpr int steps = extreme_directions;
    for (int i = 0; i < steps * steps * steps; ++i) {
        const int x = 2 * (i % steps) - steps + 1;
        const int y = 2 * (i / steps % steps) - steps + 1;
        const int z = 2 * (i / steps / steps) - steps + 1;
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) != steps - 1) continue;
        const Vector3 direction(x, y, z);
        const auto furthest = std::max_element(mesh.vertices.begin(), mesh.vertices.end(),
                                               [&](const Vector3& a, const Vector3& b) {
                                                   return a.dot(direction) < b.dot(direction);
                                               });
        found.insert(static_cast<std::size_t>(furthest - mesh.vertices.begin()));
    }
    for (const std::size_t i : found) surface.outermost.push_back(surface.vertices[i]);
}

/// The convex hull, by Andrew's chains.
Ring hull_of(std::vector<Point> points) {
    std::sort(points.begin(), points.end(),
              [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    Ring hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t start = hull.size();
        for (const Point& p : points) {
            const auto turns_right = [&] {
                const Point& a = hull[hull.size() - 2];
                const Point& b = hull.back();
                return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) <= 0;
            };
            while (hull.size() >= start + 2 && turns_right()) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // the next side begins there
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

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
        if (points.size() > 2) outlines.push_back(hull_of(std::move(points)));
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

Surface surface_of(const lod3d::Mesh& mesh) {
    Surface surface;
    surface.vertices.reserve(mesh.vertices.size());
    for (const Vector3& v : mesh.vertices) surface.vertices.push_back(point3(v));
    surface.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
    const std::vector<Vector3> faces = face_normals(mesh);
    find_normals(mesh, faces, surface);
    find_edges(mesh, faces, surface);
    find_outermost(mesh, surface);
    return surface;
}

}  // namespace viz
