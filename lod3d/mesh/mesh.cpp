#include "lodlab/lod3d/mesh/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/lod3d/mesh/merge_points.hpp"

namespace lod3d {

bool is_usable(const Point& p) {
    return p.allFinite() && p.cwiseAbs().maxCoeff() <= 1e100;
}

Box bounding_box(const Mesh& mesh) {
    Box box;
    for (const Point& p : mesh.vertices) box.hold(p);
    return box;
}

void check_numbers(const Mesh& mesh) {
    const auto refuse = [](const std::string& why) {
        throw lod::Error(lod::ErrorKind::input_refused, why);
    };
    if (mesh.triangles.empty()) refuse("the mesh has no triangles");
    const auto count = static_cast<std::int32_t>(mesh.vertices.size());
    std::int64_t astray = 0;
    for (const Triangle& t : mesh.triangles)
        astray +=
            std::count_if(t.begin(), t.end(), [&](std::int32_t v) { return v < 0 || v >= count; });
    if (astray > 0)
        refuse(std::to_string(astray) + " vertex numbers are out of range; the mesh has " +
               std::to_string(count) + " vertices");
    std::vector<char> bad(mesh.vertices.size(), 0);
    for (const Triangle& t : mesh.triangles)
        for (const std::int32_t v : t) bad[lod::at(v)] = !is_usable(mesh.vertices[lod::at(v)]);
    const auto first = std::find(bad.begin(), bad.end(), 1);
    if (first != bad.end())
        refuse(std::to_string(std::count(first, bad.end(), 1)) + " of " + std::to_string(count) +
               " vertices are not finite or beyond 1e100, the first is number " +
               std::to_string(first - bad.begin()) + ", counted from 0; mend their coordinates");
}

namespace {

/// The triangle with its least vertex first, turned the same way.
Triangle from_least(Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

int drop_duplicates(Mesh& mesh) {
    std::vector<std::int32_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<Triangle> key(mesh.triangles.size());
    std::transform(mesh.triangles.begin(), mesh.triangles.end(), key.begin(), from_least);
    std::sort(order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) {
        return std::tie(key[lod::at(i)], i) < std::tie(key[lod::at(j)], j);
    });
    std::vector<char> again(mesh.triangles.size(), 0);
    for (std::size_t i = 1; i < order.size(); ++i)
        again[lod::at(order[i])] = key[lod::at(order[i])] == key[lod::at(order[i - 1])];
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (!again[t]) mesh.triangles[kept++] = mesh.triangles[t];
    const std::size_t dropped = mesh.triangles.size() - kept;
    mesh.triangles.resize(kept);
    return static_cast<int>(dropped);
}

}  // namespace

int drop_unused_vertices(Mesh& mesh) {
    std::vector<std::int32_t> renumbered(mesh.vertices.size(), -1);
    for (const Triangle& t : mesh.triangles)
        for (std::int32_t v : t) renumbered[lod::at(v)] = 0;
    std::int32_t kept = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (renumbered[v] < 0) continue;
        mesh.vertices[lod::at(kept)] = mesh.vertices[v];
        renumbered[v] = kept++;
    }
    const int dropped = static_cast<int>(mesh.vertices.size()) - kept;
    mesh.vertices.resize(lod::at(kept));
    for (Triangle& t : mesh.triangles)
        for (std::int32_t& v : t) v = renumbered[lod::at(v)];
    return dropped;
}

Welded weld(Mesh& mesh, double tolerance) {
    const int unused = drop_unused_vertices(mesh);  // they may hold what has no order
    const std::vector<std::int32_t> into = merge_points(mesh.vertices, tolerance).into;
    for (Triangle& t : mesh.triangles)
        for (std::int32_t& v : t) v = into[lod::at(v)];
    const auto collapsed = std::erase_if(mesh.triangles, [](const Triangle& t) {
        return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    });
    Welded result;
    result.collapsed = static_cast<int>(collapsed);
    result.duplicates = drop_duplicates(mesh);
    result.vertices = unused + drop_unused_vertices(mesh);
    return result;
}

Integrals integrate(const Mesh& mesh) {
    const Box box = bounding_box(mesh);
    const Point origin = 0.5 * (box.low + box.high);  // near by, so that little cancels
    double volume = 0;
    Point first = Point::Zero();
    lod::Matrix<3> second = lod::Matrix<3>::Zero();  // of x x^T
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Point a = mesh.corner(t, 0) - origin;
        const Point b = mesh.corner(t, 1) - origin;
        const Point c = mesh.corner(t, 2) - origin;
        const Point sum = a + b + c;
        const double six_volumes = a.dot(b.cross(c));  // of the tetrahedron with the origin
        volume += six_volumes / 6;
        first += (six_volumes / 24) * sum;
        second += (six_volumes / 120) * (a * a.transpose() + b * b.transpose() + c * c.transpose() +
                                         sum * sum.transpose());
    }
    Integrals result;
    result.volume = volume;
    if (volume == 0) return result;
    const Point arm = first / volume;
    second -= volume * arm * arm.transpose();
    result.centroid = origin + arm;
    result.inertia = second.trace() * lod::Matrix<3>::Identity() - second;
    return result;
}

void flip(Mesh& mesh) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace lod3d
