#include "lodlab/lod3d/solid.hpp"

#include <cmath>

#include "lodlab/core/error.hpp"
#include "lodlab/lod3d/fill.hpp"
#include "lodlab/lod3d/intersect.hpp"

namespace lod3d {
namespace {

std::string counted(long count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void close_gaps(Mesh& mesh, std::vector<std::string>& mended) {
    const auto said = [&](const Welded& welded) {
        if (welded.duplicates > 0)
            mended.emplace_back("dropped " + counted(welded.duplicates, "repeated triangle"));
    };
    said(weld(mesh));
    if (mesh.triangles.empty() || find_bad_edges(mesh).open == 0) return;
    const Box box = bounding_box(mesh);
    Mesh welded = mesh;
    const Welded by_distance = weld(welded, 1e-6 * (box.high - box.low).maxCoeff());
    if (by_distance.vertices == 0 || welded.triangles.empty()) return;
    mended.emplace_back("merged " + counted(by_distance.vertices, "corner") +
                        " within 1e-6 of the size of the mesh");
    said(by_distance);
    mesh = std::move(welded);
}

void turn_alike(Mesh& mesh, std::vector<std::string>& mended) {
    const BadEdges before = find_bad_edges(mesh);
    if (before.reversed == 0) return;
    Mesh turned = mesh;
    const int changed = orient(turned);
    if (find_bad_edges(turned).reversed > 0) return;
    mesh = std::move(turned);
    mended.emplace_back("turned " + counted(changed, "triangle") + " to agree with the neighbours");
}

std::string describe(const BadEdges& bad) {
    std::string text;
    const auto add = [&](int count, const std::string& what) {
        if (count == 0) return;
        text += (text.empty() ? "" : ", ") + counted(count, "edge") + " " + what;
    };
    add(bad.open, "with one triangle only");
    add(bad.crowded, "with triangles that don't pair up");
    add(bad.reversed, "between triangles turned against each other");
    return text;
}

/// How often the surface winds around the space just behind and just before a part.
struct Sides {
    int behind = 0;
    int before = 0;
};

std::vector<Sides> sides_of_parts(const Mesh& mesh, const Parts& parts) {
    std::vector<std::size_t> largest(static_cast<std::size_t>(parts.count));
    std::vector<double> most(static_cast<std::size_t>(parts.count), -1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto part = static_cast<std::size_t>(parts.of_triangle[t]);
        const Point a = mesh.corner(t, 0);
        const double area = (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).norm();
        if (area <= most[part]) continue;
        most[part] = area;
        largest[part] = t;
    }
    const MeshDistance distance(mesh, InsideRule::winding);
    std::vector<Sides> sides;
    for (std::size_t part = 0; part < largest.size(); ++part) {
        const Point a = mesh.corner(largest[part], 0);
        const Point b = mesh.corner(largest[part], 1);
        const Point c = mesh.corner(largest[part], 2);
        const Point off = 1e-5 * std::sqrt(most[part]) * (b - a).cross(c - a).stableNormalized();
        const Point middle = (a + b + c) / 3;
        sides.push_back({static_cast<int>(std::lround(distance.winding_number(middle - off))),
                         static_cast<int>(std::lround(distance.winding_number(middle + off)))});
    }
    return sides;
}

/// Turns parts that are inside-out. Returns whether some parts overlap.
bool turn_outwards(Mesh& mesh, std::vector<std::string>& mended) {
    const Parts parts = find_parts(mesh);
    const std::vector<Sides> sides = sides_of_parts(mesh, parts);
    long turned = 0;
    bool overlapping = parts.count > 1 && parts_intersect(mesh, parts);
    for (const Sides& side : sides) {
        if (side.behind == 0 && side.before == -1)
            ++turned;
        else if (side.behind != 1 || side.before != 0)
            overlapping = true;
    }
    if (turned == 0) return overlapping;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Sides& side = sides[static_cast<std::size_t>(parts.of_triangle[t])];
        if (side.behind == 0 && side.before == -1)
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
    mended.emplace_back(parts.count == 1
                            ? "turned the surface, which was inside-out"
                            : "turned " + counted(turned, "part") + " of " +
                                  std::to_string(parts.count) + ", which stood inside-out");
    return overlapping;
}

}  // namespace

Solid make_solid(std::string name, Mesh mesh, const SolidOptions& options) {
    try {
        check_numbers(mesh);
    } catch (const lod::Error& error) {
        lod::refuse_input(name, error.what());
    }
    Solid solid;
    solid.name = std::move(name);
    close_gaps(mesh, solid.mended);
    if (mesh.triangles.empty())
        lod::refuse_input(solid.name, "every triangle has two equal corners");
    turn_alike(mesh, solid.mended);

    const BadEdges bad = find_bad_edges(mesh);
    if (!bad.none() && !options.fill)
        lod::refuse_input(solid.name, "the mesh does not bound a solid: " + describe(bad) +
                                          "; mend it, or fill it by winding number (option fill)");
    if (!bad.none()) {
        mesh = fill_by_winding(mesh, options.fill_cells);
        solid.approximate = true;
        solid.mended.emplace_back("filled by winding number: " + describe(bad));
    }
    const bool overlapping = turn_outwards(mesh, solid.mended);
    Integrals of = integrate(mesh);
    const Box box = bounding_box(mesh);
    const double longest = box.size().maxCoeff();
    if (!(of.volume > 1e-12 * longest * longest * longest))
        lod::refuse_input(solid.name, "the mesh bounds no volume; is it flat?");
    if (overlapping) {
        of = integrate(fill_by_winding(mesh, options.fill_cells));
        solid.approximate = true;
        solid.inside_rule = InsideRule::winding;
        solid.mended.emplace_back(
            "parts touch or overlap: volume, centre and inertia are of their union on a grid");
    }
    for (Point& p : mesh.vertices) p -= of.centroid;
    solid.mesh = std::move(mesh);
    solid.volume = of.volume;
    solid.centroid = of.centroid;
    solid.second_moment = of.inertia;
    return solid;
}

}  // namespace lod3d
