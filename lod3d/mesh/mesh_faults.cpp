#include "lodlab/lod3d/mesh/mesh_faults.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <tuple>

#include "lodlab/core/base/to_chars.hpp"

namespace lod3d {
namespace {

/// The normal of the largest triangle and a corner of it.
std::pair<Point, Point> widest_plane(const Mesh& mesh) {
    Point widest = Point::Zero();
    Point corner = Point::Zero();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Point a = mesh.corner(t, 0);
        const Point area = (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a);
        if (!(area.norm() > widest.norm())) continue;
        widest = area;
        corner = a;
    }
    return {widest.stableNormalized(), corner};
}

}  // namespace

std::string in_digits(double value, int digits) {
    return lod::number_text(value, std::chars_format::general, digits);
}

std::string place_in_words(const Point& p) {
    std::string text = "(";
    for (int d = 0; d < 3; ++d) {
        if (d > 0) text += ", ";
        text += in_digits(p[d], 10);
    }
    return text + ")";
}

std::string counted(long count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string describe(const BadEdges& bad, const Mesh& mesh, const Point& moved) {
    std::string text;
    const auto add = [&](int count, const std::string& what) {
        if (count == 0) return;
        text += (text.empty() ? "" : ", ") + counted(count, "edge") + " " + what;
    };
    add(bad.open, "with one triangle only");
    add(bad.crowded, "with triangles that don't pair up");
    add(bad.reversed, "between triangles turned against each other");
    if (bad.none()) return text;
    const auto end = [&](std::size_t which) {
        return place_in_words(mesh.vertices[static_cast<std::size_t>(bad.first[which])] + moved);
    };
    return text + ", the first from " + end(0) + " to " + end(1);
}

bool is_flat(const Mesh& mesh) {
    constexpr double flat = 1e-9;  // of the size
    const auto [normal, corner] = widest_plane(mesh);
    double thickness = 0;
    for (const Point& p : mesh.vertices)
        thickness = std::max(thickness, std::abs(normal.dot(p - corner)));
    return thickness <= flat * bounding_box(mesh).size().maxCoeff();
}

bool bounds_volume(const Mesh& mesh) {
    const Point origin = mesh.corner(0, 0);
    double sum = 0;
    double sum_of_sizes = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Point a = mesh.corner(t, 0) - origin;
        const Point b = mesh.corner(t, 1) - origin;
        const double volume = a.cross(b).dot(mesh.corner(t, 2) - origin);
        sum += volume;
        sum_of_sizes += std::abs(volume);
    }
    const double longest = bounding_box(mesh).size().maxCoeff();
    return std::abs(sum) > 1e-9 * sum_of_sizes &&
           sum_of_sizes > 1e-13 * longest * longest * longest;
}

std::string why_no_volume(const Mesh& mesh, const Point& moved, const std::string& what) {
    if (is_flat(mesh))
        return what + " bounds no volume: it is flat, all of it lies in one plane through " +
               place_in_words(widest_plane(mesh).second + moved) + "; give it a thickness";
    return what +
           " bounds no volume, though it is not flat: its faces cross each other, or lie "
           "doubled on each other, so that what some enclose others take away; unite them, or "
           "divide the mesh where it crosses itself";
}

namespace {

/// Triangles that lie back to back, two and two: the earlier and the later one. Those turned alike
/// were dropped before.
std::vector<std::array<std::size_t, 2>> back_to_back(const Mesh& mesh) {
    std::vector<Triangle> key = mesh.triangles;
    for (Triangle& t : key) std::sort(t.begin(), t.end());
    std::vector<std::size_t> order(key.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return std::tie(key[i], i) < std::tie(key[j], j);
    });
    std::vector<std::array<std::size_t, 2>> pairs;
    for (std::size_t i = 0; i + 1 < order.size(); ++i)
        if (key[order[i]] == key[order[i + 1]]) {
            pairs.push_back({order[i], order[i + 1]});
            ++i;
        }
    return pairs;
}

int drop(const std::vector<std::size_t>& triangles, Mesh& mesh) {
    std::vector<char> dropped(mesh.triangles.size(), 0);
    for (const std::size_t t : triangles) dropped[t] = 1;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (dropped[t] == 0) mesh.triangles[kept++] = mesh.triangles[t];
    mesh.triangles.resize(kept);
    return static_cast<int>(triangles.size());
}

}  // namespace

int drop_other_sides(Mesh& mesh) {
    const auto pairs = back_to_back(mesh);
    if (pairs.empty()) return 0;
    const Parts parts = find_parts(mesh);
    const auto part_of = [&](std::size_t t) {
        return static_cast<std::size_t>(parts.of_triangle[t]);
    };
    std::vector<std::size_t> unpaired(static_cast<std::size_t>(parts.count), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) ++unpaired[part_of(t)];
    for (const auto& pair : pairs) unpaired[part_of(pair[0])] -= 2;
    std::vector<Mesh> single(unpaired.size());  // what is left of each part that is all pairs
    for (const auto& pair : pairs)
        if (unpaired[part_of(pair[0])] == 0)
            single[part_of(pair[0])].triangles.push_back(mesh.triangles[pair[0]]);
    // A sheet beside something else bounds nothing: it is an inner wall.
    const bool all = 2 * pairs.size() == mesh.triangles.size();
    std::vector<char> bounds(unpaired.size(), 0);
    for (std::size_t part = 0; part < single.size(); ++part)
        bounds[part] = unpaired[part] == 0 && (all || find_bad_edges(single[part]).open == 0);
    std::vector<std::size_t> later;
    for (const auto& pair : pairs)
        if (bounds[part_of(pair[0])] != 0) later.push_back(pair[1]);
    return drop(later, mesh);
}

int drop_inner_walls(Mesh& mesh) {
    const auto pairs = back_to_back(mesh);
    if (2 * pairs.size() == mesh.triangles.size()) return 0;
    std::vector<std::size_t> both;
    for (const auto& pair : pairs) both.insert(both.end(), pair.begin(), pair.end());
    return drop(both, mesh);
}

}  // namespace lod3d
